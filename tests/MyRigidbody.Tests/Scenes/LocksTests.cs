using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>A body with locked axes does not move along or about them, and obeys the laws along and about the others.</summary>
public sealed class LocksTests
{
    private const Locks Hinge = Locks.TurnX | Locks.TurnZ;
    private static readonly Quaterniond Frame = new Quaterniond(0.9, 0.1, -0.3, 0.2).Normalized, Tilt = new Quaterniond(0.4, -0.3, 0.5, 0.7).Normalized;
    private static readonly Vector3d Moments = new(1, 2, 2.5);

    private static IEnumerable<string> Rule => Scenery.Integrators;

    [Test]
    public void Projectile_on_rails_flies_its_parabola_along_the_rest()
    {
        BodyDescription body = Tilted("Exact", Locks.MoveX, new Vector3d(0, 4, -1), new Vector3d(1, 2, 3)).With(new Gravity(new Vector3d(3, -9.81, 0.5)));
        BodyState end = Scenery.Run(TimeSteps.Every(1.0 / 64), body, 128);
        Vector3d center = Tilt.Rotate(body.Mass.CenterOfMass), found = end.Position + end.Orientation.Rotate(body.Mass.CenterOfMass) - center;

        Assert.That((end.Velocity - new Vector3d(0, 4 - 2 * 9.81, -1 + 1)).Length, Is.LessThan(1e-14)); // measured 0
        Assert.That((found - new Vector3d(0, 4 * 2 - 2 * 9.81, -2 + 1)).Length, Is.LessThan(1e-14)); // measured 2.8e-17
    }

    [TestCase("Exact")]
    [TestCase("Exact4")]
    [TestCase("Exact6")]
    public void Box_in_a_hinge_turns_about_it_as_a_point_moves_on_a_line(string rule)
    {
        Vector3d hinge = (Tilt * Frame).Rotate(new Vector3d(0, 1, 0)), torque = new(0.3, -0.8, 0.5);
        BodyDescription body = Tilted(rule, Hinge | Locks.Move, Vector3d.Zero, 0.7 * hinge).With(Torque.Constant(torque));
        BodyState end = Scenery.Run(TimeSteps.Every(1.0 / 64), body, 256);

        // e stays in the body and in the world, so ω' = τ·e / (e·I e)
        double acceleration = Vector3d.Dot(torque, hinge) / Moments.Y, angle = 0.7 * 4 + 8 * acceleration;
        Quaterniond turn = new Quaterniond(Math.Cos(angle / 2), Math.Sin(angle / 2) * hinge);
        Assert.That((end.AngularVelocity - (0.7 + 4 * acceleration) * hinge).Length, Is.LessThan(1e-14)); // measured 5.8e-16
        Assert.That(Conserved.AngleBetween(end.Orientation, turn * Tilt), Is.LessThan(1e-14)); // measured 1.1e-15
    }

    [TestCase(Locks.TurnY)]
    [TestCase(Hinge)]
    public void What_nothing_turns_goes_on_about_an_axis_that_stays_in_body_and_world(Locks locked)
    {
        Vector3d spin = (Tilt * Frame).Rotate(locked == Hinge ? new Vector3d(0, 2, 0) : new Vector3d(2, 0, -1));
        BodyDescription body = Tilted("Exact", locked, new Vector3d(1, 2, 3), spin).With(new AngularDamping(0.5));
        BodyState byStep = Scenery.Run(TimeSteps.Every(0.25), body, 12), atOnce = new FreeMotion(body).At(3);

        double left = Math.Exp(-1.5), angle = spin.Length * (1 - left) / 0.5;
        Quaterniond turn = new Quaterniond(Math.Cos(angle / 2), Math.Sin(angle / 2) / spin.Length * spin);
        foreach (BodyState end in new[] { byStep, atOnce })
        {
            Assert.That((end.AngularVelocity - left * spin).Length, Is.LessThan(1e-15)); // measured 0
            Assert.That(Conserved.AngleBetween(end.Orientation, turn * Tilt), Is.LessThan(2e-15)); // measured 3.7e-16
        }
    }

