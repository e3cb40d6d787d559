using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>What the recordings do not reach: settings of our own, and effects that Unity does not have.</summary>
public sealed class UnityRigidbodyTests
{
    private const double Dt = 0.02;

    [Test]
    public void First_order_orientation_is_the_formula_of_the_lab()
    {
        UnitySettings settings = new() { InDouble = true, AngularDrag = 0, FirstOrderOrientation = true };
        Simulation unity = new(TimeSteps.Every(Dt), Spinning(settings)), lab = new(TimeSteps.Every(Dt), Spinning(settings, "LabEuler"));
        Simulation exact = new(TimeSteps.Every(Dt), Spinning(new UnitySettings { InDouble = true, AngularDrag = 0 }));
        unity.Step(300);
        lab.Step(300);
        exact.Step(300);
        Quaterniond q = unity.Bodies[0].State.Orientation;
        Assert.That(Samples.Apart(q, lab.Bodies[0].State.Orientation), Is.LessThan(5e-15)); // measured 2.2e-16
        Assert.That(Conserved.AngleBetween(q, exact.Bodies[0].State.Orientation), Is.GreaterThan(1e-3));
    }

    [Test]
    public void Free_body_turns_about_its_angular_velocity_by_the_exact_angle()
    {
        BodyState state = Scenery.Run(TimeSteps.Every(Dt), Spinning(new UnitySettings { InDouble = true, AngularDrag = 0 }), 300);
        Quaterniond expected = Quaterniond.FromAxisAngle(new Vector3d(1, 2, 0.5), 6 * new Vector3d(1, 2, 0.5).Length);
        Assert.That(Conserved.AngleBetween(state.Orientation, expected), Is.LessThan(1e-14)); // measured 5.1e-16
    }

    [Test]
    public void Infinite_limit_leaves_any_angular_velocity_alone_and_seven_cuts_it_to_seven()
    {
        foreach (bool inDouble in new[] { false, true })
        {
            BodyState free = Scenery.Run(TimeSteps.Every(Dt), Fast(double.PositiveInfinity, inDouble), 1);
            BodyState cut = Scenery.Run(TimeSteps.Every(Dt), Fast(7, inDouble), 1);
            Assert.That(free.AngularVelocity, Is.EqualTo(new Vector3d(300, 400, 1200)));
            Assert.That(cut.AngularVelocity.Length, Is.EqualTo(7).Within(1e-5)); // measured 3.6e-7
            Assert.That(Vector3d.Cross(cut.AngularVelocity, free.AngularVelocity).Length, Is.LessThan(5e-12)); // measured 0 in single precision, 4.7e-13 in double
        }

        static BodyDescription Fast(double limit, bool inDouble)
        {
            BodyState start = BodyState.AtRest;
            start.AngularVelocity = new Vector3d(300, 400, 1200);
            return new BodyDescription("b", Solids.Sphere(1, 1))
            {
                Rule = Rules.UnityRigidbody,
                Start = start,
                Unity = new UnitySettings { AngularDrag = 0, MaxAngularVelocity = limit, InDouble = inDouble },
            };
        }
    }

    [Test]
    public void Body_at_rest_sleeps_after_two_fifths_of_a_second_and_one_without_a_threshold_never()
    {
        foreach (bool inDouble in new[] { false, true })
        {
            Simulation tired = AtRest(0.005), restless = AtRest(0);
            tired.Step(20);
            Assert.That(tired.Bodies[0].IsAsleep, Is.False);
            tired.Step();
            Assert.That(tired.Bodies[0].IsAsleep, Is.True);
            restless.Step(1000);
            Assert.That(restless.Bodies[0].IsAsleep, Is.False);

            Simulation AtRest(double threshold) => new(TimeSteps.Every(Dt), new BodyDescription("b", Solids.Sphere(1, 1))
            {
                Rule = Rules.UnityRigidbody,
                Unity = new UnitySettings { SleepThreshold = threshold, InDouble = inDouble },
            });
        }
    }

