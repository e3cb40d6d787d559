using NUnit.Framework;
using static RigidBodyDynamics.Tests.Samples;

namespace RigidBodyDynamics.Tests;

/// <summary>A force that the program applies acts in the next step like an effect that acts in that step alone.</summary>
public sealed class OneStepForceTests
{
    private const double H = 1 / 64.0;
    private static readonly Vector3d F = new(1, -2, 3), T = new(0.5, 0.25, -1), P = new(0.7, -0.4, 1.1);

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Force_and_torque_in_world_axes(string rule) => Equals(
        rule,
        body => body.With(new Force(F), 10 * H, 11 * H).With(new Torque(T, Vector3d.Zero, Vector3d.Zero, 0, inBody: false), 10 * H, 11 * H),
        body =>
        {
            body.ApplyForce(F);
            body.ApplyTorque(T);
        });

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Force_at_a_point_and_torque_in_body_axes(string rule) => Equals(
        rule,
        body => body.With(new Force(F, at: P, inBody: true), 10 * H, 11 * H).With(new Torque(T, Vector3d.Zero, Vector3d.Zero, 0, inBody: true), 10 * H, 11 * H),
        body =>
        {
            body.ApplyForce(F, P, inBody: true);
            body.ApplyTorque(T, inBody: true);
        });

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Force_at_a_point_of_the_world_is_a_force_and_its_torque_as_they_are_now(string rule)
    {
        Simulation simulation = new(TimeSteps.Every(H));
        Body atPoint = simulation.Add(Scenery.Body(rule)), atCentre = simulation.Add(Scenery.Body(rule));
        simulation.Step(10);
        Vector3d centre = atPoint.State.Position + atPoint.State.Orientation.Rotate(atPoint.Mass.CenterOfMass);
        atPoint.ApplyForce(F, P);
        atCentre.ApplyForce(F);
        atCentre.ApplyTorque(Vector3d.Cross(P - centre, F));
        simulation.Step();
        Assert.That(Distance(atPoint.State, atCentre.State), Is.LessThan(Bound(rule))); // measured 2.0e-16
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Forces_of_one_step_add_up_and_are_gone_after_it(string rule)
    {
        Simulation simulation = new(TimeSteps.Every(H));
        Body twice = simulation.Add(Scenery.Body(rule)), once = simulation.Add(Scenery.Body(rule)), free = simulation.Add(Scenery.Body(rule));
        simulation.Step(10);
        twice.ApplyForce(0.25 * F);
        twice.ApplyTorque(0.5 * T, inBody: true);
        twice.ApplyForce(0.75 * F);
        twice.ApplyTorque(0.5 * T, inBody: true);
        once.ApplyForce(F);
        once.ApplyTorque(T, inBody: true);
        simulation.Step();
        Assert.That(twice.State, Is.EqualTo(once.State));
        Assert.That(Distance(once.State, free.State), Is.GreaterThan(1e-3));

        // from here on nothing pushes: a body that comes in this state goes the same way
        BodyDescription like = Scenery.Body(rule, "like");
        like.Start = once.State;
        Body same = simulation.Add(like);
        simulation.Step(10);
        Assert.That(Distance(once.State, same.State), Is.LessThan(Bound(rule))); // measured 1.7e-7, 8.9e-16
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Force_in_many_steps_beside_effects_with_windows(string rule)
    {
        // nothing of the body's own effects is lost in the steps in which it is pushed, not at the edges of windows either
        Simulation applied = new(TimeSteps.Every(H)), acting = new(TimeSteps.Every(H));
        Body pushed = applied.Add(Busy()), bound = acting.Add(Busy().With(new Force(F, at: P, inBody: true), 4 * H, 36 * H));
        for (int n = 0; n < 64; n++)
        {
            if (n >= 4 && n < 36)
                pushed.ApplyForce(F, P, inBody: true);

            applied.Step();
            acting.Step();
            Assert.That(Distance(pushed.State, bound.State), Is.LessThan(Bound(rule)), "step " + n); // measured 0
        }

        BodyDescription Busy() => Scenery.Body(rule).With(new Gravity(new Vector3d(0, -9.81, 0)), 3 * H, 30 * H)
            .With(new Force(T), 8 * H, 20 * H).With(new LinearDamping(0.3), 20 * H, 40 * H);
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Force_in_the_first_step_of_a_window_of_a_body_that_had_coasted(string rule)
    {
        Simulation applied = new(TimeSteps.Every(H)), acting = new(TimeSteps.Every(H));
        Body pushed = applied.Add(Scenery.Body(rule).With(new Force(T), 32 * H)), bound = acting.Add(
            Scenery.Body(rule).With(new Force(T), 32 * H).With(new Force(F), 32 * H, 33 * H));
        applied.Step(32);
        acting.Step(32);
        pushed.ApplyForce(F);
        for (int n = 32; n < 40; n++)
        {
            applied.Step();
            acting.Step();
            Assert.That(Distance(pushed.State, bound.State), Is.LessThan(Bound(rule)), "step " + n); // measured 2.2e-16
        }
    }

    [TestCase("LabEuler")]
    [TestCase("Splitting")]
    [TestCase("RungeKutta4")]
    [TestCase("Exact")]
    [TestCase("Exact4")]
    [TestCase("Exact6")]
    public void Integrator_keeps_its_order_under_a_force_that_is_fixed_in_the_body(string name)
    {
        Rule rule = Rules.Named(name);
        Vector3d moments = rule.Keeps.HasFlag(Keeps.Motion) ? MeasuredOrder.Moments : MeasuredOrder.Cube;
        OrderedEffect thrust = new("thrust at " + P, (body, _, from, to) => body.With(new Force(F, at: P, inBody: true), from, to), _ => new Force(F, at: P, inBody: true));
        double order = MeasuredOrder.Of(rule.Order, Run, MeasuredOrder.Truth(moments, inWindow: false, thrust));
        TestContext.Out.WriteLine($"{order:f2}");
        Assert.That(order, Is.EqualTo(rule.Order).Within(0.15)); // off by 0.03 at most

        BodyState Run(int steps)
        {
            Simulation simulation = new(TimeSteps.Every(MeasuredOrder.Time / steps));
            Body body = simulation.Add(MeasuredOrder.Body(name, moments));
            for (int n = 0; n < steps; n++)
            {
                body.ApplyForce(F, P, inBody: true);
                simulation.Step();
            }

            return body.State;
        }
    }

    [Test]
    public void Torque_wakes_a_rotation_that_had_been_left_out()
    {
        Simulation simulation = new(TimeSteps.Every(H));
        Body body = simulation.Add(new BodyDescription("body", Solids.Box(2, new Vector3d(1, 2, 3))));
        simulation.Step(3);
        body.ApplyTorque(new Vector3d(0, 0, 2));
        Assert.That(body.Plan.LeftOut, Is.EqualTo(Omissions.Translation));
        simulation.Step();
        // ω = τ t / I, I = m (a² + b²) / 12
        Assert.That(body.State.AngularVelocity.Z, Is.EqualTo(2 * H / (2 * (1 + 4) / 12.0)).Within(1e-16));
        Assert.That(body.State.Velocity, Is.EqualTo(Vector3d.Zero));
    }

    private static void Equals(string rule, Func<BodyDescription, BodyDescription> with, Action<Body> apply)
    {
        Simulation applied = new(TimeSteps.Every(H)), acting = new(TimeSteps.Every(H));
        Body pushed = applied.Add(Scenery.Body(rule)), bound = acting.Add(with(Scenery.Body(rule)));
        double largest = 0;
        for (int n = 0; n < 40; n++)
        {
            if (n == 10)
                apply(pushed);

            applied.Step();
            acting.Step();
            largest = Math.Max(largest, Distance(pushed.State, bound.State));
        }

        TestContext.Out.WriteLine($"{largest:e1}");
        Assert.That(largest, Is.LessThan(Bound(rule))); // measured 2.2e-16
    }

    private static double Bound(string rule) => rule == "UnityRigidbody" ? 1e-5 : 1e-13;

    private static double Distance(BodyState a, BodyState b) => Math.Max(
        Math.Max(Apart(a.Position, b.Position), Conserved.AngleBetween(a.Orientation, b.Orientation)),
        Math.Max(Apart(a.Velocity, b.Velocity), Apart(a.AngularVelocity, b.AngularVelocity)));
}
