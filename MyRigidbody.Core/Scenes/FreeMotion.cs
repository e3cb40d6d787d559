namespace RigidBodyDynamics
{
    /// <summary>
    /// The motion of a body without pushes, at any time in closed form, without steps: forwards, backwards, after a thousand
    /// seconds in one call. Gravity, constant forces and damping may act, as long as they act at all times.
    /// </summary>
    public sealed class FreeMotion
    {
        private readonly Coasting _coasting;
        private readonly Form _form;

        /// <summary>The motion of a body from its start, at time zero.</summary>
        /// <param name="body">Its integrator does not matter; an effect that pushes, begins, ends or goes by steps is refused.</param>
        public FreeMotion(BodyDescription body)
        {
            Guard.NotNull(body, nameof(body)).Check();
            _coasting = Coasting.Free;
            for (int i = 0; i < body.Effects.Count; i++)
            {
                Effect effect = body.Effects[i];
                if (!(effect.Coast is ICoast coast) || effect.From > 0 || !double.IsPositiveInfinity(effect.To))
                    throw Guard.Refused("effects[" + i + "]", effect.Motion, "must be gravity, a constant force or a damping that acts always");

                coast.AddTo(ref _coasting, body.Mass);
            }

            if (_coasting.LinearFactorPerStep != 1 || _coasting.AngularFactorPerStep != 1)
                throw Guard.Refused("effects", "a factor per step", "must not depend on the step");

            _coasting.Acceleration = body.Lock.Moving(_coasting.Acceleration);
            BodyDescription held = body.Copy(body.Name, Bearing.Of(body.Lock, body.Mass)?.Mass ?? body.Mass);
            _form = Rules.Exact.Use(held, new Maker(held));
        }

        /// <summary>
        /// The state at a time (s, of either sign). Costs some microseconds, near the unstable axis up to fifty. It is computed in
        /// twice the digits, so the error of an angle is that of the last bits of the inputs and a few roundings; near the unstable
        /// axis it is larger.
        /// </summary>
        public BodyState At(double time) =>
            time >= -TimeSteps.Longest && time <= TimeSteps.Longest
                ? _form.At(time, _coasting)
                : throw Guard.Refused(nameof(time), time, "must be at most 1e9 s either way");

        private sealed class Maker : IRuleUse<Form>
        {
            private readonly BodyDescription _body;

            public Maker(BodyDescription body) => _body = body;

            public Form With<TIntegrator>() where TIntegrator : struct, IIntegrator => new Form<TIntegrator>(_body);
        }

        private abstract class Form
        {
            public abstract BodyState At(double time, in Coasting coasting);
        }

        private sealed class Form<TIntegrator> : Form where TIntegrator : struct, IIntegrator
        {
            private readonly TIntegrator _start;

            public Form(BodyDescription body)
            {
                _start = default(TIntegrator);
                _start.Start(new Beginning(body));
            }

            public override BodyState At(double time, in Coasting coasting)
            {
                // one step of a copy: without pushes a step is exact for any length
                TIntegrator body = _start;
                Leap leap = default(Leap);
                body.Prepare(time, coasting);
                body.Step(new Instant(0, 0), ref leap);
                return body.State;
            }
        }
    }
}
