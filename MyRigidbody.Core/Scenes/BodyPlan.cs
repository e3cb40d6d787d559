using System;
using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>What a plan may leave out where the motion is the same without it.</summary>
    [Flags]
    internal enum Omissions
    {
        /// <summary>Nothing is left out: every step is computed in full.</summary>
        None = 0,

        /// <summary>The rotation of a body that starts without angular velocity and never has a torque.</summary>
        Rotation = 1,

        /// <summary>The translation of a body that starts at rest and never has a force or gravity.</summary>
        Translation = 2,

        /// <summary>The steps of a body under gravity, constant forces and damping alone, until its state is read.</summary>
        Coasting = 4,

        /// <summary>All of them.</summary>
        All = Rotation | Translation | Coasting,
    }

    /// <summary>
    /// The parts of a body's motion, read once from its description: the plan contains exactly what runs. A body that
    /// is changed gets a new plan.
    /// </summary>
    internal sealed partial class BodyPlan
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

        /// <summary>The integrator by which it moves.</summary>
        public Rule Rule { get; }

        /// <summary>The stretches of time in which the same effects act, one after another.</summary>
        public IReadOnlyList<StretchPlan> Stretches { get; }

        /// <summary>Rotation or translation, where it is left out though the body is free to have it.</summary>
        public Omissions LeftOut { get; }

        /// <summary>The body as the integrator gets it, with all locked that is left out.</summary>
        internal BodyDescription Body { get; private set; }

        /// <summary>The body as the scene describes it.</summary>
        public BodyDescription Asked { get; private set; }

        /// <summary>The treatment of locks that leave some axes free, where the integrator does not treat them; else null.</summary>
        internal Bearing Bearing { get; }

        internal Omissions MayLeaveOut { get; }

        /// <summary>The parts of the motion that a state needs, whatever acts on the body.</summary>
        internal static Omissions Needs(in BodyState state) =>
            (state.Velocity.IsZero ? 0 : Omissions.Translation) | (state.AngularVelocity.IsZero ? 0 : Omissions.Rotation);

        /// <summary>Rotation or translation, where a body at rest has neither from a step on though it is free to.</summary>
        internal Omissions CanLeaveOut(long step)
        {
            bool moves = !Asked.CanMove, turns = !Asked.CanTurn;
            // no enumerator, because this runs for every body that is added, and must not allocate
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

        /// <summary>True if it is also the plan of a body that starts at a step.</summary>
        internal bool HoldsFrom(long step) =>
            (ChangesMass ? step == Stretches[0].First : step >= Stretches[0].First) && (!ChangesAfter(step - 1) || Steps.Division.Equals(_division));

        /// <summary>True if an effect begins or ends after a step.</summary>
        internal bool ChangesAfter(long step) => Stretches[Stretches.Count - 1].First > step;

        internal bool ChangesMass { get; }

        /// <summary>The mass before a step, as a part of the first mass.</summary>
        internal double MassRatioAt(long step)
        {
            int i = Stretches.Count - 1;
            while (i > 0 && Stretches[i].First > step)
                i--;

            return Stretches[i].MassCourse?.At(Steps.StartOf(step)) ?? 1;
        }

        /// <summary>True if there are impulses at any time.</summary>
        internal bool HasImpulses { get; }

        internal bool MayCoast => (MayLeaveOut & Omissions.Coasting) != 0;

        /// <summary>True if there is a push at any time.</summary>
        internal bool IsPushed { get; }
    }
}
