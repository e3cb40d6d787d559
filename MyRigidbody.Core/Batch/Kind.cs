#if NET
using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// What bodies have in common that were added with one description, and those of them that are moved together: apart from one
    /// another where the one's start lets something be left out and the other's does not.
    /// </summary>
    internal sealed class Kind
    {
        private readonly Batch[] _batches = new Batch[(int)(Omissions.Rotation | Omissions.Translation) + 1];
        private BodyPlan _atRest;

        /// <summary>The bodies together with which one is moved that starts so now; new ones if the description has been changed.</summary>
        /// <param name="description">The description as it is.</param>
        /// <param name="start">How the body starts.</param>
        /// <param name="clock">When it is now.</param>
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

        /// <summary>The same for a body that is of this kind.</summary>
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
