using System;
using System.Globalization;

namespace RigidBodyDynamics
{
    /// <summary>
    /// An effect gave a force or torque that is not finite, or threw an exception (<see cref="Exception.InnerException"/>).
    /// All bodies are in their states before that step.
    /// </summary>
    public sealed class BrokenEffectException : ArithmeticException
    {
        private readonly string _where;

        internal BrokenEffectException(BodyDescription body, Effect effect, in Instant now, Exception thrown)
            : base(Guard.OneLine("body \"" + body.Name + "\": effects[" + body.IndexOf(effect) + "]: " + Why(effect, now, thrown)), thrown)
        {
            _where = "effects[" + body.IndexOf(effect) + "]: ";
            Body = body.Name;
            Number = -1;
            Effect = effect.Motion;
            Entry = effect;
            Time = now.Time;
            Reason = Why(effect, now, thrown);
        }

        /// <summary>The same for a body that is stored with others.</summary>
        internal BrokenEffectException(BrokenEffectException broken, Body handle)
            : base(Guard.OneLine("body \"" + handle.Name + "\" " + handle.Index.ToString(CultureInfo.InvariantCulture) + ": " + broken._where + broken.Reason), broken.InnerException)
        {
            _where = broken._where;
            Body = handle.Name;
            Handle = handle;
            Number = handle.Index;
            Effect = broken.Effect;
            Entry = broken.Entry;
            Time = broken.Time;
            Reason = broken.Reason;
        }

        /// <summary>Name of the body.</summary>
        public string Body { get; }

        /// <summary>The body itself, where it is stored with others; null where it is not.</summary>
        public Body Handle { get; }

        /// <summary>The index of <see cref="Handle"/> in <see cref="Simulation.Bodies"/>; −1 where there is none.</summary>
        public int Number { get; }

        /// <summary>The effect.</summary>
        public object Effect { get; }

        /// <summary>The effect with the time in which it acts, as in the body's description.</summary>
        public Effect Entry { get; }

        /// <summary>The time of the failed evaluation, s.</summary>
        public double Time { get; }

        /// <summary>The message without the body, the effect and the time.</summary>
        public string Reason { get; }

        private static string Why(Effect effect, in Instant now, Exception thrown) => Guard.OneLine(string.Format(
            CultureInfo.InvariantCulture,
            "must push with a finite force and torque, and {0} at t = {1:R} s, in step {2} ({3})",
            thrown == null ? "did not" : "threw " + thrown.GetType().Name + " (" + thrown.Message + ")",
            now.Time, now.Step, effect.Motion));
    }
}
