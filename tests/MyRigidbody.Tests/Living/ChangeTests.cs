using NUnit.Framework;
using static RigidBodyDynamics.Tests.Samples;

namespace RigidBodyDynamics.Tests;

/// <summary>A body replaced by another in the same place: what is conserved.</summary>
public sealed class ChangeTests
{
    private const double H = 1 / 64.0;
    private static readonly Vector3d P = new(0.4, -0.3, 0.8);

    private static IEnumerable<TestCaseData> Pairs =>
        from rule in Scenery.Integrators
        from a in PointBody.All
        from b in PointBody.All
        where a != b
        select new TestCaseData(rule, a, b).SetArgDisplayNames(rule, a.Name, b.Name);

    [TestCaseSource(nameof(Pairs))]
    public void Momentum_kept(string rule, PointBody from, PointBody to)
    {
        (BodyState before, BodyState after) = Changed(rule, from, to, Keeping.Momentum);
        double p = Apart(from.Momentum(before), to.Momentum(after));
        // about the centre of mass, which jumps where the mass that comes or goes does so on one side
        double l = Apart(Conserved.AngularMomentum(before, from.Mass), Conserved.AngularMomentum(after, to.Mass));
        Assert.That(p, Is.LessThan(rule == "UnityRigidbody" ? 1e-6 : 2e-15)); // measured 1e-7 in float, 1.3e-15
        Assert.That(l, Is.LessThan(rule == "UnityRigidbody" ? 2e-6 : 2e-14)); // measured 5.2e-7, 8.9e-15
    }

    [TestCaseSource(nameof(Pairs))]
    public void Velocity_kept_at_every_point_of_the_body(string rule, PointBody from, PointBody to)
    {
        (BodyState before, BodyState after) = Changed(rule, from, to, Keeping.Velocity);
        foreach (Vector3d point in new[] { P, -5 * P, Vector3d.Zero })
            Assert.That(Apart(Velocity(from, before, point), Velocity(to, after, point)), Is.LessThan(rule == "UnityRigidbody" ? 1e-6 : 4e-15)); // measured 3.0e-7, 1.6e-15
    }

    [Test]
    public void Rocket_whose_fuel_leaves_comes_to_u_ln_of_its_masses()
    {
        // steps of fuel are the midpoint rule for ∫ dm/m: with the error h²/24 (1/m₁² − 1/m₀²), h the fuel of a step
        const double u = 3;
        double Speed(int steps)
        {
            Simulation simulation = new(TimeSteps.Every(1.0 / steps));
            Body rocket = simulation.Add(With(2));
            for (int n = 0; n < steps; n++)
            {
                rocket.Change(With(2 - (n + 0.5) / steps));
                rocket.ApplyForce(new Vector3d(0, u, 0));
                simulation.Step();
            }

            return rocket.State.Velocity.Y;
        }

        static BodyDescription With(double kilograms) => new("rocket", Solids.Cylinder(kilograms, 0.5, 3));
        double closed = u * Math.Log(2);
        foreach (int steps in new[] { 100, 1000 })
        {
            double off = closed - Speed(steps), expected = u / 24 * (1 - 0.25) / ((double)steps * steps);
            Assert.That(off / expected, Is.EqualTo(1).Within(1e-3)); // measured 2.2e-5
        }
    }

