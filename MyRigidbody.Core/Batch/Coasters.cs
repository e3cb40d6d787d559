#if NET
using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Bodies that are not stepped until their states are read: for each, the step in which it began to coast, and the step to
    /// which it has been followed. The bits are those of a single body (<see cref="Stretch{TIntegrator}"/>).
    /// </summary>
    internal sealed class Coasters
    {
        // bodies without a closed form are stepped all the way; an empty place delays no other
        private const long Never = long.MaxValue, Nobody = -1;

        private readonly Crowd _crowd;
        private readonly TimeSteps _steps;
        private readonly int _width;
        // the first for each body; the others for each group of neighbours that are stepped together
        private long[] _anchored = Array.Empty<long>(), _at = Array.Empty<long>(), _next = Array.Empty<long>();
        private Coasting _coasting;
        private int _stretch;

        public Coasters(Crowd crowd, TimeSteps steps)
        {
            _crowd = crowd;
            _steps = steps;
            _width = crowd.Width;
        }

        public void Reserve(int capacity)
        {
            int old = _anchored.Length;
            Array.Resize(ref _anchored, capacity);
            Array.Resize(ref _at, capacity / _width);
            Array.Resize(ref _next, capacity / _width);
            Array.Fill(_anchored, Nobody, old, capacity - old);
        }

        /// <summary>Begins another stretch in which the bodies coast.</summary>
        public void Begin(int stretch, in Coasting coasting)
        {
            _stretch = stretch;
            _coasting = coasting;
        }

        /// <summary>
        /// Lets bodies coast from a step at which they were stored. The other bodies of their groups have been followed to that step.
        /// </summary>
        public void Enter(int from, int to, long step)
        {
            for (int i = from; i < to; i++)
                _anchored[i] = _crowd.HasClosedForm(i, _coasting) ? step : Never;

            for (int group = from / _width; group <= (to - 1) / _width; group++)
                Settle(group, step);
        }

        /// <summary>Moves a body from one place to another; both groups have been followed to the step.</summary>
        public void Move(int from, int to, long step)
        {
            _anchored[to] = _anchored[from];
            _anchored[from] = Nobody;
            Settle(to / _width, step);
            Settle(from / _width, step);
        }

        /// <summary>True if the body in a place has a closed form.</summary>
        public bool HasForm(int place) => _anchored[place] != Never;

        /// <summary>Marks all places as empty.</summary>
        public void Clear()
        {
            Array.Fill(_anchored, Nobody);
            Array.Fill(_next, Never);
        }

        public long[][] Save() => new[] { (long[])_anchored.Clone(), (long[])_at.Clone(), (long[])_next.Clone() };

        public void Restore(long[][] saved)
        {
            _anchored = (long[])saved[0].Clone();
            _at = (long[])saved[1].Clone();
            _next = (long[])saved[2].Clone();
        }

        /// <summary>Records that bodies, in whole groups, are at a step again.</summary>
        public void Put(int from, int to, long step)
        {
            for (int group = from / _width; group < to / _width; group++)
                Settle(group, step);
        }

        /// <summary>Follows bodies, in whole groups, to a step.</summary>
        public void Follow(Stepper stepper, int from, int to, long step)
        {
            for (int group = from / _width; group < to / _width; group++)
            {
                if (_next[group] != Never && _next[group] <= step)
                    Leap(stepper, group, step);
            }

            for (int group = from / _width; group < to / _width;)
            {
                // neighbouring groups at the same step continue together
                long at = _at[group];
                int first = group;
                for (; group < to / _width && _at[group] == at; group++)
                    _at[group] = step;

                stepper.Run(_stretch, first * _width, group * _width, at, step);
            }
        }

        /// <summary>Takes a group past the closed forms that are due; stops there if all of them fall on one step.</summary>
        private void Leap(Stepper stepper, int group, long step)
        {
            int from = group * _width, to = from + _width;
            long anchored = _anchored[from], at = _at[group];
            bool isOne = anchored != Never;
            for (int i = from; i < to; i++)
                isOne &= _anchored[i] == anchored || _anchored[i] == Nobody;

            if (isOne)
            {
                long form = LastForm(anchored, at, step);
                _crowd.Leap(from, to, _steps.Between(anchored, form), _coasting);
                Settle(group, form);
                return;
            }

            // steps one by one from where the first body of the group needs it; the others join in at their own steps
            long now = step;
            for (int i = from; i < to; i++)
                now = _anchored[i] == Nobody ? now : Math.Min(now, LastForm(_anchored[i], at, step));

            while (true)
            {
                long next = step;
                for (int i = from; i < to; i++)
                {
                    long form = LastForm(_anchored[i], at, step);
                    if (form == now && form > at)
                        _crowd.Leap(i, i + 1, _steps.Between(_anchored[i], form), _coasting);
                    else if (form > now)
                        next = Math.Min(next, form);
                }

                if (now == step)
                    break;

                stepper.Run(_stretch, from, to, now, next);
                now = next;
            }

            Settle(group, step);
        }

        /// <summary>The last step up to a given one at which the body takes a closed form, or its own step if that is later or it is not there yet.</summary>
        private static long LastForm(long anchored, long at, long step) =>
            anchored == Never || anchored == Nobody || anchored > step
                ? at
                : Math.Max(at, anchored + (step - anchored) / Coasting.StepsBetweenClosedForms * Coasting.StepsBetweenClosedForms);

        private void Settle(int group, long step)
        {
            _at[group] = step;
            _next[group] = Never;
            for (int i = group * _width; i < (group + 1) * _width; i++)
            {
                if (_anchored[i] != Never && _anchored[i] != Nobody)
                {
                    long form = LastForm(_anchored[i], _anchored[i], step);
                    _next[group] = Math.Min(_next[group], form > Never - Coasting.StepsBetweenClosedForms ? Never : form + Coasting.StepsBetweenClosedForms);
                }
            }
        }
    }
}
#endif
