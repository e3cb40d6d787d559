using System;
using System.Globalization;

namespace RigidBodyDynamics
{
    /// <summary>A push that is looked at: what it gives must be finite, and it must give something.</summary>
    internal sealed class Watched : IPush
    {
        private readonly PushEffect _effect;
        private readonly BodyDescription _body;

        public Watched(PushEffect effect, BodyDescription body)
        {
            _effect = effect;
            _body = body;
        }

        public PushTraits Traits => _effect.Push.Traits;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench)
        {
            bool was = wrench.IsFinite;
            try
            {
                _effect.Push.At(now, body, mass, ref wrench);
            }
            catch (Exception thrown)
            {
                throw Broken(now, thrown);
            }

            Look(now, body, was, wrench);
        }

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse)
        {
            bool was = impulse.IsFinite;
            try
            {
                _effect.Push.Over(now, duration, body, mass, ref impulse);
            }
            catch (Exception thrown)
            {
                throw Broken(now, thrown);
            }

            Look(now, body, was, impulse);
        }

        /// <summary>Where the state had gone to infinity before, the rule is to blame and not the effect.</summary>
        private void Look(in Instant now, in BodyState body, bool was, in Wrench given)
        {
            if (was && body.IsFinite && !given.IsFinite)
                throw Broken(now, null);
        }

        private BrokenEffectException Broken(in Instant now, Exception thrown) =>
            new BrokenEffectException(_body.Name, _body.IndexOf(_effect), _effect.Push, now, thrown);
    }

    /// <summary>
    /// An effect gave a force or torque that is not finite, or threw an exception (<see cref="Exception.InnerException"/>).
    /// The simulation stands before the step in which it did.
    /// </summary>
    public sealed class BrokenEffectException : ArithmeticException
    {
        internal BrokenEffectException(string body, int effect, IPush push, in Instant now, Exception thrown)
            : base(Line(body, effect, push, now, thrown), thrown)
        {
            Body = body;
            Effect = push;
            Time = now.Time;
        }

        /// <summary>Name of the body.</summary>
        public string Body { get; }

        /// <summary>The effect.</summary>
        public object Effect { get; }

        /// <summary>When it was asked, s.</summary>
        public double Time { get; }

        private static string Line(string body, int effect, IPush push, in Instant now, Exception thrown) => string.Format(
            CultureInfo.InvariantCulture,
            "body \"{0}\": effects[{1}]: must push with a finite force and torque, and {2} at t = {3:R} s, in step {4} ({5})",
            body,
            effect,
            thrown == null ? "did not" : "threw " + thrown.GetType().Name + " (" + thrown.Message + ")",
            now.Time,
            now.Step,
            push).Replace('\r', ' ').Replace('\n', ' ');
    }
}
