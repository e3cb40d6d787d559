using System;

namespace RigidBodyDynamics.Judging
{
    /// <summary>How a frame differs from v′ = 0.98 (v + Δt g), where g is F/m, or I⁻¹τ for the angular velocity.</summary>
    internal enum Miss
    {
        None,

        /// <summary>The gain is not Δt g.</summary>
        Gain,

        /// <summary>The factor is not 0.98.</summary>
        Decay,

        /// <summary>One of the two, because v and g have one direction.</summary>
        Either,

        Both,

        /// <summary>The frame shows nothing.</summary>
        Unseen,
    }

    /// <summary>A velocity in one frame: before, after, and its expected gain in a second.</summary>
    internal readonly struct Link
    {
        private readonly double _size;
        private readonly double _gained;

        public Link(Observation at, Vector before, Vector after, Vector gain)
        {
            At = at;
            Before = before;
            After = after;
            Gain = gain;
            _size = before.Length + after.Length;
            _gained = gain.Length;
        }

        private Link(in Link link, Vector gain)
        {
            this = link;
            Gain = gain;
            _gained = gain.Length;
        }

        public Observation At { get; }

        public Vector Before { get; }

        public Vector After { get; }

        public Vector Gain { get; }

        /// <summary>False for a gain of zero, which has only one reading.</summary>
        public bool IsPushed => _gained != 0;

        /// <summary>The same frame with another reading of its gain.</summary>
        public Link With(Vector gain) => new Link(this, gain);

        /// <summary>The largest effect of rounding in single precision on the velocity.</summary>
        public double Tolerance(double h) => 3e-6 * _size + 3e-5 * h * _gained + 1e-7;
    }

    /// <summary>One frame compared with the sheet's formula, and its actual coefficients.</summary>
    internal struct Match
    {
        /// <summary>A velocity that grows by more than half in a frame is not wrongly damped: something is added to it.</summary>
        private const double MostKept = 1.5;

        private readonly double _keptOfTwo;

        public Match(in Link link, double h, Order order) : this()
        {
            Decay = double.NaN;
            Miss = Miss.Unseen;
            if (!link.Before.IsFinite || !link.Gain.IsFinite)
                return;
            Miss = Miss.Gain;
            if (!link.After.IsFinite)
                return;
            double tolerance = link.Tolerance(h);
            Vector gain = h * link.Gain;
            Vector left = order == Order.GainThenDecay ? link.After : order == Order.DecayThenGain ? link.After - gain : link.After - Sheet.Decay * gain;
            Vector of = order == Order.GainThenDecay ? link.Before + gain : link.Before;
            IsFree = gain.Length < 1e-7;
            bool isTooSlow = of.Length <= 20 * tolerance && left.Length <= 40 * tolerance;
            if (isTooSlow)
                Miss = Miss.Unseen;
            double off = (left - Sheet.Decay * of).Length;
            if (isTooSlow && off > tolerance)
                return;
            if (off <= tolerance)
            {
                Miss = Miss.None;
                Decay = Sheet.Decay;
                return;
            }

            Coefficients one = Coefficients.Of(left, of);
            bool isDecayAlone = of.Length > 20 * tolerance && one.Residual <= tolerance && one.First > 1e-3 && one.First < MostKept;
            if (isDecayAlone)
            {
                Miss = Miss.Decay;
                Decay = one.First;
            }

            if (IsFree)
                return;
            Coefficients two = Coefficients.Of(link.After, link.Before, link.Gain);
            bool canTell = two.Spread > 0.05 * link.Gain.Length && two.Spread > 0.05 * link.Before.Length && two.Spread > 1e-3;
            if (canTell)
            {
                HasTwo = !isDecayAlone;
                FitsTwo = two.Residual <= tolerance;
                _keptOfTwo = two.First;
            }
            else if (isDecayAlone)
            {
                Miss = Miss.Either;
            }
        }

        public Miss Miss { get; private set; }

        /// <summary>The factor of step 5 in this frame; NaN where it cannot be determined.</summary>
        public double Decay { get; private set; }

        public bool IsOff => Miss != Miss.None && Miss != Miss.Unseen;

        /// <summary>True if other frames have shown that the gain is wrong, and not the factor.</summary>
        public bool IsBlamed { get; private set; }

        /// <summary>True if no force acts in this frame: only the factor is visible.</summary>
        public bool IsFree { get; }

        /// <summary>True if gain and decay can be separated.</summary>
        public bool HasTwo { get; private set; }

        /// <summary>True if the frame is the sum of a multiple of v and a multiple of g.</summary>
        public bool FitsTwo { get; }

        public void Resolve(bool isLinear, double decayWhereFree)
        {
            bool isAnotherFactor = isLinear && FitsTwo && _keptOfTwo > 1e-3 && _keptOfTwo < MostKept && Math.Abs(_keptOfTwo - Sheet.Decay) > 1e-3;
            Miss = isAnotherFactor ? Miss.Both : Miss.Gain;
            Decay = isAnotherFactor ? _keptOfTwo : decayWhereFree;
        }

        public void Blame(Miss miss, double decayWhereFree)
        {
            IsBlamed |= Miss == Miss.Decay && miss == Miss.Gain;
            Miss = miss;
            if (miss == Miss.Gain)
                Decay = decayWhereFree;
        }

        public void Forget()
        {
            Miss = Miss.Unseen;
            Decay = double.NaN;
            HasTwo = false;
        }
    }
}
