using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// The dormant bodies that an effect will wake, the earliest first: a heap whose bodies store their places in it, so that
    /// a body pushed or removed before that time can leave it.
    /// </summary>
    internal sealed class WakeQueue
    {
        private Entry[] _heap = Array.Empty<Entry>();
        private int _count;

        /// <summary>The step in which the next one wakes.</summary>
        public long Next => _count > 0 ? _heap[0].At : long.MaxValue;

        public void Add(long at, Body body)
        {
            if (_count == _heap.Length)
                Array.Resize(ref _heap, Math.Max(16, 2 * _count));

            Rise(_count++, new Entry { At = at, Body = body });
        }

        public Body Take()
        {
            Body first = _heap[0].Body;
            Remove(first);
            return first;
        }

        /// <summary>Removes a body, if it is in the queue.</summary>
        public void Remove(Body body)
        {
            int hole = body.PlaceInQueue;
            if (hole < 0)
                return;

            body.PlaceInQueue = -1;
            Entry last = _heap[--_count];
            _heap[_count] = default(Entry);
            if (hole == _count)
                return;

            for (int below = 2 * hole + 1; below < _count; below = 2 * hole + 1)
            {
                if (below + 1 < _count && _heap[below + 1].At < _heap[below].At)
                    below++;

                if (_heap[below].At >= last.At)
                    break;

                Set(hole, _heap[below]);
                hole = below;
            }

            Rise(hole, last);
        }

        private void Rise(int hole, Entry entry)
        {
            for (int above = (hole - 1) / 2; hole > 0 && entry.At < _heap[above].At; above = (hole - 1) / 2)
            {
                Set(hole, _heap[above]);
                hole = above;
            }

            Set(hole, entry);
        }

        private void Set(int place, in Entry entry)
        {
            _heap[place] = entry;
            entry.Body.PlaceInQueue = place;
        }

        private struct Entry
        {
            public long At;
            public Body Body;
        }
    }
}
