#if NET
using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Finds where a body was lost. Every body is stored as it was at some step; from there the same steps are repeated, to the same
    /// bits, which shows the first body that was lost, its step, and the effect.
    /// </summary>
    internal sealed class Retrace
    {
        // marks an empty place
        private const long Nobody = long.MaxValue;
        private const int All = -1;

        private readonly BodyPlan _plan;
        private readonly Crowd _crowd;
        private readonly Coasters _coasters;
        private readonly Places _places;
        private readonly bool[] _coasts;
        private long[] _since = Array.Empty<long>();
        private int _only = All;

        /// <param name="plan">The plan of the bodies.</param>
        /// <param name="crowd">The bodies.</param>
        /// <param name="coasters">Those that coast.</param>
        /// <param name="places">Knows the numbers of the bodies.</param>
        /// <param name="coasts">For each stretch, whether bodies coast in it. They are stored where such a stretch begins and ends.</param>
        public Retrace(BodyPlan plan, Crowd crowd, Coasters coasters, Places places, bool[] coasts)
        {
            _plan = plan;
            _crowd = crowd;
            _coasters = coasters;
            _places = places;
            _coasts = coasts;
        }

        public void Reserve(int capacity)
        {
            int old = _since.Length;
            Array.Resize(ref _since, capacity);
            Array.Fill(_since, Nobody, old, capacity - old);
        }

        /// <summary>Stores bodies at a step, after their states were tested.</summary>
        public void Keep(int from, int to, long step)
        {
            _crowd.Keep(from, to);
            Array.Fill(_since, step, from, to - from);
        }

        /// <summary>Moves a body, with its stored state, to another place.</summary>
        public void Move(int from, int to)
        {
            _since[to] = _since[from];
            _since[from] = Nobody;
        }

        /// <summary>The step at which a body was stored.</summary>
        public long Since(int place) => _since[place];

        /// <summary>Marks all places as empty.</summary>
        public void Clear() => Array.Fill(_since, Nobody);

        public long[] Save() => (long[])_since.Clone();

        public void Restore(long[] since) => _since = (long[])since.Clone();

        /// <summary>The stretch that contains a step.</summary>
        public int StretchOf(long step)
        {
            int stretch = 0;
            while (stretch + 1 < _coasts.Length && _plan.Stretches[stretch].End <= step)
                stretch++;

            return stretch;
        }

        /// <summary>Takes bodies, in whole groups, from where they were stored to a step, if they existed by then.</summary>
        public void Go(Stepper stepper, int from, int to, long step)
        {
            for (int first = from, end; first < to; first = end)
            {
                end = EndOfAlike(first, to);
                for (long at = Next(first, end, -1), next; at <= step; at = next)
                {
                    Return(first, end, at);
                    next = Next(first, end, at);
                    Forward(stepper, first, end, at, Math.Min(next, step));
                }
            }
        }

        /// <summary>
        /// The exception of the first body lost in whole groups, and its step before an end; null if none is lost. The states of the
        /// bodies are then undefined.
        /// </summary>
        public Exception Find(Stepper stepper, int from, int to, ref long end)
        {
            Exception found = null;
            for (int first = from, next; first < to; first = next)
            {
                next = EndOfAlike(first, to);
                long step = FirstLost(stepper, first, next, end);
                if (step >= end)
                    continue;

                Exception named = Name(stepper, first, next, step);
                if (named == null)
                    continue;

                end = step;
                found = named;
            }

            return found;
        }

        /// <summary>The same for one body alone, whatever happened to the others of its group.</summary>
        public Exception Find(Stepper stepper, int place, ref long end)
        {
            int first = place - place % _crowd.Width;
            _only = place;
            Exception found = Find(stepper, first, first + _crowd.Width, ref end);
            _only = All;
            return found;
        }

        private long FirstLost(Stepper stepper, int from, int to, long end)
        {
            long low = Next(from, to, -1);
            if (low >= end)
                return end;

            return _coasts[StretchOf(low)] ? FirstLostCoasting(stepper, from, to, low, end) : FirstLostStepping(stepper, from, to, low, end);
        }

        private long FirstLostStepping(Stepper stepper, int from, int to, long low, long end)
        {
            Return(from, to, low);
            for (long step = low; step < end; step++)
            {
                try
                {
                    Forward(stepper, from, to, step, step + 1);
                }
                catch (Exception)
                {
                    // the exception of an effect; the effect is evaluated again to name it
                    return step;
                }

                Return(from, to, step + 1);
                if (Lost(from, to, step + 1) >= 0)
                    return step;
            }

            return end;
        }

        /// <summary>Bodies that coast move far from where they were stored, so the step is found by bisection.</summary>
        private long FirstLostCoasting(Stepper stepper, int from, int to, long low, long end)
        {
            if (!IsLostAt(end))
                return end;

            long high = end;
            while (high - low > 1)
            {
                long middle = low + (high - low) / 2;
                if (IsLostAt(middle))
                    high = middle;
                else
                    low = middle;
            }

            return low;

            bool IsLostAt(long step)
            {
                Go(stepper, from, to, step);
                return Lost(from, to, step) >= 0;
            }
        }

        private Exception Name(Stepper stepper, int from, int to, long step)
        {
            int stretch = StretchOf(step);
            Go(stepper, from, to, step);
            for (int i = from; i < to && !_coasts[stretch]; i++)
            {
                Exception found = IsMeant(i, step) ? _crowd.Blame(_plan, stretch, i, _places[i], step) : null;
                if (found != null)
                    return found;
            }

            Go(stepper, from, to, step + 1);
            int lost = Lost(from, to, step + 1);
            return lost < 0 ? null : new StateOverflowException(_plan, step, _places[lost]);
        }

        private void Forward(Stepper stepper, int from, int to, long at, long step)
        {
            int stretch = StretchOf(at);
            if (_coasts[stretch])
            {
                _coasters.Put(from, to, at);
                _coasters.Follow(stepper, from, to, step);
                return;
            }

            for (long stop; at < step; at = stop, stretch++)
            {
                stop = Math.Min(step, _plan.Stretches[stretch].End);
                _crowd.Forget(from, to);
                stepper.Run(stretch, from, to, at, stop);
            }
        }

        /// <summary>Restores the states that were stored at a step.</summary>
        private void Return(int from, int to, long step)
        {
            for (int i = from; i < to; i++)
            {
                int first = i;
                while (i < to && _since[i] == step)
                    i++;

                if (i > first)
                    _crowd.Return(first, i);
            }
        }

        /// <summary>The first place whose body existed by a step and has no finite state; −1 if there is none.</summary>
        private int Lost(int from, int to, long step)
        {
            for (int i = from; i < to; i++)
            {
                int first = i;
                while (i < to && IsMeant(i, step))
                    i++;

                int lost = i > first ? _crowd.FirstLost(first, i) : -1;
                if (lost >= 0)
                    return lost;
            }

            return -1;
        }

        private bool IsMeant(int place, long step) => _since[place] <= step && (_only == All || _only == place);

        /// <summary>The end of the groups that can continue together because all were stored at one step; at least one group.</summary>
        private int EndOfAlike(int from, int to)
        {
            int end = from;
            while (end < to && (_since[end] == _since[from] || _since[end] == Nobody))
                end++;

            return Math.Max(end - end % _crowd.Width, from + _crowd.Width);
        }

        /// <summary>The first step after another at which one of the bodies was stored.</summary>
        private long Next(int from, int to, long after)
        {
            long next = Nobody;
            for (int i = from; i < to; i++)
                next = _since[i] > after ? Math.Min(next, _since[i]) : next;

            return next;
        }
    }
}
#endif
