using System;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>All frames, interpreted with one Δt: which steps are then wrong. The explanation with the fewest wrong steps is reported.</summary>
    internal sealed class Explanation
    {
        private readonly Travel _moving;
        private readonly Lazy<Travel> _turning;

        public Explanation(Motion motion, TimeStep step)
        {
            Step = step;
            _moving = Travel.Best(motion.Velocity, step, Carry.OfPosition);
            _turning = new Lazy<Travel>(() => Travel.Best(motion.AngularVelocity, step, Carry.OfOrientation));
        }

        private Explanation(Motion motion, Explanation part)
        {
            Step = part.Step;
            _moving = Travel.Like(part._moving, motion.Velocity, Step, Carry.OfPosition);
            Travel turning = Travel.Like(part._turning.Value, motion.AngularVelocity, Step, Carry.OfOrientation);
            _turning = new Lazy<Travel>(() => turning);
        }

        public TimeStep Step { get; }

        public Chain Velocity => _moving.Chain;

        public Chain AngularVelocity => _turning.Value.Chain;

        public Carry Position => _moving.Carry;

        public Carry Orientation => _turning.Value.Carry;

        public bool IsDampedRightly => _moving.IsDampedRightly && _turning.Value.IsDampedRightly;

        /// <summary>The number of wrong steps, then of steps with another reading than the sheet's.</summary>
        public double Cost => Count(!Velocity.GainIsRight, !AngularVelocity.GainIsRight, !Position.IsRight, !Orientation.IsRight, !IsDampedRightly)
            + 0.3 * Count(Position.Code != null, Orientation.Code != null, AngularVelocity.Code != null);

        /// <summary>The cost of steps 1, 3 and 5 alone; ω has far more readings than v, and need not be tried where this is enough.</summary>
        public double LeastCost => Count(!Velocity.GainIsRight, !Position.IsRight, !_moving.IsDampedRightly) + 0.3 * Count(Position.Code != null);

        /// <summary>The explanation of a part of the frames, tested on more of them.</summary>
        public Explanation In(Motion motion) => new Explanation(motion, this);

        private static int Count(params bool[] conditions) => conditions.Count(c => c);
    }

    /// <summary>One of the two velocities, and the pose that moves by it: steps 1 and 3, or 2 and 4.</summary>
    internal sealed class Travel
    {
        private const int Step = 100000;

        private Travel(Chain chain, Carry carry)
        {
            Chain = chain;
            Carry = carry;
        }

        public Chain Chain { get; }

        public Carry Carry { get; }

        public bool IsDampedRightly => Chain.DecayIsRight && !(Carry.IsRight && Carry.IsDampedBefore);

        private double Cost => Chain.Cost + (Carry.IsRight ? 0 : Step + Carry.Missed.Count) + (Chain.DecayIsRight && !IsDampedRightly ? Step : 0)
            + (Carry.Code != null ? 0.3 * Step : 0) + (Chain.Order == Order.DecayGainDecay ? 0.5 : 0);

        /// <summary>The reading of the gain that fits most frames, and the order of gain and decay with the fewest wrong steps.</summary>
        public static Travel Best(GainReadings readings, TimeStep step, Func<Chain, Carry> carry)
        {
            Orders best = null;
            foreach (Links links in readings.ToTry)
            {
                Orders orders = new Orders(links, step);
                if (best == null || (links.Code == null || orders.GainIsRight) && orders.Cost < best.Cost)
                    best = orders;
                if (best.GainIsRight)
                    break;
            }

            return Told(best, carry);
        }

        /// <summary>The reading that was best for a part of the frames; all are tried again where it was right there and is not here.</summary>
        public static Travel Like(Travel part, GainReadings readings, TimeStep step, Func<Chain, Carry> carry)
        {
            Orders orders = new Orders(readings.All[part.Chain.Reading], step);
            return orders.GainIsRight || !part.Chain.GainIsRight ? Told(orders, carry) : Best(readings, step, carry);
        }

        private static Travel Told(Orders orders, Func<Chain, Carry> carry)
        {
            Travel told = null;
            foreach (Chain chain in orders)
            {
                if (told != null && chain.Cost >= told.Cost)
                    continue;
                Travel travel = new Travel(chain, carry(chain));
                if (told == null || travel.Cost < told.Cost)
                    told = travel;
                if (told.Cost < 1)
                    break;
            }

            return told;
        }
    }
}