    [Test]
    public void Sleeping_body_hangs_in_the_air_until_it_is_pushed()
    {
        // gravity begins when the body sleeps: PhysX does not wake it for that
        Simulation simulation = new(TimeSteps.Every(Dt), new BodyDescription("b", Solids.Sphere(1, 1)) { Rule = Rules.UnityRigidbody }
            .With(new Gravity(new Vector3d(0, -10, 0)), 1));
        simulation.Step(100);
        Assert.That((simulation.Bodies[0].State.Position, simulation.Bodies[0].IsAsleep), Is.EqualTo((Vector3d.Zero, true)));
        for (int step = 0; step < 10; step++)
        {
            simulation.Bodies[0].ApplyForce(new Vector3d(1, 0, 0));
            simulation.Step();
        }

        BodyState state = simulation.Bodies[0].State;
        Assert.That(simulation.Bodies[0].IsAsleep, Is.False);
        Assert.That(Samples.Apart(state.Velocity, new Vector3d(0.2, -2, 0)), Is.LessThan(2e-7)); // measured 2.7e-8
    }

    [Test]
    public void Damping_by_a_rate_comes_on_top_of_the_drag_of_Unity()
    {
        BodyState start = BodyState.AtRest;
        start.Velocity = new Vector3d(1, 0, 0);
        start.AngularVelocity = new Vector3d(0, 0, 2);
        BodyDescription body = new BodyDescription("b", Solids.Sphere(1, 1))
        {
            Rule = Rules.UnityRigidbody,
            Start = start,
            Unity = new UnitySettings { Drag = 0.5, AngularDrag = 2, InDouble = true },
        }.With(new LinearDamping(0.3)).With(new AngularDamping(0.2)).With(new DecayPerStep(0.5, 0.25));
        BodyState state = Scenery.Run(TimeSteps.Every(Dt), body, 1);
        Assert.That(state.Velocity.X, Is.EqualTo((1 - 0.5 * Dt) * Math.Exp(-0.3 * Dt) * 0.5).Within(1e-15)); // measured 0
        Assert.That(state.AngularVelocity.Z, Is.EqualTo(2 * (1 - 2 * Dt) * Math.Exp(-0.2 * Dt) * 0.25).Within(1e-15)); // measured 0
        Assert.That(state.Position.X, Is.EqualTo((1 - 0.5 * Dt) * Dt).Within(1e-15)); // measured 0
    }

    [Test]
    public void Torque_in_body_axes_is_turned_with_the_body_and_not_with_its_inertia_frame()
    {
        MassProperties mass = MassProperties.FromPrincipal(1, new Vector3d(1, 2, 2.5), new Quaterniond(0.5, 0.5, 0.5, 0.5), Vector3d.Zero);
        BodyDescription body = new BodyDescription("b", mass)
        {
            Rule = Rules.UnityRigidbody,
            Start = new BodyState(Vector3d.Zero, new Quaterniond(1, 0, 0, 1), Vector3d.Zero, Vector3d.Zero),
            Unity = new UnitySettings { AngularDrag = 0, InDouble = true },
        }.With(new Torque(new Vector3d(3, 0, 0), Vector3d.Zero, Vector3d.Zero, 0, inBody: true));
        // the frame takes principal x, y, z to body y, z, x: about body x the moment is 2.5; body x is world y
        Vector3d w = Scenery.Run(TimeSteps.Every(Dt), body, 1).AngularVelocity;
        Assert.That(Samples.Apart(w, new Vector3d(0, 3 / 2.5 * Dt, 0)), Is.LessThan(1e-16)); // measured 1.4e-17
    }

    private static BodyDescription Spinning(UnitySettings settings, string integrator = "UnityRigidbody")
    {
        BodyState start = BodyState.AtRest;
        start.AngularVelocity = new Vector3d(1, 2, 0.5);
        return new BodyDescription("b", Solids.Box(1, new Vector3d(1, 2, 3))) { Rule = Rules.Named(integrator), Start = start, Unity = settings };
    }
}
