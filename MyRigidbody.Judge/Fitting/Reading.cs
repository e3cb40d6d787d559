using System;
using System.Collections.Generic;

namespace RigidBodyDynamics.Judging
{
    /// <summary>One reading of step 3 or 4: the velocity by which the pose moves, and the code for a script that does so.</summary>
    internal sealed class Reading
    {
        public const string DampedBefore = "damped-before-moving";

        private readonly Func<Chain, int, Vector> _velocity;

        private Reading(string code, Func<Chain, int, Vector> velocity)
        {
            Code = code;
            _velocity = velocity;
        }

        /// <summary>Null: as the sheet has it.</summary>
        public string Code { get; }

        public Vector Velocity(Chain chain, int link) => _velocity(chain, link);

        /// <summary>The velocity after steps 1 or 2.</summary>
        public static readonly Reading New = new Reading(null, (c, i) => c.Gained(i));

        /// <summary>The velocity of the frame before, as formula 3.3 is printed.</summary>
        public static readonly Reading Old = new Reading(null, (c, i) => c.Links[i].Before);

        /// <summary>As <see cref="New"/>, but computed by the sheet and not by the script's steps 1 or 2.</summary>
        private static readonly Reading Reference = new Reading(null, (c, i) => Decayed(c, i) + c.Step.At(c.Links[i].At) * c.Links[i].Gain);

        private static readonly Reading OldDecayed = new Reading(null, (c, i) => Decayed(c, i));

        /// <summary>The velocity after step 5: 98 % of the distance.</summary>
        private static readonly Reading AfterDecay = new Reading(DampedBefore, (c, i) => c.Links[i].After);

        /// <summary>The velocity between two dampings in a script.</summary>
        private static readonly Reading BetweenDecays = new Reading(DampedBefore, (c, i) => (1 / Sheet.Decay) * c.Links[i].After);

        /// <summary>The mean of old and new, which is exact for a constant force.</summary>
        private static readonly Reading Mean = new Reading("second-order", (c, i) => Decayed(c, i) + 0.5 * c.Step.At(c.Links[i].At) * c.Links[i].Gain);

        /// <summary>All readings that can be distinguished for this chain, the sheet's first.</summary>
        public static IEnumerable<Reading> Of(Chain chain) => chain.DecaysFirst
            ? new[] { New, Old, OldDecayed, Reference, Mean }
            : new[] { New, Old, Reference, AfterDecay, BetweenDecays, Mean };

        private static Vector Decayed(Chain chain, int i) => (chain.DecaysFirst ? Sheet.Decay : 1) * chain.Links[i].Before;
    }
}
