using NUnit.Framework;
using static RigidBodyDynamics.Tests.Samples;

namespace RigidBodyDynamics.Tests;

/// <summary>An impulse at a point gives a body its momentum, and its moment about any point of the world; at once, and for good.</summary>
public sealed class ApplyImpulseTests
{
    private static readonly Vector3d J = new(3, -1, 2), Point = new(0.7, -0.4, 1.1), Turn = new(0.5, 0.25, -2);

    private static IEnumerable<TestCaseData> Cases =>
        from rule in Scenery.Integrators
        from body in PointBody.All
        select new TestCaseData(rule, body).SetArgDisplayNames(rule, body.Name);

    [TestCaseSource(nameof(Cases))]
    public void Impulse_at_a_point_of_the_world(string rule, PointBody points) =>
        Gains(rule, points, J, Vector3d.Cross(Point, J), body => body.ApplyImpulse(J, Point));

    [TestCaseSource(nameof(Cases))]
    public void Impulse_at_a_point_of_the_body(string rule, PointBody points)
    {
        BodyState there = default;
        Gains(
            rule,
            points,
            state => World(state) * J,
            state => Vector3d.Cross(state.Position + World(state) * Point, World(state) * J),
            body =>
            {
                there = body.State;
                body.ApplyImpulse(J, Point, inBody: true);
            });
        Assert.That(there.Orientation.Vector.Length, Is.GreaterThan(0.1));
    }

    [TestCaseSource(nameof(Cases))]
    public void Impulse_at_the_centre_of_mass(string rule, PointBody points)
    {
        Gains(rule, points, _ => J, state => Vector3d.Cross(Centre(points, state), J), body => body.ApplyImpulse(J));
        Gains(
            rule,
            points,
            state => World(state) * J,
            state => Vector3d.Cross(Centre(points, state), World(state) * J),
            body => body.ApplyImpulse(J, inBody: true));
    }

    [TestCaseSource(nameof(Cases))]
    public void Angular_impulse(string rule, PointBody points)
    {
        Gains(rule, points, Vector3d.Zero, Turn, body => body.ApplyAngularImpulse(Turn));
        Gains(rule, points, _ => Vector3d.Zero, state => World(state) * Turn, body => body.ApplyAngularImpulse(Turn, inBody: true));
    }

    [TestCaseSource(typeof(PointBody), nameof(PointBody.All))]
    public void After_it_the_exact_integrator_goes_on_as_the_closed_form_from_there(PointBody points)
    {
        Simulation simulation = new(TimeSteps.Every(0.02));
        Body body = simulation.Add(Description("Exact", points));
        for (int i = 0; i < 5; i++)
        {
            simulation.Step(37);
            body.ApplyImpulse(0.3 * J, body.State.Position + Point);
            FreeMotion free = new(new BodyDescription("free", points.Mass) { Start = body.State });
            BodyState then = free.At(1000 * 0.02);
            SavedSimulation here = simulation.Save();
            simulation.Step(1000);
            // twenty seconds of some radians a second
            Assert.That(Conserved.AngleBetween(body.State.Orientation, then.Orientation), Is.LessThan(2e-13)); // measured 3.8e-15
            Assert.That(Apart(body.State.Position, then.Position), Is.LessThan(2e-13)); // measured 7.1e-15
            simulation.Restore(here);
        }
    }

    [TestCaseSource(nameof(Cases))]
    public void Impulse_and_its_opposite_leave_the_motion_as_it_was(string rule, PointBody points)
    {
        Simulation pushed = new(TimeSteps.Every(0.02)), left = new(TimeSteps.Every(0.02));
        Body twice = pushed.Add(Description(rule, points)), never = left.Add(Description(rule, points));
        pushed.Step(20);
        left.Step(20);
        twice.ApplyImpulse(J, Point);
        twice.ApplyImpulse(-J, Point);
        pushed.Step(20);
        left.Step(20);
        double apart = Conserved.AngleBetween(twice.State.Orientation, never.State.Orientation) + Apart(twice.State.Position, never.State.Position);
        // there and back ω loses what it rounds at its largest in between, some 40 of its own last bits: 5.0e-14 of the turned body
        // by Exact, where another mass of the same body has as much or a tenth of it
        Assert.That(apart, Is.LessThan(rule == "UnityRigidbody" ? 2e-6 : 1e-13)); // measured 2.0e-7, 5.0e-14
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Body_whose_rotation_had_been_left_out_turns_after_an_impulse_beside_its_centre(string rule)
    {
        PointBody points = PointBody.All[3];
        Simulation simulation = new(TimeSteps.Every(0.02));
        BodyDescription resting = Description(rule, points);
        resting.Start = BodyState.AtRest;
        resting.Unity.Drag = 0;
        Body body = simulation.Add(resting);
        Assert.That(body.Plan.LeftOut, Is.EqualTo(Omissions.Rotation | Omissions.Translation));

        simulation.Step(10);
        body.ApplyImpulse(J);
        Assert.That(body.Plan.LeftOut, Is.EqualTo(Omissions.Rotation));
        Assert.That(new Explanation(body).ToString(), Does.Contain("drift").And.Contain("left out: rotation").And.Not.Contain("left out: translation"));

        simulation.Step(10);
        body.ApplyAngularImpulse(Turn);
        Assert.That(body.Plan.LeftOut, Is.EqualTo(Omissions.None));
        Assert.That(new Explanation(body).ToString(), Does.Not.Contain("left out: rotation").And.Not.Contain("left out: translation"));
        Assert.That(Apart(body.State.Velocity, J / points.Mass.Mass), Is.LessThan(2e-7)); // measured 2.0e-8 in float, 0
        Quaterniond before = body.State.Orientation;
        simulation.Step();
        Assert.That(Conserved.AngleBetween(before, body.State.Orientation), Is.GreaterThan(0.001));
    }

    private static void Gains(string rule, PointBody points, Vector3d momentum, Vector3d moment, Action<Body> push) =>
        Gains(rule, points, _ => momentum, _ => moment, push);

    private static void Gains(string rule, PointBody points, Func<BodyState, Vector3d> momentum, Func<BodyState, Vector3d> moment, Action<Body> push)
    {
        Simulation simulation = new(TimeSteps.Every(1.0 / 60));
        Body body = simulation.Add(Description(rule, points));
        simulation.Step(25);
        BodyState before = body.State;
        push(body);
        BodyState after = body.State;
        double moved = Apart(points.Momentum(after) - points.Momentum(before), momentum(before));
        double turned = Apart(points.AngularMomentum(after) - points.AngularMomentum(before), moment(before));
        TestContext.Out.WriteLine($"{moved:e1} N s, {turned:e1} N m s");
        Assert.That((after.Position, after.Orientation), Is.EqualTo((before.Position, before.Orientation)));
        Assert.That(moved, Is.LessThan(rule == "UnityRigidbody" ? 1e-6 : 1e-14)); // measured 1.7e-7, 1.8e-15
        Assert.That(turned, Is.LessThan(rule == "UnityRigidbody" ? 2e-5 : 4e-14)); // measured 6.7e-6, 9.3e-15
        simulation.Step();
        Assert.That(Apart(body.State.Position, before.Position), Is.GreaterThan(1e-3));
    }

    private static BodyDescription Description(string rule, PointBody points) => Scenery.Body(rule).Copy("body", points.Mass);

    private static Matrix3 World(BodyState state) => Matrix3.Of(state.Orientation.Normalized);

    private static Vector3d Centre(PointBody points, BodyState state) => state.Position + World(state) * points.Mass.CenterOfMass;
}
