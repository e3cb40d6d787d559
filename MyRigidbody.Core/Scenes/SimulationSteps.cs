using System;
using System.Collections.Generic;
using System.Runtime.ExceptionServices;

namespace RigidBodyDynamics
{
    /// <summary>The steps of a simulation.</summary>
    public sealed partial class Simulation
    {
        private readonly List<Body> _stepped = new List<Body>();
        private readonly WakeQueue _dormant = new WakeQueue();
        private double _rest;

        /// <summary>The time, as a part of a step from 0 to 1, that <see cref="Advance"/> has left for the next call.</summary>
        public double Alpha => Math.Max(0, Math.Min(1, _rest / _clock.Steps.Length(Math.Min(StepsDone, _clock.Steps.Count - 1))));

        /// <summary>One step of all bodies. Allocates nothing.</summary>
        public void Step() => Step(1);

        /// <summary>Takes a number of steps of all bodies; the same bits as that many single steps, and less overhead.</summary>
        /// <exception cref="BrokenEffectException">
        /// An effect gave a force that is not finite, or threw an exception. All bodies are then in their states before that step.
        /// </exception>
        /// <exception cref="StateOverflowException">
        /// The step of a body led to no finite state. All bodies are then in their states before it. A body that coasts is not
        /// tested: the exception comes when its state is read, or when an effect begins to act on it.
        /// </exception>
        /// <exception cref="InvalidOperationException">An effect stepped the simulation that it acts in, or another thread did.</exception>
        public void Step(long count)
        {
            long left = _clock.Steps.Count - StepsDone;
            if (count < 0 || count > left)
                throw Guard.Refused(nameof(count), count, "must be from 0 to the " + left + " steps that the scene has left");

            _turnstile.Enter("simulation", Scene.Name);
            try
            {
                Run(StepsDone + count);
            }
            finally
            {
                _turnstile.Leave();
            }
        }

        /// <summary>
        /// Takes one step of a given length (s), for programs that step as often as they draw. Later steps have their usual length, and
        /// effects begin and end with the first step that starts at or after their time. Bodies that coast are stepped, too.
        /// </summary>
        /// <exception cref="InvalidOperationException">The step lengths of the simulation come from a list.</exception>
        public void StepBy(double duration)
        {
            TimeSteps.Possible(duration);
            if (_clock.Steps.AreListed)
                throw new InvalidOperationException("StepBy: the steps of this simulation have lengths from a list");

            if (StepsDone == _clock.Steps.Count)
                throw Guard.Refused(nameof(duration), duration, "must not be asked for: the scene has 0 steps left");

            _turnstile.Enter("simulation", Scene.Name);
            try
            {
                RunBy(duration);
            }
            finally
            {
                _turnstile.Leave();
            }
        }

        /// <summary>
        /// Takes the steps that a time (s) contains, for instance the time since the last frame. The rest is kept for the next call;
        /// <see cref="Alpha"/> is the rest as a part of a step, for drawing with <see cref="Body.Between"/>. Where a step fails, the steps
        /// before it have been taken, and the rest is the one before this call: no later call makes up for this one's time.
        /// </summary>
        /// <param name="elapsed">The time, s.</param>
        /// <param name="beforeStep">Called before each of the steps: loads for every step belong here.</param>
        /// <returns>How many steps were taken.</returns>
        public long Advance(double elapsed, Action beforeStep = null)
        {
            // a time this close to a step, in steps, counts as a step: 0.1 s are five steps of 0.02 s, whatever their sum rounds to
            const double Same = 1e-9;
            const double Most = 1e18;
            double rest = _rest + Guard.NotNegative(elapsed, nameof(elapsed));
            long count = 0, left = _clock.Steps.Count - StepsDone;
            if (!_clock.Steps.AreListed && rest > Most * _clock.Steps.Length(0))
                throw Guard.Refused(nameof(elapsed), elapsed, "must not be more than 1e18 steps");

            for (double length; count < left && rest >= (1 - Same) * (length = _clock.Steps.Length(StepsDone + count)); count++)
            {
                long whole = _clock.Steps.AreListed ? 1 : Math.Min(left - count, (long)(rest / length + Same));
                rest -= whole * length;
                count += whole - 1;
            }

            for (long i = 0; beforeStep != null && i < count; i++)
            {
                beforeStep();
                Step(1);
            }

            Step(beforeStep == null ? count : 0);
            _rest = rest;
            return count;
        }

