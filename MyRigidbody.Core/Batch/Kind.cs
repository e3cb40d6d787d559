#if NET
using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Bodies of equal descriptions, and their batches: bodies are in one batch where the start of each lets the same be left out.
    /// </summary>
    internal sealed class Kind
    {
        // fewer bodies are moved one by one, and a body that diverges is then found in the call in which it does
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

        /// <summary>The common description at rest; never changed.</summary>
        public BodyDescription Like { get; }

        /// <summary>True while its batches have no bodies.</summary>
        public bool HasNobody => Array.TrueForAll(_batches, batch => batch == null || batch.Count == 0);

        /// <summary>True for a body that is moved in a batch: it has the description of the last one, or many have been added before.</summary>
        public bool IsOneOfMany(BodyDescription description)
        {
            bool isAgain = description == _last;
            _last = description;
            return isAgain || (_isOrdinary && ++_came > FewestOfMany);
        }

        /// <summary>The batch for a body that starts now.</summary>
        /// <param name="start">How the body starts.</param>
        /// <param name="clock">The clock of the simulation.</param>
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
