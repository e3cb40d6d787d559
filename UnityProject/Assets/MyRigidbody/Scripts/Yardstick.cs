using System;
using System.Diagnostics;

namespace RigidBodyDynamics.Scripts
{
    /// <summary>
    /// Measures cost and error of a body's integrator: the time of a step, and the difference between the body and the exact motion.
    /// </summary>
    internal sealed class Yardstick
    {
        // Exact6 with a quarter of the step: its own error is below the resolution of a float
        private const int Parts = 4;
        private const int Timed = 200;

        private readonly MyRigidbody _body;
        private Simulation _watched, _exact;
        private BodyDescription _described;

        public Yardstick(MyRigidbody body) => _body = body;

        /// <summary>The measured body.</summary>
        public MyRigidbody Body => _body;

        /// <summary>Time of one step of the library, ns; the shortest of all measurements, because disturbances only add time.</summary>
        public double NanosecondsPerStep { get; private set; }

        /// <summary>Angle to the exact motion, rad.</summary>
        public double AngleError { get; private set; }

        /// <summary>Distance to the exact motion, m.</summary>
        public double DistanceError { get; private set; }

        /// <summary>Called after every step of the body.</summary>
        public void Follow()
        {
            if (!_body.IsReady)
                return;

            if (_watched != _body.Simulation)
                Begin();
            else if (_described != _body.Description)
                GoOn();

            double part = _body.StepLength / Parts;
            long behind = Parts * _watched.StepsDone - _exact.StepsDone;
            bool isSteady = part == _exact.Scene.Steps.Length(0);
            if (isSteady)
                _exact.Step(Math.Max(0, behind));

            for (; !isSteady && behind > 0; behind--)
                _exact.StepBy(part);

            BodyState exact = _exact.Bodies[0].State, found = _body.State;
            AngleError = Conserved.AngleBetween(exact.Orientation, found.Orientation);
            DistanceError = (exact.Position - found.Position).Length;
        }

        /// <summary>Times some steps and restores the state of the body.</summary>
        public void TakeTime()
        {
            if (!_body.IsReady)
                return;

            Simulation simulation = _body.Simulation;
            SavedSimulation now = simulation.Save();
            Stopwatch clock = Stopwatch.StartNew();
            for (int step = 0; step < Timed; step++)
            {
                // a body that coasts is computed when its state is read
                simulation.Step();
                _ = simulation.Bodies[0].State;
            }

            double nanoseconds = 1e9 * clock.ElapsedTicks / Stopwatch.Frequency / Timed;
            simulation.Restore(now);
            NanosecondsPerStep = NanosecondsPerStep > 0 ? Math.Min(NanosecondsPerStep, nanoseconds) : nanoseconds;
        }

        private void Begin()
        {
            _watched = _body.Simulation;
            NanosecondsPerStep = 0;
            _exact = new Simulation(TimeSteps.Every(_body.StepLength / Parts), Exact());
        }

        /// <summary>Called when the body was changed: both continue from the same state.</summary>
        private void GoOn()
        {
            BodyDescription exact = Exact();
            _exact.Bodies[0].Change(exact);
            _exact.Bodies[0].State = exact.Start;
            NanosecondsPerStep = 0;
        }

        private BodyDescription Exact()
        {
            BodyDescription found = _described = _body.Description;
            BodyDescription exact = found.Copy("exact", found.Mass).Without(effect => effect.Motion is DecayPerStep);
            exact.Rule = Rules.Exact6;
            if (_body.damping == DampingKind.FactorPerStep)
            {
                // the factor as a rate: the limit of the lab's integrator for short steps
                double step = _body.StepLength;
                exact.With(new LinearDamping(Rate(_body.linearDecay, step))).With(new AngularDamping(Rate(_body.angularDecay, step)));
            }

            return exact;
        }

        // a factor of zero stops at once; the rate that does so in one step to the last bit is 1e3 times its inverse
        private static double Rate(double factor, double step) => factor > 0 ? -Math.Log(factor) / step : 1e3 / step;
    }
}
