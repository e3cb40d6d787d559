using System;
using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>A coefficient in many frames, and the law that it obeys.</summary>
    internal sealed class Samples
    {
        private readonly List<KeyValuePair<Observation, double>> _values = new List<KeyValuePair<Observation, double>>();

        private readonly double _tolerance;

        /// <param name="tolerance">The difference between a coefficient and its law that roundings allow.</param>
        public Samples(double tolerance) => _tolerance = tolerance;

        public int Count => _values.Count;

        public double Median => Coefficients.Median(_values.Select(v => v.Value));

        public void Add(Observation o, double value) => _values.Add(new KeyValuePair<Observation, double>(o, value));

        /// <summary>The share of frames in which the coefficient obeys a law.</summary>
        public double Share(Func<Observation, double> law) =>
            Count == 0 ? 0 : _values.Count(v => Math.Abs(v.Value - law(v.Key)) <= _tolerance * Math.Abs(law(v.Key)) + 1e-6) / (double)Count;

        public bool Follow(Func<Observation, double> law) => Count > 0 && Share(law) > 0.9;

        /// <summary>True if the coefficient is the same in all frames.</summary>
        public bool IsConstant
        {
            get
            {
                double median = Median;
                return Follow(_ => median);
            }
        }
    }
}
