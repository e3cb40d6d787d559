using System;
using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>The steps from one beginning or end of an effect to the next, and the effects on a body in them.</summary>
    internal sealed class StretchPlan
    {
        private readonly List<PushEffect> _pushes = new List<PushEffect>();
        private readonly List<Effect> _effects = new List<Effect>();
        private readonly List<ImpulseEffect> _impulses = new List<ImpulseEffect>();
        private readonly List<ICoast> _coasts = new List<ICoast>();
        private readonly Coasting _coasting = Coasting.Free;

        private StretchPlan(BodyDescription body, TimeSteps steps, long first, long end, double ratio)
        {
            First = first;
            End = end;
            Starts = steps.StartOf(first);
            Ends = end < steps.Count ? steps.StartOf(end) : double.PositiveInfinity;
            MassCourse = Course(body, steps, ratio);
            foreach (Effect effect in body.Effects)
            {
                if (effect is ImpulseEffect impulse && steps.Begins(first, effect.From))
                    _impulses.Add(impulse);

                if (steps.FirstAt(effect.From) > first || steps.FirstAt(effect.To) <= first)
                    continue;

                _effects.Add(effect);
                PushEffect push = effect as PushEffect;
                if (effect.Coast is ICoast coast && (push == null || (body.Rule.CoastsUnderForces && RatioAtEnd == ratio)))
                {
                    coast.AddTo(ref _coasting, ratio == 1 ? body.Mass : body.Mass.Times(ratio));
                    _coasts.Add(coast);
                }
                else if (push != null && (effect.Motion.Traits & (EffectTraits.Moves | EffectTraits.Turns)) != 0)
                {
                    Add(push);
                }
            }

            if (MassCourse?.Shedding != null)
                Does |= MassCourse.Shedding.Traits;

            _coasting.Acceleration = body.Lock.Moving(_coasting.Acceleration);
            if ((Does & EffectTraits.Turns) != 0 && (body.Lock & Locks.Turn) != 0)
                Does |= EffectTraits.ReadsOrientation;
        }

        /// <summary>Its first step.</summary>
        public long First { get; }

        /// <summary>The step after its last.</summary>
        public long End { get; }

        /// <summary>The start of its first step, s.</summary>
        public double Starts { get; }

        /// <summary>The end of its last step, s; infinite where the body's time is.</summary>
        public double Ends { get; }

        public IReadOnlyList<Effect> Effects => _effects;

        /// <summary>Gravity, constant forces and damping, all of them in one closed form.</summary>
        public Coasting Coasting => _coasting;

        /// <summary>The effects that <see cref="Coasting"/> sums.</summary>
        internal IReadOnlyList<ICoast> Coasts => _coasts;

        /// <summary>The other effects that move or rotate the body.</summary>
        internal IReadOnlyList<PushEffect> Pushes => _pushes;

        /// <summary>What the pushes together do and read.</summary>
        internal EffectTraits Does { get; private set; }

        /// <summary>The impulses at the beginning of its first step, before any other effect of it.</summary>
        internal IReadOnlyList<ImpulseEffect> Impulses => _impulses;

        /// <summary>True if a step begins with an impulse.</summary>
        internal bool GivesAt(long step) => step == First && _impulses.Count > 0;

        /// <summary>The course of its mass; null while that is the first mass.</summary>
        internal MassCourse MassCourse { get; }

        /// <summary>The part of its first mass at the end.</summary>
        internal double RatioAtEnd { get; private set; }

        private MassCourse Course(BodyDescription body, TimeSteps steps, double ratio)
        {
            double rate = 0, shed = 0, seconds = steps.StartOf(End) - Starts;
            RatioAtEnd = ratio;
            for (int i = 0; i < body.Effects.Count; i++)
            {
                Effect effect = body.Effects[i];
                if (!(effect.Motion is MassRate mass) || steps.FirstAt(effect.From) > First || steps.FirstAt(effect.To) <= First)
                    continue;

                rate += mass.Rate / body.Mass.Mass;
                shed += mass.Keeps == Keeping.Momentum ? mass.Rate / body.Mass.Mass : 0;
                RatioAtEnd = ratio + rate * seconds;
                if (!(RatioAtEnd > 0))
                    throw Guard.Refused("effects[" + i + "]", mass.Rate, "must leave mass to the end; all is gone at t = " + (Starts - ratio / rate).ToString("g6", System.Globalization.CultureInfo.InvariantCulture) + " s");

                Guard.Finite(RatioAtEnd * body.Mass.Mass, "effects[" + i + "]");
            }

            return ratio == 1 && rate == 0 ? null : new MassCourse(Starts, ratio, rate, shed);
        }

        private void Add(PushEffect push)
        {
            _pushes.Add(push);
            Does |= push.Push.Traits;
        }

        /// <summary>Divides the time of a body, from a step on, at the beginnings and ends of its effects.</summary>
        internal static IReadOnlyList<StretchPlan> Divide(BodyDescription body, TimeSteps steps, long first, double ratio)
        {
            SortedSet<long> cuts = new SortedSet<long> { first, steps.Count };
            foreach (Effect effect in body.Effects)
            {
                cuts.Add(Math.Max(first, steps.FirstAt(effect.From)));
                cuts.Add(Math.Max(first, steps.FirstAt(effect.To)));
            }

            // a body added after the last step has one stretch, without steps
            long[] at = new long[Math.Max(2, cuts.Count)];
            at[1] = first;
            cuts.CopyTo(at);
            StretchPlan[] stretches = new StretchPlan[at.Length - 1];
            for (int i = 0; i < stretches.Length; i++)
            {
                stretches[i] = new StretchPlan(body, steps, at[i], at[i + 1], ratio);
                ratio = stretches[i].RatioAtEnd;
            }

            return stretches;
        }
    }
}