        private void RunBy(double duration)
        {
            TimeSteps.Grid grid = _clock.Steps.Division;
            long step = StepsDone;
            // a step of another length cannot belong to a closed form that goes by step numbers
            try
            {
                Arrive(mayCoast: false);
            }
            catch (StateOverflowException)
            {
                foreach (Mover crowd in _crowds)
                    crowd.Arrive(mayCoast: true);

                throw;
            }

            try
            {
                _clock.Steps.Turn(step, duration);
                Run(step + 1);
                _clock.Steps.Turn(step + 1, grid.Length);
            }
            finally
            {
                if (StepsDone == step)
                    _clock.Steps.Division = grid;

                Arrive(mayCoast: true);
                // effects begin and end by the number of a step, and steps now start at other times
                foreach (Body body in _bodies)
                {
                    if (body.Plan.ChangesAfter(StepsDone - 1))
                    {
                        LoneMover last = Alone(body.Mover, body);
                        Plan(body, last.Plan.Asked, last.StateOf(body), last.Plan.MayLeaveOut);
                        ((LoneMover)body.Mover).TakeOver(last);
                    }

                    Sort(body);
                }
            }
        }

        private void Arrive(bool mayCoast)
        {
            foreach (Mover crowd in _crowds)
                crowd.Arrive(mayCoast);

            foreach (Body body in _bodies)
            {
                if (!body.Mover.HasMany)
                    body.Mover.Arrive(mayCoast);

                Sort(body);
            }
        }

        private void Run(long end)
        {
            do
            {
                long stop = end;
                for (int i = 0; i < _crowds.Count; i++)
                    stop = _crowds[i].Limit(stop);

                RunTo(stop);
            }
            while (StepsDone < end);
        }

        private void RunTo(long end)
        {
            if (_clock.SomeRest)
                LayDown();

            while (_dormant.Next < end)
                Join(_dormant.Take());

            Exception failure = null;
            for (int i = 0; i < _stepped.Count + _crowds.Count; i++)
            {
                long reached = Moving(i).Advance(end, ref failure);
                if (reached == end)
                    continue;

                // where one mover cannot go on, all go back and advance to the step that it reached
                end = reached;
                _clock.SomeRest = true;
                for (; i >= 0; i--)
                    Moving(i).GoBack();
            }

            if (end > _clock.Step)
                _clock.LastLength = _clock.Steps.Length(end - 1);

            _clock.Step = end;
            for (int i = 0; i < _crowds.Count; i++)
                _crowds[i].Stay();

            if (_clock.SomeRest)
                LayDown();

            if (failure != null)
                ExceptionDispatchInfo.Capture(failure).Throw();
        }

        private Mover Moving(int i) => i < _stepped.Count ? _stepped[i].Mover : _crowds[i - _stepped.Count];

        /// <summary>Puts a body that was changed among those that are stepped, or those that an effect will wake.</summary>
        internal void Sort(Body body)
        {
            _dormant.Remove(body);
            if (!(body.Mover is LoneMover mover))
                return;

            if (!mover.IsDormant(body))
                Join(body);
            else if (!body.IsStepped && mover.WakesAt < _clock.Steps.Count)
                _dormant.Add(mover.WakesAt, body);
        }

        private void Join(Body body)
        {
            if (!body.IsStepped)
                _stepped.Add(body);

            body.IsStepped = true;
        }

        private void LayDown()
        {
            _clock.SomeRest = false;
            int kept = 0;
            for (int i = 0; i < _stepped.Count; i++)
            {
                Body body = _stepped[i];
                body.IsStepped = !body.IsRemoved && !body.Mover.HasMany && !body.Mover.IsDormant(body);
                if (body.IsStepped)
                    _stepped[kept++] = body;
                else if (!body.IsRemoved)
                    Sort(body);
            }

            if (kept < _stepped.Count)
                _stepped.RemoveRange(kept, _stepped.Count - kept);
        }
    }
}
