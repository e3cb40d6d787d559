#if NET
using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// What bodies that were added with one description have in common, and their batches: bodies are in one batch where the start
    /// of each lets the same be left out.
    /// </summary>
    internal sealed class Kind
    {
        private readonly Batch[] _batches = new Batch[(int)(Omissions.Rotation | Omissions.Translation) + 1];
        private BodyPlan _atRest;

        /// <summary>The batch for a body that starts now; a new one if the description has changed.</summary>
        /// <param name="description">The present description.</param>
        /// <param name="start">How the body starts.</param>
        /// <param name="clock">The clock of the simulation.</param>
        /// <param name="mayLeaveOut">What may be left out.</param>
        public Batch For(BodyDescription description, in BodyState start, Clock clock, Omissions mayLeaveOut)
        {
            if (_atRest == null || (description != _atRest.Asked && !_atRest.Asked.IsLike(description)))
            {
                Array.Clear(_batches, 0, _batches.Length);
                _atRest = null;
            }

            if (_atRest == null || !_atRest.HoldsFrom(clock.Step))
                _atRest = new BodyPlan(At(description, BodyState.AtRest), clock.Steps, mayLeaveOut, clock.Step);

            Omissions leftOut = _atRest.CanLeaveOut(clock.Step) & ~BodyPlan.Needs(start);
            Batch batch = _batches[(int)leftOut];
            if (batch == null || !batch.Plan.HoldsFrom(clock.Step))
            {
                BodyPlan plan = new BodyPlan(At(description, start), clock.Steps, mayLeaveOut, clock.Step);
                _batches[(int)leftOut] = batch = new Batch(this, plan, clock);
            }

            return batch;
        }

        /// <summary>The batch for a body of this kind.</summary>
        public Batch For(in BodyState start, Clock clock, Omissions mayLeaveOut) => For(_atRest.Asked, start, clock, mayLeaveOut);

        private static BodyDescription At(BodyDescription description, in BodyState start)
        {
            BodyDescription at = description.Copy(description.Name, description.Mass);
            at.Start = start;
            return at;
        }
    }
}
#endif
