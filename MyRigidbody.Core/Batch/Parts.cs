#if NET
using System;
using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>Work on all bodies of a batch, part by part, by the threads of a team.</summary>
    internal sealed class Parts
    {
        // testing whether all states are finite takes twice as long as the shortest step
        public const long StepsBetweenLooks = 64;

        // enough work to wake a thread for, few enough bodies to stay in its cache
        public const int BodiesOfPart = 1024;

        private readonly Crowd _crowd;
        private readonly Coasters _coasters;
        private readonly Retrace _retrace;
        private readonly Places _places;
        private readonly Team<Stepper> _team;
        private readonly SortedSet<int> _failed = new SortedSet<int>();
        private Task _task;
        private int _stretch;
        private bool _coasts, _looksAtStop;
        private long _first, _stop;
        private BodyState[] _states;

        public Parts(BodyPlan plan, Crowd crowd, Coasters coasters, Retrace retrace, Places places)
        {
            _crowd = crowd;
            _coasters = coasters;
            _retrace = retrace;
            _places = places;
            _team = new Team<Stepper>(() => _crowd.NewStepper(plan), Work);
        }

        /// <summary>The largest number of threads that work at a time.</summary>
        public int Threads
        {
            get => _team.Threads;
            set => _team.Threads = value;
        }

        /// <summary>The stepper of the calling thread.</summary>
        public Stepper Own => _team.Own;

        /// <summary>True if, since the last <see cref="FindLost"/>, some body could not do its work or had no finite state.</summary>
        public bool AnyFailed => _failed.Count > 0;

        public void Begin(int stretch, bool coasts)
        {
            _stretch = stretch;
            _coasts = coasts;
        }

        /// <summary>Steps the bodies and tests their states now and then; at the last step if requested, or if many steps came before.</summary>
        public void Step(long first, long stop, bool looksAtStop)
        {
            _first = first;
            _looksAtStop = looksAtStop;
            Do(Task.Step, stop);
        }

        /// <summary>Follows bodies that coast to a step, and tests their states.</summary>
        public void Follow(long step) => Do(Task.Follow, step);

        /// <summary>Follows them, and writes the states of all that have one.</summary>
        public void Read(long step, BodyState[] states)
        {
            _states = states;
            Do(Task.Read, step);
            _states = null;
        }

        /// <summary>Stores the bodies, whose states have been tested, at a step.</summary>
        public void Keep(long step) => Do(Task.Keep, step);

        /// <summary>Brings the bodies from where they were stored to a step.</summary>
        public void GoBack(long step) => Do(Task.GoBack, step);

        /// <summary>The exception of the first body that failed, and its step before an end; see <see cref="Retrace.Find(Stepper, int, int, ref long)"/>.</summary>
        public Exception FindLost(ref long end)
        {
            Exception found = null;
            foreach (int part in _failed)
                found = _retrace.Find(_team.Own, part * BodiesOfPart, EndOfGroups(part), ref end) ?? found;

            _failed.Clear();
            return found;
        }

        private void Do(Task task, long stop)
        {
            _task = task;
            _stop = stop;
            _team.Do((_places.Count + BodiesOfPart - 1) / BodiesOfPart);
        }

        private void Work(Stepper stepper, int part)
        {
            int from = part * BodiesOfPart, to = EndOfPart(part), whole = EndOfGroups(part);
            if (_task == Task.Step)
                Step(stepper, part, from, to, whole);
            else if (_task == Task.GoBack)
                _retrace.Go(stepper, from, whole, _stop);
            else if (_task == Task.Keep)
                Keep(from, to);
            else if (_coasts)
                _coasters.Follow(stepper, from, whole, _stop);

            if ((_task == Task.Follow && _crowd.FirstLost(from, to) >= 0) || (_task == Task.Read && !_crowd.Read(from, to, _places, _states)))
                Fail(part);
        }

        private void Step(Stepper stepper, int part, int from, int to, int whole)
        {
            for (long first = _first, next; first < _stop; first = next)
            {
                next = first + Math.Min(_stop - first, StepsBetweenLooks - first % StepsBetweenLooks);
                bool looks = next % StepsBetweenLooks == 0 || next - _first >= StepsBetweenLooks || (next == _stop && _looksAtStop);
                try
                {
                    stepper.Run(_stretch, from, whole, first, next);
                    if (!looks || _crowd.FirstLost(from, to) < 0)
                        continue;
                }
                catch (Exception)
                {
                    // the exception of an effect; found again when the steps are repeated
                }

                Fail(part);
                return;
            }
        }

        private void Keep(int from, int to)
        {
            _retrace.Keep(from, to, _stop);
            if (_coasts)
                _coasters.Enter(from, to, _stop);
        }

        private void Fail(int part)
        {
            lock (_failed)
                _failed.Add(part);
        }

        private int EndOfPart(int part) => Math.Min(_places.Count, (part + 1) * BodiesOfPart);

        private int EndOfGroups(int part) => (EndOfPart(part) + _crowd.Width - 1) / _crowd.Width * _crowd.Width;

        private enum Task
        {
            Step,
            Follow,
            Read,
            Keep,
            GoBack,
        }
    }
}
#endif