    [TestCaseSource(nameof(Rule))]
    public void One_locked_axis_is_followed_at_the_order_of_the_integrator(string rule)
    {
        int order = Scenery.Body(rule).Rule.Order, steps = order == 6 ? 4 : 64 / order;
        double coarse = Miss(rule, steps), fine = Miss(rule, 2 * steps);
        TestContext.Out.WriteLine(FormattableString.Invariant($"{rule}: {coarse:g2}, {fine:g2}, order {Math.Log2(coarse / fine):g3}"));
        Assert.That(Math.Log2(coarse / fine), Is.EqualTo(order).Within(0.1)); // measured 3.98 to 4.04 where 4, 6.01 where 6
    }

    [TestCaseSource(nameof(Rule))]
    public void Force_along_a_locked_axis_does_nothing_not_even_to_what_reads_the_velocity(string rule)
    {
        BodyState With(double y)
        {
            BodyDescription body = Tilted(rule, Locks.MoveY | Locks.TurnZ, new Vector3d(1, 0, 2), Vector3d.Zero)
                .With(new Force(new Vector3d(0, y, 1))).With(new QuadraticDrag(0.3)).With(new Gravity(new Vector3d(0, y, 0)));
            Simulation simulation = new(TimeSteps.Every(0.02), body);
            for (int step = 0; step < 50; step++)
            {
                simulation.Bodies[0].ApplyForce(new Vector3d(1, y, 0));
                simulation.Bodies[0].ApplyTorque(new Vector3d(0.1, 0, 0.2));
                simulation.Step();
            }

            return simulation.Bodies[0].State;
        }

        Assert.That(With(100), Is.EqualTo(With(0)));
    }

    [TestCaseSource(nameof(Rule))]
    public void Off_centre_impulse_moves_and_turns_what_is_free(string rule)
    {
        BodyDescription body = Tilted(rule, Locks.MoveX | Hinge, Vector3d.Zero, Vector3d.Zero);
        Body pushed = new Simulation(TimeSteps.Every(0.02), body).Bodies[0];
        Vector3d impulse = new(1, -2, 0.5), arm = new(0.3, 0.4, -0.2), center = Tilt.Rotate(body.Mass.CenterOfMass);
        Vector3d hinge = (Tilt * Frame).Rotate(new Vector3d(0, 1, 0));
        pushed.ApplyImpulse(impulse, center + arm);

        double rounding = rule == "UnityRigidbody" ? 1e-6 : 2e-15; // measured 2.8e-7, 7.1e-16
        Assert.That((pushed.State.Velocity - new Vector3d(0, -1, 0.25)).Length, Is.LessThanOrEqualTo(rounding));
        Assert.That((pushed.State.AngularVelocity - Vector3d.Dot(Vector3d.Cross(arm, impulse), hinge) / Moments.Y * hinge).Length, Is.LessThan(rounding));
        double work = 0.5 * 2 * (1 + 0.0625) + 0.5 * Moments.Y * pushed.State.AngularVelocity.LengthSquared;
        Assert.That(pushed.KineticEnergy, Is.EqualTo(work).Within(4 * rounding));
    }

    [Test]
    public void Load_of_one_step_is_held_too()
    {
        Simulation simulation = new(TimeSteps.Every(0.5));
        Body added = simulation.Add(new BodyDescription("b", MassProperties.FromPrincipal(2, Moments)) { Lock = Locks.MoveZ | Locks.TurnX | Locks.TurnY });
        added.ApplyForce(new Vector3d(4, 0, 7), new Vector3d(0, 1, 0));
        added.ApplyTorque(new Vector3d(5, 5, 9));
        simulation.Step(2);

        Assert.That(added.State.Velocity, Is.EqualTo(new Vector3d(1, 0, 0)));
        Assert.That(added.State.AngularVelocity, Is.EqualTo(new Vector3d(0, 0, (9 - 4) * 0.5 / 2.5)));
    }

    [Test]
    public void Effect_sees_the_moments_of_the_body_itself()
    {
        BodyDescription body = Tilted("Exact6", Locks.TurnX, Vector3d.Zero, (Tilt * Frame).Rotate(new Vector3d(0, 1, 2))).With(new Brake()).With(Torque.Constant(new Vector3d(1e-9, 0, 0)));
        BodyState end = Scenery.Run(TimeSteps.Every(1.0 / 64), body, 64);
        Assert.That(end.AngularVelocity.Length, Is.EqualTo(Math.Exp(-1) * Math.Sqrt(5)).Within(1e-8)); // measured 5.9e-11
    }