    [Test]
    public void Chain_that_gathers_mass_at_rest_slows_as_momentum_says()
    {
        Simulation simulation = new(TimeSteps.Every(H));
        BodyDescription Heap(double kilograms) => new("heap", Solids.Sphere(kilograms, 1))
        {
            Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(6, 0, 0), new Vector3d(0, 0, 6)),
        };
        Body heap = simulation.Add(Heap(1));
        double x = 0;
        for (int m = 2; m <= 50; m++)
        {
            simulation.Step();
            x += 6.0 / (m - 1) * H;
            heap.Change(Heap(m), Keeping.Momentum);
            Assert.That(heap.State.Velocity.X, Is.EqualTo(6.0 / m).Within(1e-14)); // measured 2.2e-16
            Assert.That(heap.State.AngularVelocity.Z, Is.EqualTo(6.0 / m).Within(1e-14)); // measured 4.4e-16
            Assert.That(heap.State.Position.X, Is.EqualTo(x).Within(1e-14)); // measured 1.7e-16
        }
    }

    [Test]
    public void Skater_who_pulls_in_the_arms_turns_faster_and_pays_with_work()
    {
        Simulation simulation = new(TimeSteps.Every(H));
        BodyDescription wide = new("skater", MassProperties.FromPrincipal(60, new Vector3d(12, 12, 4)));
        wide.Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, new Vector3d(0, 0, 3));
        Body skater = simulation.Add(wide);
        simulation.Step(64);
        double angle = 3, energy = skater.KineticEnergy;
        skater.Change(new BodyDescription("skater", MassProperties.FromPrincipal(60, new Vector3d(11, 11, 1))), Keeping.Momentum);
        Assert.That(skater.State.AngularVelocity.Z, Is.EqualTo(12).Within(1e-14));
        Assert.That(skater.KineticEnergy / energy, Is.EqualTo(4).Within(1e-15));
        simulation.Step(64);
        angle += 12;
        Assert.That(Conserved.AngleBetween(skater.State.Orientation, Quaterniond.FromAxisAngle(new Vector3d(0, 0, 1), angle)), Is.LessThan(1e-14)); // measured 3.1e-15
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Other_integrator_goes_on_from_here_as_for_a_body_that_comes_now(string rule)
    {
        Simulation simulation = new(TimeSteps.Every(H));
        Body body = simulation.Add(Scenery.Busy("RungeKutta4", "a"));
        simulation.Step(20);
        BodyDescription other = Scenery.Busy(rule, "b");
        other.Start = body.State;
        body.Change(other);
        Body came = simulation.Add(other);
        Assert.That(body.Rule.Name, Is.EqualTo(other.Rule.Name));
        simulation.Step(50);
        Assert.That(body.State, Is.EqualTo(came.State));
        Assert.That(body.Name, Is.EqualTo("b"));
    }

    [Test]
    public void Windows_of_new_effects_go_by_the_time_of_the_simulation()
    {
        Simulation simulation = new(TimeSteps.Every(H));
        Body body = simulation.Add(new BodyDescription("body", Solids.Sphere(2, 1)));
        simulation.Step(64);
        body.Change(new BodyDescription("body", Solids.Sphere(2, 1)).With(new Force(new Vector3d(4, 0, 0)), 0.5, 1.5).With(new Force(new Vector3d(0, 4, 0)), 3, 4));
        simulation.Step(64);
        Assert.That(body.State.Velocity, Is.EqualTo(new Vector3d(1, 0, 0)));
        Assert.That(new Explanation(body).ToString(), Does.Contain("  1 s to 1.5 s: ").And.Contain("  3 s to 4 s: "));
        simulation.Step(192);
        Assert.That(body.State.Velocity, Is.EqualTo(new Vector3d(1, 2, 0)));
    }

    [Test]
    public void Force_that_waits_for_the_next_step_waits_on()
    {
        Simulation simulation = new(TimeSteps.Every(H));
        Body body = simulation.Add(new BodyDescription("body", Solids.Sphere(2, 1)));
        body.ApplyTorque(new Vector3d(0, 0, 0.8));
        body.ApplyForce(new Vector3d(1, 0, 0));
        body.Change(new BodyDescription("body", Solids.Sphere(4, 1)));
        simulation.Step();
        // 1 N and 0.8 N m for 1/64 s on 4 kg and 2/5 × 4 kg m²
        Assert.That(body.State.Velocity.X, Is.EqualTo(H / 4).Within(1e-18));
        Assert.That(body.State.AngularVelocity.Z, Is.EqualTo(0.8 * H / 1.6).Within(1e-17));
    }

    [Test]
    public void Body_that_may_not_move_or_turn_any_more_stands()
    {
        Simulation simulation = new(TimeSteps.Every(H));
        Body body = simulation.Add(Scenery.Body("Exact"));
        simulation.Step(20);
        BodyState before = body.State;
        BodyDescription pinned = Scenery.Body("Exact");
        pinned.CanMove = false;
        body.Change(pinned);
        simulation.Step(20);
        Assert.That((body.State.Position.IsFinite, body.State.Velocity), Is.EqualTo((true, Vector3d.Zero)));
        pinned.CanTurn = false;
        body.Change(pinned);
        Quaterniond turned = body.State.Orientation;
        simulation.Step(20);
        Assert.That((body.State.Orientation, body.State.AngularVelocity), Is.EqualTo((turned, Vector3d.Zero)));
        Assert.That(before.Velocity.IsZero, Is.False);
    }

    [Test]
    public void Description_stays_the_callers_own()
    {
        Simulation simulation = new(TimeSteps.Every(H));
        Body body = simulation.Add(Scenery.Body("Exact"));
        simulation.Step(20);
        BodyDescription next = Scenery.Body("Exact6", "next");
        BodyState start = next.Start;
        body.Change(next);
        Assert.That(next.Start, Is.EqualTo(start));
        next.With(new Force(new Vector3d(100, 0, 0)));
        next.Rule = Rules.LabEuler;
        Vector3d before = body.State.Velocity;
        simulation.Step(20);
        Assert.That((body.State.Velocity, body.Rule), Is.EqualTo((before, Rules.Exact6)));
    }

    private static (BodyState Before, BodyState After) Changed(string rule, PointBody from, PointBody to, Keeping keeping)
    {
        Simulation simulation = new(TimeSteps.Every(H));
        Body body = simulation.Add(Scenery.Body(rule).Copy("from", from.Mass));
        simulation.Step(30);
        BodyState before = body.State;
        body.Change(Scenery.Body(rule).Copy("to", to.Mass), keeping);
        BodyState after = body.State;
        // the frame stays in its place
        Assert.That(Apart(after.Position, before.Position), Is.LessThan(rule == "UnityRigidbody" ? 4e-7 : 2e-15)); // measured 1.2e-7, 4.4e-16
        Assert.That(Conserved.AngleBetween(after.Orientation, before.Orientation), Is.LessThan(rule == "UnityRigidbody" ? 4e-7 : 5e-16)); // measured 6.2e-8, 2.5e-16
        return (before, after);
    }

    private static Vector3d Velocity(PointBody body, BodyState state, Vector3d point) =>
        state.Velocity + Vector3d.Cross(state.AngularVelocity, Matrix3.Of(state.Orientation.Normalized) * (point - body.Mass.CenterOfMass));
}
