using System;
using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>A velocity through all frames, against the sheet's steps 1 and 5 (or 2 and 5) with one Δt.</summary>
    internal sealed class Chain
    {
        private readonly Match[] _matches;

        public Chain(Links links, TimeStep step, Order order)
        {
            Source = links.Source;
            Code = links.Code;
            Links = links.All;
            Step = step;
            Order = order;
            _matches = Links.Select(link => new Match(link, step.At(link.At), order)).ToArray();
            ForgiveWhatWasKept();
            Resolve();
            GainIsRight = _matches.All(m => m.Miss != Miss.Gain && m.Miss != Miss.Both);
            DecayIsRight = _matches.All(m => m.Miss != Miss.Decay && m.Miss != Miss.Both);
        }

        public IReadOnlyList<Link> Links { get; }

        /// <summary>Where the force or the torque was taken from.</summary>
        public Source Source { get; }

        public TimeStep Step { get; }

        /// <summary>What an instructor decides about the gain; null: it is the sheet's.</summary>
        public string Code { get; }

        public Order Order { get; }

        public bool DecaysFirst => Order == Order.DecayThenGain;

        public bool GainIsRight { get; }

        public bool DecayIsRight { get; }

        /// <summary>Steps that are off, then frames that are: the smaller the better.</summary>
        public int Cost => (GainIsRight ? 0 : 100000) + (DecayIsRight ? 0 : 100000) + _matches.Count(m => m.IsOff);

        public Miss MissOf(int link) => _matches[link].Miss;

        /// <summary>The factor of the frame; not a number where it cannot be told.</summary>
        public double DecayOf(int link) => _matches[link].Decay;

        /// <summary>The velocity between gain and decay, as the script had it; taken from what the frame left.</summary>
        public Vector Gained(int link)
        {
            double decay = Order == Order.GainThenDecay ? _matches[link].Decay : Sheet.Decay;
            if (DecaysFirst)
                return Links[link].After;
            return (1 / (double.IsNaN(decay) || Math.Abs(decay) < 1e-3 ? Sheet.Decay : decay)) * Links[link].After;
        }

        /// <summary>Where the factor is off, all velocities are of one length: a limit has been put to them.</summary>
        public bool IsLimited
        {
            get
            {
                double[] lengths = Links.Where((l, i) => l.At.IsVaried && (_matches[i].Miss == Miss.Decay || _matches[i].IsBlamed)).Select(l => l.After.Length).ToArray();
                return lengths.Length > 5 && lengths.Max() - lengths.Min() < 1e-3 * lengths.Max();
            }
        }

        private bool IsOff(Miss kind, bool isVaried) => Enumerable.Range(0, _matches.Length).Any(i => _matches[i].Miss == kind && Links[i].At.IsVaried == isVaried);

        private void Blame(Miss from, Miss to, double decayWhereFree)
        {
            foreach (Match match in _matches.Where(m => m.Miss == from))
                match.Blame(to, decayWhereFree);
        }

        /// <summary>The first frame with one of the misses.</summary>
        public int? First(params Miss[] kinds)
        {
            int i = Array.FindIndex(_matches, m => kinds.Contains(m.Miss));
            return i < 0 ? (int?)null : i;
        }

        /// <summary>
        /// A script that keeps R or 1/m from the frame before is right, and misses only where the experiment has changed the state under it.
        /// </summary>
        private void ForgiveWhatWasKept()
        {
            if (Enumerable.Range(0, _matches.Length).Any(i => _matches[i].IsOff && !Links[i].At.IsSetAnew))
                return;
            foreach (Match match in _matches.Where(m => m.IsOff))
                match.Forget();
        }

        /// <summary>
        /// What one frame leaves open, the others decide: two coefficients found in one frame are believed where nearly all frames agree
        /// that there are only two, and where gain and decay cannot be told apart the step that is off elsewhere is off here.
        /// </summary>
        private void Resolve()
        {
            Match[] gaining = _matches.Where(m => m.HasTwo).ToArray();
            bool isLinear = gaining.Count(m => m.FitsTwo) > 0.9 * gaining.Length;
            double free = Coefficients.Median(_matches.Where((m, i) => m.Miss == Miss.Decay && m.IsFree && Links[i].At.IsVaried).Select(m => m.Decay));
            if (double.IsNaN(free) || IsLimited)
                free = Sheet.Decay;
            foreach (Match match in gaining)
                match.Resolve(isLinear, free);
            if (IsLimited)
                Blame(Miss.Decay, Miss.Gain, free);
            bool gainIsOff = _matches.Any(m => m.Miss == Miss.Gain || m.Miss == Miss.Both), decayIsOff = IsOff(Miss.Decay, true) || IsOff(Miss.Both, true);
            // what looks like another factor, in experiments alone where v and what is added to it have one direction, is not
            if (gainIsOff && !decayIsOff)
                Blame(Miss.Decay, Miss.Gain, free);
            Blame(Miss.Either, gainIsOff || !(decayIsOff || IsOff(Miss.Decay, false)) ? Miss.Gain : Miss.Decay, free);
            Blame(Miss.Gain, Miss.Gain, free);
        }
    }
}
