#if NET
using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    /// <summary>Bodies that are added with one description are moved together from the second one on.</summary>
    public sealed partial class Simulation
    {
        private readonly ConditionalWeakTable<BodyDescription, Kind> _kinds = new ConditionalWeakTable<BodyDescription, Kind>();

        partial void AddTogether(Body body, BodyDescription description, in BodyState start, Vector3d? inBody, ref bool isTogether)
        {
            if (!_kinds.TryGetValue(description, out Kind kind))
            {
                _kinds.Add(description, new Kind());
                return;
            }

            description.Check(start);
            description.CheckAllElse();
            Join(body, kind.For(description, start, _clock, MayLeaveOut), start, inBody);
            isTogether = true;
        }

        partial void AddTogether(Body body, Mover mover, in BodyState start, ref bool isTogether)
        {
            if (!(mover is Batch batch))
                return;

            Join(body, batch.Kind.For(start, _clock, MayLeaveOut), start, null);
            isTogether = true;
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
