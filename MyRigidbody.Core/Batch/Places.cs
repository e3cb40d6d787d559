#if NET
using System;

namespace RigidBodyDynamics
{
    /// <summary>Which body is in which place. There are no gaps: the last body takes the place of one that is removed.</summary>
    internal sealed class Places
    {
        private Body[] _bodies = Array.Empty<Body>();

        public int Count { get; private set; }

        public Body this[int place] => _bodies[place];

        public void Reserve(int capacity) => Array.Resize(ref _bodies, capacity);

        /// <summary>Gives a new body the place after the last.</summary>
        public void Add(Body body)
        {
            body.Place = Count;
            _bodies[Count++] = body;
        }

        public void Remove(int place)
        {
            Body last = _bodies[--Count];
            _bodies[place] = last;
            last.Place = place;
            _bodies[Count] = null;
        }

        /// <summary>Removes all bodies.</summary>
        public void Clear()
        {
            Array.Clear(_bodies, 0, Count);
            Count = 0;
        }

        public Body[] Save() => _bodies.AsSpan(0, Count).ToArray();

        public void Restore(Body[] bodies)
        {
            Clear();
            foreach (Body body in bodies)
                Add(body);
        }
    }
}
#endif
