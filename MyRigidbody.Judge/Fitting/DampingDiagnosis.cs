using System;
using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>How a script damps instead of v ← 0.98 v, ω ← 0.98 ω.</summary>
    internal sealed class DampingDiagnosis
    {
        private readonly Explanation _explanation;
        private readonly Samples _v;
        private readonly Samples _w;

        public DampingDiagnosis(Explanation explanation)
        {
            _explanation = explanation;
            _v = Decays(explanation.Velocity, _ => true);
            _w = Decays(explanation.AngularVelocity, _ => true);
        }

        /// <summary>Neither velocity is damped.</summary>
        public bool IsMissing => IsOne(_v) && IsOne(_w);

        public IEnumerable<Finding> Findings()
        {
            string code = IsMissing ? "not-done" : Factors();
            string found = $"v {Describe(_v)}, ω {Describe(_w)}";
            Finding finding = Words.Finding(Step.Damping, code, "0.98", found);
            yield return code == "damping-as-rate" ? finding.ForInstructor() : finding;
        }

        private static bool IsOne(Samples s) => s.Count == 0 || s.Follow(_ => 1);

        private static bool IsRight(Samples s) => s.Count == 0 || s.Follow(_ => Sheet.Decay);

        private string Factors()
        {
            bool v = !_explanation.Velocity.DecayIsRight, w = !_explanation.AngularVelocity.DecayIsRight;
            if (!v && !w)
                return "damped-before-moving";
            Samples[] off = new[] { v ? _v : null, w ? _w : null }.Where(s => s != null).ToArray();
            if (off.All(s => s.Follow(_ => Sheet.Decay * Sheet.Decay)))
                return "damped-twice";
            if (v && !w && IsOne(_v))
                return "v-not-damped";
            if (w && !v && IsOne(_w))
                return "w-not-damped";
            if (OnlyWhere(pushed: false))
                return "damped-only-when-let-go";
            if (OnlyWhere(pushed: true))
                return "damped-only-when-pushed";
            if (off.All(s => s.Follow(o => Sheet.Decay * _explanation.Step.At(o))))
                return "damping-times-dt";
            if (IsRate(v, w))
                return "damping-as-rate";
            if (off.All(s => s.Follow(_ => 0.02)))
                return "damped-by-the-loss";
            if (off.Any(IsRight))
                return "damped-sometimes";
            return off.All(s => s.IsConstant) ? "other-factor" : "damping-formula";
        }

        /// <summary>True for 0.98 at 50 frames a second, or e^(−Δt), with the same factor in all frames of one length.</summary>
        private bool IsRate(bool v, bool w)
        {
            return (!v || IsRate(_explanation.Velocity)) && (!w || IsRate(_explanation.AngularVelocity));
        }

        private bool IsRate(Chain chain)
        {
            Samples usual = Decays(chain, l => Math.Abs(l.At.Delta - FrameInput.FixedDelta) < 1e-6);
            Samples all = Decays(chain, _ => true);
            double h = FrameInput.FixedDelta;
            if (!usual.Follow(_ => Sheet.Decay) && !usual.Follow(_ => Math.Exp(-_explanation.Step.At(chain.Links[0].At))))
                return false;
            return all.Follow(o => Math.Pow(Sheet.Decay, o.Delta / h)) || all.Follow(o => 1 - (1 - Sheet.Decay) * o.Delta / h) || all.Follow(o => Math.Exp(-o.Delta))
                || all.Follow(o => 1 / (1 + o.Delta)) || (usual.IsConstant && all.IsConstant && !usual.Follow(_ => Sheet.Decay));
        }

        private bool OnlyWhere(bool pushed)
        {
            return Only(_explanation.Velocity, pushed) && Only(_explanation.AngularVelocity, pushed);
        }

        private static bool Only(Chain chain, bool pushed)
        {
            if (chain.DecayIsRight)
                return true;
            Samples damped = Decays(chain, l => (l.Gain.Length > 1e-6) == pushed), free = Decays(chain, l => (l.Gain.Length > 1e-6) != pushed);
            return damped.Follow(_ => Sheet.Decay) && free.Follow(_ => 1);
        }

        private static Samples Decays(Chain chain, Func<Link, bool> where)
        {
            Samples samples = new Samples(1e-4);
            for (int i = 0; i < chain.Links.Length; i++)
            {
                if (!double.IsNaN(chain.DecayOf(i)) && chain.Links[i].Before.Length > 0.05 && where(chain.Links[i]))
                    samples.Add(chain.Links[i].At, chain.DecayOf(i));
            }

            return samples;
        }

        private static string Describe(Samples s) => s.Count == 0 ? "?" : Text.Of(s.Median);
    }
}
