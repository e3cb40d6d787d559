using System;
using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>What a plan may leave out because the motion is the same without.</summary>
    [Flags]
    internal enum Omissions
    {
        /// <summary>Everything is computed, step by step.</summary>
        None = 0,

        /// <summary>The rotation of a body that starts without spin and never feels a torque.</summary>
        Rotation = 1,

        /// <summary>The translation of a body that starts at rest and never feels a force or gravity.</summary>
        Translation = 2,

        /// <summary>The steps of a body on which nothing acts but gravity, constant forces and damping, while nobody looks.</summary>
        Coasting = 4,

        /// <summary>All of them.</summary>
        All = Rotation | Translation | Coasting,
    }

    /// <summary>
    /// What a body's motion consists of, read once from its description: what is here runs, and what runs is here. A body that
    /// is changed gets another.
    /// </summary>
    internal sealed class BodyPlan
    {
        private readonly TimeSteps.Grid _division;

        internal BodyPlan(BodyDescription body, TimeSteps steps, Omissions mayLeaveOut, long first = 0, double massRatio = 1)
        {
            body.Check();
            Steps = steps;
            _division = steps.Division;
            MayLeaveOut = mayLeaveOut;
            Rule = body.Rule;
            Asked = body.Copy(body.Name, body.Mass);
            Stretches = StretchPlan.Divide(body, steps, first, massRatio);

            foreach (StretchPlan stretch in Stretches)
            {
                IsPushed |= stretch.Pushes.Count > 0 || stretch.MassCourse?.Shedding != null;
                ChangesMass |= stretch.MassCourse != null;
                HasImpulses |= stretch.Impulses.Count > 0;
            }

            LeftOut = CanLeaveOut(first) & ~Needs(body.Start);
            Bearing = Rule.HoldsAxes ? null : Bearing.Of(body.Lock, body.Mass);
            Body = body.Copy(body.Name, Bearing?.Mass ?? body.Mass);
            Body.Lock |= ((LeftOut & Omissions.Rotation) == 0 ? 0 : Locks.Turn) | ((LeftOut & Omissions.Translation) == 0 ? 0 : Locks.Move);
        }

        /// <summary>How its time is divided.</summary>
        public TimeSteps Steps { get; }

        /// <summary>The rule by which it moves.</summary>
        public Rule Rule { get; }

        /// <summary>The stretches of time in which the same effects act, one after another.</summary>
        public IReadOnlyList<StretchPlan> Stretches { get; }

        /// <summary>Rotation or translation, where the body has neither though it could.</summary>
        public Omissions LeftOut { get; }

        /// <summary>The body as its integrator gets it: it cannot do what it never does.</summary>
        internal BodyDescription Body { get; }

        /// <summary>The body as the scene describes it.</summary>
        public BodyDescription Asked { get; }

        /// <summary>What the locks do that leave some axes free, if the rule does not do it; else null.</summary>
        internal Bearing Bearing { get; }

        internal Omissions MayLeaveOut { get; }

        /// <summary>What a body in a state has, whatever acts on it.</summary>
        internal static Omissions Needs(in BodyState state) =>
            (state.Velocity.IsZero ? 0 : Omissions.Translation) | (state.AngularVelocity.IsZero ? 0 : Omissions.Rotation);

        /// <summary>Rotation or translation, where a body at rest has neither from a step on though it could.</summary>
        internal Omissions CanLeaveOut(long step)
        {
            bool moves = !Asked.CanMove, turns = !Asked.CanTurn;
            // no enumerator: it is asked for every body that comes, and must not allocate
            for (int i = Stretches.Count - 1; i >= 0 && Stretches[i].End > step; i--)
            {
                moves |= (Stretches[i].Does & EffectTraits.Moves) != 0 || !Stretches[i].Coasting.Acceleration.IsZero;
                turns |= (Stretches[i].Does & EffectTraits.Turns) != 0;
                for (int j = Stretches[i].First >= step ? Stretches[i].Impulses.Count - 1 : -1; j >= 0; j--)
                {
                    moves |= (Stretches[i].Impulses[j].Impulse.Traits & EffectTraits.Moves) != 0;
                    turns |= (Stretches[i].Impulses[j].Impulse.Traits & EffectTraits.Turns) != 0;
                }
            }

            return MayLeaveOut & ((turns ? 0 : Omissions.Rotation) | (moves ? 0 : Omissions.Translation));
        }

        /// <summary>True if it is the plan of a body that starts at a step, too.</summary>
        internal bool HoldsFrom(long step) =>
            (ChangesMass ? step == Stretches[0].First : step >= Stretches[0].First) && (!ChangesAfter(step - 1) || Steps.Division.Equals(_division));

        /// <summary>True if an effect begins or ends after a step.</summary>
        internal bool ChangesAfter(long step) => Stretches[Stretches.Count - 1].First > step;

        /// <summary>True if its mass is not always that which it began with.</summary>
        internal bool ChangesMass { get; }

        /// <summary>The mass before a step, as a part of that which it began with.</summary>
        internal double MassRatioAt(long step)
        {
            int i = Stretches.Count - 1;
            while (i > 0 && Stretches[i].First > step)
                i--;

            return Stretches[i].MassCourse?.At(Steps.StartOf(step)) ?? 1;
        }

        /// <summary>True if impulses are given at any time.</summary>
        internal bool HasImpulses { get; }

        internal bool MayCoast => (MayLeaveOut & Omissions.Coasting) != 0;

        /// <summary>True if something pushes it at any time.</summary>
        internal bool IsPushed { get; }
    }
}
