#if NET
using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// What bodies have in common that are described alike, and those of them that are moved together: apart from one another where the
    /// one's start lets something be left out and the other's does not.
    /// </summary>
    internal sealed class Kind
    {
        // fewer may as well be moved one by one, and a body that runs away is then found in the call in which it does
        private const int FewestOfMany = 64;

        private readonly Batch[] _batches = new Batch[(int)(Omissions.Rotation | Omissions.Translation) + 1];
        private readonly bool _isOrdinary;
        private int _came;
        private BodyDescription _last;
        private BodyPlan _atRest;

        public Kind(BodyDescription body)
        {
            Like = body.Copy(body.Name, body.Mass);
            Like.Start = BodyState.AtRest;
            _isOrdinary = Alike.IsOrdinary(body);
        }

        /// <summary>One of them at rest; nobody changes it.</summary>
        public BodyDescription Like { get; }

        /// <summary>True while none of them is moved together with another.</summary>
        public bool HasNobody => Array.TrueForAll(_batches, batch => batch == null || batch.Count == 0);

        /// <summary>True for a body that is moved together with others: it comes with the description of the last, or many have come before.</summary>
        public bool IsOneOfMany(BodyDescription description)
        {
            bool isAgain = description == _last;
            _last = description;
            return isAgain || (_isOrdinary && ++_came > FewestOfMany);
        }

        /// <summary>The bodies together with which one is moved that starts so now.</summary>
        /// <param name="start">How the body starts.</param>
        /// <param name="clock">When it is now.</param>
        /// <param name="mayLeaveOut">What may be left out.</param>
        public Batch For(in BodyState start, Clock clock, Omissions mayLeaveOut)
        {
            if (_atRest == null || !_atRest.HoldsFrom(clock.Step))
                _atRest = new BodyPlan(Like, clock.Steps, mayLeaveOut, clock.Step);

            Omissions leftOut = _atRest.CanLeaveOut(clock.Step) & ~BodyPlan.Needs(start);
            Batch batch = _batches[(int)leftOut];
            if (batch == null || !batch.Plan.HoldsFrom(clock.Step))
            {
                BodyDescription at = Like.Copy(Like.Name, Like.Mass);
                at.Start = start;
                _batches[(int)leftOut] = batch = new Batch(this, new BodyPlan(at, clock.Steps, mayLeaveOut, clock.Step), clock);
            }

            return batch;
        }
    }
}
#endif
