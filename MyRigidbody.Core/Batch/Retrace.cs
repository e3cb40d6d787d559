#if NET
using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// The way back from where a body was lost. Every body is kept as it was at some step; from there the same steps once more,
    /// to the same bits, say which body was the first, in which step, and under which effect.
    /// </summary>
    internal sealed class Retrace
    {
        // of a place where no body is
        private const long Nobody = long.MaxValue;
        private const int All = -1;

        private readonly BodyPlan _plan;
        private readonly Crowd _crowd;
        private readonly Coasters _coasters;
        private readonly Places _places;
        private readonly bool[] _coasts;
        private long[] _since = Array.Empty<long>();
        private int _only = All;

        /// <param name="plan">What the bodies do.</param>
        /// <param name="crowd">The bodies.</param>
        /// <param name="coasters">Those of them that coast.</param>
        /// <param name="places">Knows the bodies' numbers.</param>
        /// <param name="coasts">Of each stretch, whether bodies coast in it. They are kept where such a one begins and ends.</param>
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

        /// <summary>Keeps bodies as they are at a step. They have been looked at.</summary>
        public void Keep(int from, int to, long step)
        {
            _crowd.Keep(from, to);
            Array.Fill(_since, step, from, to - from);
        }

        /// <summary>A body goes from one place to another, with what is kept of it.</summary>
        public void Move(int from, int to)
        {
            _since[to] = _since[from];
            _since[from] = Nobody;
        }

        /// <summary>The step at which a body was kept.</summary>
        public long Since(int place) => _since[place];

        /// <summary>Nobody is anywhere.</summary>
        public void Clear() => Array.Fill(_since, Nobody);

        public long[] Save() => (long[])_since.Clone();

        public void Restore(long[] since) => _since = (long[])since.Clone();

        /// <summary>The stretch in which a step is.</summary>
        public int StretchOf(long step)
        {
            int stretch = 0;
            while (stretch + 1 < _coasts.Length && _plan.Stretches[stretch].End <= step)
                stretch++;

            return stretch;
        }

        /// <summary>Takes bodies, in whole groups, from where they were kept to a step, if they were there by then.</summary>
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
        /// The exception that one of the bodies in whole groups has to answer for, and the step, before an end, that did not lead it to
        /// a state; null if there is none. The bodies are then anywhere.
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

        /// <summary>The same of one body alone, whatever became of those in its group.</summary>
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
                    // an effect's; asked for it again when it is named
                    return step;
                }

                Return(from, to, step + 1);
                if (Lost(from, to, step + 1) >= 0)
                    return step;
            }

            return end;
        }

        /// <summary>Far from where they were kept those who coast are soon, so between two such places the half way is tried.</summary>
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

        /// <summary>Puts back what was kept at a step.</summary>
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

        /// <summary>The first place whose body is there by a step and has run away; −1 if none has.</summary>
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

        /// <summary>The end of as many groups as can go together because all in them were kept at one step; one group at least.</summary>
        private int EndOfAlike(int from, int to)
        {
            int end = from;
            while (end < to && (_since[end] == _since[from] || _since[end] == Nobody))
                end++;

            return Math.Max(end - end % _crowd.Width, from + _crowd.Width);
        }

        /// <summary>The first step after another at which one of the bodies was kept.</summary>
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
