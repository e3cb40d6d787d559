using System;
using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>What a script uses for Δt: the frame's own length, or one number.</summary>
    internal sealed class TimeStep
    {
        /// <summary>The longest frame of a sheet, s: a larger constant is not a time step.</summary>
        private const double Longest = 0.1;

        private readonly double? _constant;

        private TimeStep(double? constant) => _constant = constant;

        public static TimeStep OfFrame { get; } = new TimeStep(null);

        public static TimeStep Usual { get; } = new TimeStep(FrameInput.FixedDelta);

        public static IReadOnlyList<TimeStep> Both { get; } = new[] { OfFrame, Usual };

        public double At(Observation o) => _constant ?? (float)o.Delta;

        /// <summary>The two usual ones first, then those that the coefficients of the steps suggest.</summary>
        public static IReadOnlyList<TimeStep> Candidates(IEnumerable<double> coefficients)
        {
            List<double> constants = new List<double>();
            foreach (double c in coefficients.SelectMany(c => new[] { c, c / Sheet.Decay }))
            {
                if (c > 1e-5 && c <= Longest && constants.Concat(new[] { FrameInput.FixedDelta }).All(known => Math.Abs(c / known - 1) > 1e-4))
                    constants.Add(c);
            }

            return Both.Concat(constants.Select(c => new TimeStep(c))).ToArray();
        }

        public override string ToString() => _constant.HasValue ? Text.Of(_constant.Value) + " s" : "Time.deltaTime";
    }

    /// <summary>The numbers of the sheet.</summary>
    internal static class Sheet
    {
        /// <summary>The factor of v and ω once a step.</summary>
        public const double Decay = 0.98;
    }
}
