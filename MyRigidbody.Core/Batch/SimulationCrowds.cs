#if NET
using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Bodies that are added with one description are moved together from the second on; those that are described alike one by one, once
    /// they are many.
    /// </summary>
    public sealed partial class Simulation
    {
        // so that adding bodies that are all different does not fill the memory with their descriptions
        private const int MostKinds = 1024;

        private readonly Dictionary<BodyDescription, Kind> _kinds = new Dictionary<BodyDescription, Kind>(new Alike());

        partial void AddTogether(Body body, BodyDescription description, in BodyState start, Vector3d? inBody, ref bool isTogether)
        {
            description.CheckAllElse();
            Kind kind = KindOf(description);
            isTogether = kind.IsOneOfMany(description);
            if (!isTogether)
                return;

            description.Check(start);
            Join(body, kind.For(start, _clock, MayLeaveOut), start, inBody);
        }

        partial void AddTogether(Body body, Mover mover, in BodyState start, ref bool isTogether)
        {
            isTogether = mover is Batch;
            if (isTogether)
                Join(body, ((Batch)mover).Kind.For(start, _clock, MayLeaveOut), start, null);
        }

        partial void Forget(Mover crowd)
        {
            // a kind without bodies is kept only by removed bodies, which may be added again
            if (((Batch)crowd).Kind.HasNobody)
                _kinds.Remove(((Batch)crowd).Kind.Like);
        }

        partial void RestoreCrowds(SavedSimulation saved)
        {
            foreach (Mover crowd in _crowds)
                ((Batch)crowd).Clear();

            _crowds.Clear();
            foreach (SavedCrowd crowd in saved.Crowds)
            {
                crowd.Restore();
                _crowds.Add(crowd.Mover);
            }
        }

        partial void Distribute()
        {
            foreach (Mover crowd in _crowds)
                ((Batch)crowd).Threads = _threads;
        }

        private Kind KindOf(BodyDescription description)
        {
            if (!_kinds.TryGetValue(description, out Kind kind))
            {
                if (_kinds.Count == MostKinds)
                    _kinds.Clear();

                kind = new Kind(description);
                _kinds.Add(kind.Like, kind);
            }

            return kind;
        }

        private void Join(Body body, Batch batch, in BodyState start, Vector3d? inBody)
        {
            if (batch.Count == 0)
            {
                batch.Threads = _threads;
                _crowds.Add(batch);
            }

            batch.Add(body, start, inBody);
        }
    }
}
#endif
