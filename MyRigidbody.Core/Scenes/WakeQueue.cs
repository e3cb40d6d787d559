namespace RigidBodyDynamics
{
    /// <summary>The dormant bodies that an effect will wake, the next of them first: a heap that allocates nothing.</summary>
    internal sealed class WakeQueue
    {
        private readonly long[] _at;
        private readonly Body[] _bodies;
        private int _count;

        public WakeQueue(int most)
        {
            _at = new long[most];
            _bodies = new Body[most];
        }

        /// <summary>When the next one wakes.</summary>
        public long Next => _count > 0 ? _at[0] : long.MaxValue;

        public void Clear() => _count = 0;

        public void Add(long at, Body body)
        {
            int hole = _count++;
            for (int above = (hole - 1) / 2; hole > 0 && at < _at[above]; above = (hole - 1) / 2)
            {
                Move(above, hole);
                hole = above;
            }

            Set(hole, at, body);
        }

        public Body Take()
        {
            Body first = _bodies[0];
            long at = _at[--_count];
            Body last = _bodies[_count];
            int hole = 0;
            for (int below = 1; below < _count; below = 2 * hole + 1)
            {
                if (below + 1 < _count && _at[below + 1] < _at[below])
                    below++;

                if (_at[below] >= at)
                    break;

                Move(below, hole);
                hole = below;
            }

            Set(hole, at, last);
            return first;
        }

        private void Move(int from, int to) => Set(to, _at[from], _bodies[from]);

        private void Set(int place, long at, Body body)
        {
            _at[place] = at;
            _bodies[place] = body;
        }
    }
}
