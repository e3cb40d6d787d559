using System;
using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>A velocity through all frames, against the sheet's steps 1 and 5 (or 2 and 5) with one Δt.</summary>
    internal sealed class Chain
    {
        private readonly Match[] _matches;

        public Chain(IReadOnlyList<Link> links, TimeStep step, bool decaysFirst)
        {
            Links = links;
            Step = step;
            DecaysFirst = decaysFirst;
            _matches = links.Select(link => new Match(link, step.At(link.At), decaysFirst)).ToArray();
            ForgiveWhatWasKept();
            Resolve();
            GainIsRight = _matches.All(m => m.Miss != Miss.Gain && m.Miss != Miss.Both);
            DecayIsRight = _matches.All(m => m.Miss != Miss.Decay && m.Miss != Miss.Both);
        }

        public IReadOnlyList<Link> Links { get; }

        public TimeStep Step { get; }

        /// <summary>The factor is applied at the beginning of the frame, before the gain.</summary>
        public bool DecaysFirst { get; }

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
            double decay = _matches[link].Decay;
            if (DecaysFirst)
                return Links[link].After;
            return (1 / (double.IsNaN(decay) || Math.Abs(decay) < 1e-3 ? Sheet.Decay : decay)) * Links[link].After;
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
            double free = Coefficients.Median(_matches.Where(m => m.Miss == Miss.Decay && m.IsFree).Select(m => m.Decay));
            foreach (Match match in gaining)
                match.Resolve(isLinear, double.IsNaN(free) ? Sheet.Decay : free);
            bool gainIsOff = _matches.Any(m => m.Miss == Miss.Gain || m.Miss == Miss.Both), decayIsOff = _matches.Any(m => m.Miss == Miss.Decay || m.Miss == Miss.Both);
            foreach (Match match in _matches.Where(m => m.Miss == Miss.Either))
                match.Blame(gainIsOff || !decayIsOff ? Miss.Gain : Miss.Decay);
        }
    }
}