    [Test]
    public void Change_locks_and_unlocks_while_it_runs()
    {
        Simulation simulation = new(TimeSteps.Every(0.5));
        BodyDescription free = new("b", MassProperties.FromPrincipal(2, Moments)) { Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(1, 2, 3), new Vector3d(1, 2, 3)) };
        Body body = simulation.Add(free);
        BodyDescription locked = free.Copy("b", free.Mass);
        locked.Lock = Locks.MoveY | Locks.TurnX;
        body.Change(locked);
        Assert.That((body.State.Velocity, body.State.AngularVelocity), Is.EqualTo((new Vector3d(1, 0, 3), new Vector3d(0, 2, 3))));

        body.Change(free);
        body.ApplyImpulse(new Vector3d(0, 2, 0));
        Assert.That(body.State.Velocity, Is.EqualTo(new Vector3d(1, 1, 3)));
    }

    [Test]
    public void State_that_moves_along_a_locked_axis_is_refused_by_name_and_value()
    {
        Body body = new Simulation(TimeSteps.Every(0.5), Tilted("Exact", Locks.MoveX | Locks.MoveZ | Locks.TurnY, Vector3d.Zero, Vector3d.Zero)).Bodies[0];
        BodyState before = body.State, state = before;
        state.Velocity = new Vector3d(0, 1, 1e-9);
        Assert.That(() => body.State = state, Throws.InstanceOf<ArgumentException>().With.Message.EqualTo("velocity: must be zero along the locked x and z, found (0, 1, 1E-09)"));

        state.Velocity = new Vector3d(0, 1, 0);
        state.AngularVelocity = (Tilt * Frame).Rotate(new Vector3d(1, 1e-6, 0));
        Assert.That(() => body.State = state, Throws.InstanceOf<ArgumentException>().With.Message.StartsWith("angularVelocity: must be zero about the locked y, found ("));
        Assert.That(body.State, Is.EqualTo(before));

        state.AngularVelocity = (Tilt * Frame).Rotate(new Vector3d(1, 0, -2));
        body.State = state;
        Assert.That((body.State.AngularVelocity - state.AngularVelocity).Length, Is.LessThan(1e-15)); // measured 0
    }

    [TestCase(Locks.TurnX)]
    [TestCase(Locks.TurnY)]
    [TestCase(Locks.MoveZ | Locks.TurnX | Locks.TurnZ)]
    public void State_of_a_body_in_single_precision_can_be_set_to_itself(Locks locks)
    {
        Simulation simulation = new(TimeSteps.Every(0.02), Tilted("UnityRigidbody", locks, Vector3d.Zero, Vector3d.Zero));
        Body body = simulation.Bodies[0];
        for (int step = 0; step < 500; step++)
        {
            body.ApplyTorque(new Vector3d(Math.Sin(step), 2, 3), inBody: true);
            simulation.Step();
            BodyState state = body.State;
            state.Position = new Vector3d(step, 1, 2);
            Assert.That(() => body.State = state, Throws.Nothing); // about the locked axis turned 3.8e-7 of the spin, measured; 1e-5 is taken for zero
            Assert.That(body.State.AngularVelocity, Is.EqualTo(state.AngularVelocity));
        }
    }

    [Test]
    public void Explanation_says_what_is_locked()
    {
        BodyDescription body = Tilted("Exact", Locks.MoveZ | Hinge, new Vector3d(1, 0, 0), Vector3d.Zero).With(Torque.Constant(new Vector3d(0, 1, 0)));
        BodyPlan plan = new Simulation(TimeSteps.Every(0.5), body).Bodies[0].Plan;
        Explanation explanation = new(plan);
        Assert.That(explanation.Parts(plan.Stretches[0]).Take(2), Is.EqualTo(new[] { "drift along x and y", "rotation about y (exact)" }));
        Assert.That(explanation.ToString(), Does.Contain("left out: motion along z (locked)").And.Contain("left out: rotation about x and z (locked)"));
    }

    [Test]
    public void Gravity_along_a_locked_axis_moves_nothing_and_a_body_at_rest_is_not_charged_for_it()
    {
        BodyDescription body = new BodyDescription("b", Solids.Sphere(1, 1)) { Lock = Locks.MoveY }.With(new Gravity(new Vector3d(0, -9.81, 0)));
        Assert.That(new Simulation(TimeSteps.Every(0.5), body).Bodies[0].Plan.LeftOut, Is.EqualTo(Omissions.Translation | Omissions.Rotation));
    }

    private static BodyDescription Tilted(string rule, Locks locked, Vector3d velocity, Vector3d angularVelocity)
    {
        BodyDescription like = Scenery.Body(rule);
        like.Unity.Drag = like.Unity.AngularDrag = like.Unity.SleepThreshold = 0;
        return new BodyDescription("b", MassProperties.FromPrincipal(2, Moments, Frame, new Vector3d(0.1, -0.2, 0.3)))
        {
            Rule = like.Rule,
            Unity = like.Unity,
            Lock = locked,
            Start = new BodyState(Vector3d.Zero, Tilt, velocity, angularVelocity),
        };
    }

    /// <summary>The difference of a body with one locked axis from the independent solution after a second, under a torque of the world and one of the body.</summary>
    private static double Miss(string rule, int steps)
    {
        Vector3d world = new(0.8, -1, 0.6), body = new(0.4, 0.3, 1.2), start = new(0, 0.6, -0.9);
        BodyState end = Scenery.Run(
            TimeSteps.Every(1.0 / steps),
            Tilted(rule, Locks.TurnX | Locks.Move, Vector3d.Zero, (Tilt * Frame).Rotate(start)).With(Torque.Constant(world)).With(new Torque(Vector3d.Zero, body, Vector3d.Zero, 2, inBody: true)),
            steps);
        return Conserved.AngleBetween(end.Orientation, Suslov(world, Frame.Conjugate.Rotate(body), start) * Frame.Conjugate);
    }

    /// <summary>
    /// I₂ ω₂' = τ₂, I₃ ω₃' = τ₃, ω₁ = 0 and q' = q [0, ω/2] in principal axes, by a plain Runge–Kutta rule in ten thousand steps:
    /// d'Alembert's equations of the constrained body, none of the library's.
    /// </summary>
    private static Quaterniond Suslov(Vector3d world, Vector3d inBody, Vector3d w)
    {
        const int Steps = 10000;
        Quaterniond q = (Tilt * Frame).Normalized;
        for (int n = 0; n < Steps; n++)
        {
            const double H = 1.0 / Steps;
            (Quaterniond q1, Vector3d w1) = Rate(q, w, n * H);
            (Quaterniond q2, Vector3d w2) = Rate(q + 0.5 * H * q1, w + 0.5 * H * w1, (n + 0.5) * H);
            (Quaterniond q3, Vector3d w3) = Rate(q + 0.5 * H * q2, w + 0.5 * H * w2, (n + 0.5) * H);
            (Quaterniond q4, Vector3d w4) = Rate(q + H * q3, w + H * w3, (n + 1) * H);
            q = (q + H / 6 * (q1 + 2 * (q2 + q3) + q4)).Normalized;
            w += H / 6 * (w1 + 2 * (w2 + w3) + w4);
        }

        return q;

        (Quaterniond Turning, Vector3d Acceleration) Rate(Quaterniond at, Vector3d spin, double t)
        {
            Vector3d torque = at.Normalized.RotateInverse(world) + Math.Sin(2 * t) * inBody;
            return (0.5 * (at * new Quaterniond(0, spin)), new Vector3d(0, torque.Y / Moments.Y, torque.Z / Moments.Z));
        }
    }

    /// <summary>−L, so that ω falls as exp(−t) whatever the moments.</summary>
    private readonly struct Brake : IPush
    {
        public EffectTraits Traits => EffectTraits.Turns | EffectTraits.ReadsAngularVelocity | EffectTraits.ReadsOrientation;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) =>
            wrench.Torque -= Conserved.AngularMomentum(body, mass);

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) =>
            impulse.Torque += (Math.Exp(-duration) - 1) * Conserved.AngularMomentum(impulse.AppliedTo(body, mass), mass);
    }
}
