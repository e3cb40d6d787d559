using System;
using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>A coefficient in many frames, and the law that it follows.</summary>
    internal sealed class Samples
    {
        /// <summary>What a coefficient may depart from its law by.</summary>
        private const double Tolerance = 2e-3;

        private readonly List<KeyValuePair<Observation, double>> _values = new List<KeyValuePair<Observation, double>>();

        public int Count => _values.Count;

        public double Median => Coefficients.Median(_values.Select(v => v.Value));

        public void Add(Observation o, double value) => _values.Add(new KeyValuePair<Observation, double>(o, value));

        /// <summary>The share of frames in which the coefficient is what the law says.</summary>
        public double Share(Func<Observation, double> law) =>
            Count == 0 ? 0 : _values.Count(v => Math.Abs(v.Value - law(v.Key)) <= Tolerance * Math.Abs(law(v.Key)) + 1e-6) / (double)Count;

        public bool Follow(Func<Observation, double> law) => Count > 0 && Share(law) > 0.9;

        /// <summary>One number in all frames.</summary>
        public bool IsConstant => Follow(_ => Median);

        /// <summary>The samples divided by what they should be.</summary>
        public Samples Over(Func<Observation, double> law)
        {
            Samples ratios = new Samples();
            foreach (KeyValuePair<Observation, double> v in _values)
                ratios.Add(v.Key, v.Value / law(v.Key));
            return ratios;
        }
    }
}
