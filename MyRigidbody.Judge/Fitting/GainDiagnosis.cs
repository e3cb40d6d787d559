using System;
using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>What a script adds to v or ω instead of Δt F/m or Δt I⁻¹τ.</summary>
    internal sealed class GainDiagnosis
    {
        /// <summary>A later form has to fit more by this share of the frames.</summary>
        private const double BetterBy = 1e-3;

        private static readonly Source[] Sources = { Source.Variable, Source.Demanded };

        private readonly Chain _chain;
        private readonly bool _ofForce;
        private GainShape _shape;
        private Samples _gains;
        private Samples _kept;
        private double _share = -1;

        public GainDiagnosis(Chain chain, bool ofForce)
        {
            _chain = chain;
            _ofForce = ofForce;
            foreach (Source source in Sources)
            {
                foreach (GainShape shape in ofForce ? GainShape.OfForce : GainShape.OfTorque)
                    Try(shape, source);
            }
        }

        /// <summary>True if nothing is added.</summary>
        public bool IsMissing => _share > 0.9 && _gains.Follow(_ => 0);

        public IEnumerable<Finding> Findings()
        {
            Step step = _ofForce ? Step.Velocity : Step.AngularVelocity;
            string expected = _ofForce ? "Δv = Δt F/m" : "Δω = Δt (R I_ref Rᵀ)⁻¹ τ", letter = _ofForce ? "v" : "w";
            if (BecomesNaN())
                return One(step, letter + "-not-a-number", expected, "NaN");
            if (IsMissing)
                return One(step, "not-done", expected, "0");
            if (_chain.IsLimited)
                return One(step, letter + "-limited", expected, Example());
            if (_share < 0.9)
                return One(step, letter + (IsSeldom() ? "-sometimes" : "-formula"), expected, Example());
            List<Finding> findings = new List<Finding>();
            string factor = FactorCode(letter);
            string found = $"{Text.Of(_gains.Median)} · {_shape.Formula}";
            if (_shape.Code != null)
                findings.Add(Words.Finding(step, _shape.Code, expected, found));
            if (factor != null)
                findings.Add(Words.Finding(step, factor, expected, found));
            return findings.Count > 0 ? findings.ToArray() : One(step, letter + (IsSeldom() ? "-sometimes" : "-formula"), expected, found);
        }

        private static Finding[] One(Step step, string code, string expected, string found) => new[] { Words.Finding(step, code, expected, found) };

        /// <summary>What the script has in place of Δt; null where it is Δt.</summary>
        private string FactorCode(string letter)
        {
            Func<Observation, double> h = _chain.Step.At;
            if (_kept.Follow(_ => 0))
                return letter + "-assigned";
            if (_gains.Follow(h))
                return null;
            if (_gains.Follow(o => -h(o)))
                return letter + "-sign";
            if (_gains.Follow(_ => 1))
                return letter + "-no-dt";
            if (_gains.Follow(o => o.Time))
                return "time-for-dt";
            if (_gains.Follow(o => o.Time - o.Delta))
                return "time-for-dt";
            if (_ofForce && _gains.Follow(o => h(o) * o.Mass * o.Mass))
                return "mass-multiplied";
            if (_gains.Follow(o => h(o) * o.Mass))
                return _ofForce ? "mass-not-used" : letter + "-mass-multiplied";
            if (_gains.Follow(o => h(o) / o.Mass))
                return _ofForce ? "mass-twice" : letter + "-mass-divided";
            if (_gains.Follow(o => h(o) * h(o)))
                return letter + "-dt-twice";
            if (TimeStep.Both.Any(other => _gains.Follow(other.At)))
                return "two-time-steps";
            if (_gains.Follow(o => 1 * o.Mass) || _gains.Follow(o => o.Mass * o.Mass))
                return letter + "-no-dt";
            return letter + "-factor";
        }

        private void Try(GainShape shape, Source source)
        {
            // no other form can fit more
            if (_share >= 1 - BetterBy)
                return;
            Samples gains = new Samples(2e-3), kept = new Samples(2e-3);
            int fitted = 0, seen = 0;
            for (int i = 0; i < _chain.Links.Length; i++)
            {
                Link link = _chain.Links[i];
                Vector push = _ofForce ? link.At.Force(source) : link.At.Torque(source);
                if (!link.At.IsVaried || push.Length < 0.1 || !link.Before.IsFinite || !link.After.IsFinite || link.Before.Length > 1e4)
                    continue;
                Vector gain = shape.Gain(link.At, push);
                Coefficients two = Coefficients.Of(link.After, link.Before, gain);
                if (!(two.Spread > 0.05 * link.Before.Length) || !(two.Spread > 0.02))
                    continue;
                seen++;
                if (two.Residual > 2 * link.Tolerance(Math.Abs(two.Second)))
                    continue;
                fitted++;
                // where the old velocity is not kept, the gain still contains the factor of step 5
                gains.Add(link.At, two.Second / (_chain.DecaysFirst ? 1 : Math.Abs(two.First) < 1e-3 ? Sheet.Decay : two.First));
                kept.Add(link.At, Math.Abs(two.First) < 1e-3 ? 0 : two.First);
            }

            double share = seen < 10 ? 0 : fitted / (double)seen;
            if (share <= _share + BetterBy)
                return;
            _share = share;
            _shape = shape;
            _gains = gains;
            _kept = kept;
        }

        private bool BecomesNaN() => _chain.Links.Any(l => l.Before.IsFinite && l.Before.Length < 1e6 && !l.After.IsFinite);

        private bool IsSeldom()
        {
            int missed = Enumerable.Range(0, _chain.Links.Length).Count(i => _chain.MissOf(i) == Miss.Gain);
            return missed < _chain.Links.Length / 50;
        }

        private string Example()
        {
            int i = _chain.First(Miss.Gain, Miss.Both) ?? 0;
            Link link = _chain.Links[i];
            return Text.Of((1 / Sheet.Decay) * link.After - link.Before);
        }
    }
}
