using System;
using System.Collections.Generic;
using System.Linq;

namespace RigidBodyDynamics.Judging
{
    /// <summary>The source of the force or the torque of a frame.</summary>
    internal enum Source
    {
        /// <summary>The script's variable after the frame.</summary>
        Variable,

        /// <summary>The value that the experiment demanded: its own, or the keys'.</summary>
        Demanded,

        /// <summary>The keys' value, whatever the variable is.</summary>
        Keys,

        /// <summary>The script's variable after the frame before.</summary>
        Earlier,
    }

    /// <summary>One frame of one experiment, prepared for fitting.</summary>
    internal sealed class Observation
    {
        private readonly Frame _frame;

        public Observation(Run run, int index)
        {
            Run = run;
            Index = index;
            _frame = run.Frames[index];
            Time = _frame.Input.Time;
            Delta = _frame.Input.Delta;
            IsVaried = run.IsVaried;
            Turn = After.Orientation * Before.Orientation.Conjugate;
            IsTurnKnown = IsUsable(Before);
            Keys held = _frame.Input.Held;
            KeyForce = new Vector(Axis(held, Keys.RightArrow, Keys.LeftArrow), Axis(held, Keys.UpArrow, Keys.DownArrow), 0);
            KeyTorque = (held & Keys.R) == 0 ? Vector.Zero : Math.Sin((float)Time) * new Vector(1, 1, 1);
        }

        public Run Run { get; }

        /// <summary>The number of the frame, from 0 in its experiment.</summary>
        public int Index { get; }

        public double Time { get; }

        public double Delta { get; }

        public Snapshot Before => _frame.Before;

        public Snapshot After => _frame.After;

        /// <summary>True in an experiment that sets states, forces and torques anew, so that directions do not coincide for long.</summary>
        public bool IsVaried { get; }

        public bool IsSetAnew => _frame.IsSetAnew;

        /// <summary>True if the experiment sets no force or torque, so that the keys' values can be compared.</summary>
        public bool IsLeftToKeys => _frame.GivenForce == null && _frame.GivenTorque == null;

        /// <summary>True if R is known: the quaternions are finite, and the length of the script's own is usable.</summary>
        public bool IsTurnKnown { get; }

        public double Mass => Before.Mass ?? 1;

        public Vector Moved => After.Position - Before.Position;

        /// <summary>The rotation of the frame, in world axes.</summary>
        public Orientation Turn { get; }

        /// <summary>The rotation of the frame, in body axes.</summary>
        public Orientation TurnInBody => Before.Orientation.Conjugate * After.Orientation;

        public Vector KeyForce { get; }

        public Vector KeyTorque { get; }

        public static IReadOnlyList<Observation> Of(Recording recording) =>
            recording.Runs.SelectMany(run => Enumerable.Range(0, run.Frames.Count).Select(i => new Observation(run, i))).ToArray();

        public Vector Force(Source source) => Choose(source, After.Force, Before.Force, _frame.GivenForce, KeyForce);

        public Vector Torque(Source source) => Choose(source, After.Torque, Before.Torque, _frame.GivenTorque, KeyTorque);

        private static Vector Choose(Source source, Vector? after, Vector? before, Vector? given, Vector keys)
        {
            switch (source)
            {
                case Source.Variable: return after ?? keys;
                case Source.Earlier: return before ?? keys;
                case Source.Demanded: return given ?? keys;
                default: return keys;
            }
        }

        private static bool IsUsable(Snapshot at)
        {
            double own = at.OwnOrientation?.Length ?? 1;
            return at.Orientation.IsFinite && own > 0.5 && own < 2;
        }

        private static double Axis(Keys held, Keys plus, Keys minus) => 5 * (((held & plus) != 0 ? 1 : 0) - ((held & minus) != 0 ? 1 : 0));
    }
}
