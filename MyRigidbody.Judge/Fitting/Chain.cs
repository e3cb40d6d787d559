using System;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>A velocity through all frames, compared with the sheet's steps 1 and 5 (or 2 and 5) for one Δt.</summary>
    internal sealed class Chain
    {
        private readonly Match[] _matches;

        public Chain(Links links, TimeStep step, Order order)
        {
            Reading = links.Number;
            Source = links.Source;
            Code = links.Code;
            Links = links.All;
            Step = step;
            Order = order;
            _matches = new Match[Links.Length];
            for (int i = 0; i < Links.Length; i++)
                _matches[i] = Links[i].IsPushed ? new Match(Links[i], step.At(Links[i].At), order) : links.Unpushed[i];
            ForgiveWhatWasKept();
            Resolve();
            GainIsRight = !IsOff(Miss.Gain) && !IsOff(Miss.Both);
            DecayIsRight = !IsOff(Miss.Decay) && !IsOff(Miss.Both);
            Cost = (GainIsRight ? 0 : 100000) + (DecayIsRight ? 0 : 100000) + _matches.Count(m => m.IsOff);
        }

        public Link[] Links { get; }

        /// <summary>The number of the reading of the gain.</summary>
        public int Reading { get; }

        /// <summary>The source of the force or the torque.</summary>
        public Source Source { get; }

        public TimeStep Step { get; }

        /// <summary>What an instructor has to decide about the gain; null: it is the sheet's.</summary>
        public string Code { get; }

        public Order Order { get; }

        public bool DecaysFirst => Order == Order.DecayThenGain;

        public bool GainIsRight { get; }

        public bool DecayIsRight { get; }

        /// <summary>Steps that are wrong, then frames that are: lower is better.</summary>
        public int Cost { get; }

        public Miss MissOf(int link) => _matches[link].Miss;

        /// <summary>The factor of the frame; NaN where it cannot be determined.</summary>
        public double DecayOf(int link) => _matches[link].Decay;

        /// <summary>The velocity between gain and decay, as in the script; computed from the end of the frame.</summary>
        public Vector Gained(int link)
        {
            double decay = Order == Order.GainThenDecay ? _matches[link].Decay : Sheet.Decay;
            if (DecaysFirst)
                return Links[link].After;
            return (1 / (double.IsNaN(decay) || Math.Abs(decay) < 1e-3 ? Sheet.Decay : decay)) * Links[link].After;
        }

        /// <summary>True if all velocities with a wrong factor have one length: the script limits them.</summary>
        public bool IsLimited
        {
            get
            {
                int seen = 0;
                double shortest = double.PositiveInfinity, longest = 0;
                for (int i = 0; i < _matches.Length; i++)
                {
                    if ((_matches[i].Miss != Miss.Decay && !_matches[i].IsBlamed) || !Links[i].At.IsVaried)
                        continue;
                    double length = Links[i].After.Length;
                    shortest = Math.Min(shortest, length);
                    longest = Math.Max(longest, length);
                    seen++;
                }

                return seen > 5 && longest - shortest < 1e-3 * longest;
            }
        }

        /// <summary>The first frame with one of the misses.</summary>
        public int? First(params Miss[] kinds)
        {
            int i = Array.FindIndex(_matches, m => kinds.Contains(m.Miss));
            return i < 0 ? (int?)null : i;
        }

        private bool IsOff(Miss kind)
        {
            for (int i = 0; i < _matches.Length; i++)
            {
                if (_matches[i].Miss == kind)
                    return true;
            }

            return false;
        }

        private bool IsOff(Miss kind, bool isVaried)
        {
            for (int i = 0; i < _matches.Length; i++)
            {
                if (_matches[i].Miss == kind && Links[i].At.IsVaried == isVaried)
                    return true;
            }

            return false;
        }

        private void Blame(Miss from, Miss to, double decayWhereFree)
        {
            for (int i = 0; i < _matches.Length; i++)
            {
                if (_matches[i].Miss == from)
                    _matches[i].Blame(to, decayWhereFree);
            }
        }

        /// <summary>
        /// A script that keeps R or 1/m from the frame before is right, and misses only where the experiment has changed the state.
        /// </summary>
        private void ForgiveWhatWasKept()
        {
            for (int i = 0; i < _matches.Length; i++)
            {
                if (_matches[i].IsOff && !Links[i].At.IsSetAnew)
                    return;
            }

            for (int i = 0; i < _matches.Length; i++)
            {
                if (_matches[i].IsOff)
                    _matches[i].Forget();
            }
        }

        /// <summary>
        /// Resolves ambiguous frames by the others: two coefficients found in one frame are accepted where nearly all frames agree that
        /// there are only two, and where gain and decay cannot be separated the step that is wrong elsewhere is wrong here.
        /// </summary>
        private void Resolve()
        {
            bool isLinear = IsLinear();
            double free = IsOff(Miss.Decay, true) && !IsLimited ? DecayWhereFree() : Sheet.Decay;
            for (int i = 0; i < _matches.Length; i++)
            {
                if (_matches[i].HasTwo)
                    _matches[i].Resolve(isLinear, free);
            }

            if (IsLimited)
                Blame(Miss.Decay, Miss.Gain, free);
            bool gainIsOff = IsOff(Miss.Gain) || IsOff(Miss.Both), decayIsOff = IsOff(Miss.Decay, true) || IsOff(Miss.Both, true);
            // an apparent other factor, only in experiments where v and its gain have one direction, is none
            if (gainIsOff && !decayIsOff)
                Blame(Miss.Decay, Miss.Gain, free);
            Blame(Miss.Either, gainIsOff || !(decayIsOff || IsOff(Miss.Decay, false)) ? Miss.Gain : Miss.Decay, free);
            Blame(Miss.Gain, Miss.Gain, free);
        }

        /// <summary>True if nearly all frames that show two coefficients have no more than two.</summary>
        private bool IsLinear()
        {
            int two = 0, fitted = 0;
            for (int i = 0; i < _matches.Length; i++)
            {
                two += _matches[i].HasTwo ? 1 : 0;
                fitted += _matches[i].HasTwo && _matches[i].FitsTwo ? 1 : 0;
            }

            return fitted > 0.9 * two;
        }

        /// <summary>The median factor where no force acts, so that only the factor changes the velocity.</summary>
        private double DecayWhereFree()
        {
            double free = Coefficients.Median(_matches.Where((m, i) => m.Miss == Miss.Decay && m.IsFree && Links[i].At.IsVaried).Select(m => m.Decay));
            return double.IsNaN(free) ? Sheet.Decay : free;
        }
    }
}
