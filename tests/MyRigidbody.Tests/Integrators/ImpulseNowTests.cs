using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>
/// An impulse that is given at once, by every integrator: both momenta gain exactly it, and the pose stays. Momenta are summed
/// over the points of the body, independently of an integrator's own inertia.
/// </summary>
public sealed class ImpulseNowTests
{
    private static readonly Wrench Impulse =
        new() { Force = new Vector3d(3, -1, 2), Torque = new Vector3d(0.5, 0.25, -2), BodyTorque = new Vector3d(-1, 0.75, 0.3) };

    private static readonly Cloud[] Clouds =
    [
        new("three equal moments", [.. Box(1, 1, 1)]),
        new("two equal moments", [.. Box(1, 1, 0.4)]),
        new("three moments and a turned frame", [new(1, 0, 0.2), new(-0.5, 1, 0), new(0, -0.7, 1.5), new(0.3, 0.3, -1)]),
    ];

    private static IEnumerable<TestCaseData> Cases =>
        from rule in Scenery.Integrators
        from cloud in Clouds
        select new TestCaseData(rule, cloud).SetArgDisplayNames(rule, cloud.Name);

    [TestCaseSource(nameof(Cases))]
    public void Both_momenta_gain_the_impulse_and_the_pose_stays_to_the_bit(string rule, Cloud cloud)
    {
        (BodyState before, BodyState after) = Run(rule, cloud.Mass, new Pushed { After = 25, Impulse = Impulse });
        Vector3d gain = cloud.AngularMomentum(after) - cloud.AngularMomentum(before);
        Vector3d given = Impulse.Torque + Matrix3.Of(before.Orientation.Normalized) * Impulse.BodyTorque;
        double turned = (gain - given).Length, moved = (cloud.Mass.Mass * (after.Velocity - before.Velocity) - Impulse.Force).Length;
        TestContext.Out.WriteLine($"{turned:e1} N m s, {moved:e1} N s");

        Assert.That((after.Position, after.Orientation), Is.EqualTo((before.Position, before.Orientation)));
        Assert.That(turned, Is.LessThan(rule == "UnityRigidbody" ? 2e-6 : 1e-14)); // measured at most 3.4e-7, 2.6e-15
        Assert.That(moved, Is.LessThan(rule == "UnityRigidbody" ? 1e-6 : 2e-15)); // measured at most 1.7e-7, 5.0e-16
    }

    [TestCaseSource(nameof(Cases))]
    public void Impulse_through_the_centre_leaves_the_rotation_to_the_bit(string rule, Cloud cloud)
    {
        Wrench push = new() { Force = Impulse.Force };
        BodyState pushed = Run(rule, cloud.Mass, new Pushed { After = 25, Impulse = push, Then = 50 }).After;
        BodyState left = Run(rule, cloud.Mass, new Pushed { After = 25, Then = 50 }).After;

        Assert.That((pushed.Orientation, pushed.AngularVelocity), Is.EqualTo((left.Orientation, left.AngularVelocity)));
        Assert.That(pushed.Position, Is.Not.EqualTo(left.Position));
    }

    [TestCaseSource(nameof(Cases))]
    public void What_is_held_stays_held(string rule, Cloud cloud)
    {
        foreach (bool canMove in new[] { false, true })
        {
            (BodyState before, BodyState after) = Run(rule, cloud.Mass, new Pushed { Impulse = Impulse, CanMove = canMove, CanTurn = !canMove });
            Assert.That(after.Velocity.Equals(before.Velocity), Is.Not.EqualTo(canMove));
            Assert.That(after.AngularVelocity.Equals(before.AngularVelocity), Is.EqualTo(canMove));
        }
    }

    [Test]
    public void Hundred_thousand_small_impulses_cost_the_exact_integrator_no_more_digits_than_one()
    {
        Composition<SphericalTop, Order2> body = default;
        body.Start(new Beginning(new BodyDescription("b", MassProperties.FromPrincipal(1, new Vector3d(1, 1, 1)))));
        for (int i = 0; i < 100_000; i++)
            body.Push(new Wrench { Force = new Vector3d(0.1, 0, 0), Torque = new Vector3d(0, 0.1, 0) });

        Assert.That(body.State.Velocity.X, Is.EqualTo(1e4)); // by plain sums 1.9e-8 more
        Assert.That(body.State.AngularVelocity.Y, Is.EqualTo(1e4));
    }

    [Test]
    public void Impulse_wakes_Unitys_body_and_a_zero_one_does_not()
    {
        UnityRigidbody<ToSingle> body = default;
        body.Start(new Beginning(new BodyDescription("b", Solids.Sphere(2, 1))));
        body.Prepare(0.02, Coasting.Free);
        Nothing nothing = default;
        for (int n = 0; n < 50; n++)
            body.Step(new Instant(n, 0.02 * n), ref nothing);

        body.Push(default);
        Assert.That((body.IsAsleep, body.WakeCounter), Is.EqualTo((true, 0f)));
        body.Push(Impulse);
        Assert.That((body.IsAsleep, body.WakeCounter), Is.EqualTo((false, 20f * 0.02f)));
        body.Step(new Instant(50, 1), ref nothing);
        Assert.That((body.State.Position - 0.02 * Impulse.Force / 2).Length, Is.LessThan(2e-9)); // measured 8.3e-10, a float's rounding
    }

    private static (BodyState Before, BodyState After) Run(string rule, MassProperties mass, Pushed pushed)
    {
        BodyDescription body = Scenery.Body(rule).Copy("body", mass);
        (body.CanMove, body.CanTurn) = (pushed.CanMove, pushed.CanTurn);
        body.Start = new BodyState(
            body.Start.Position,
            body.Start.Orientation,
            pushed.CanMove ? body.Start.Velocity : Vector3d.Zero,
            pushed.CanTurn ? body.Start.AngularVelocity : Vector3d.Zero);
        pushed.Body = body;
        return body.Rule.Use(body, pushed);
    }

    private static IEnumerable<Vector3d> Box(double x, double y, double z)
    {
        for (int i = 0; i < 8; i++)
            yield return new Vector3d((i & 1) == 0 ? x : -x, (i & 2) == 0 ? y : -y, (i & 4) == 0 ? z : -z);
    }

    /// <summary>A body of points of 0.3 kg each.</summary>
    public sealed record Cloud(string Name, Vector3d[] Points)
    {
        private const double Each = 0.3;

        public MassProperties Mass { get; } = PointMasses.Equal(Each * Points.Length, Points);

        public Vector3d AngularMomentum(BodyState state)
        {
            Matrix3 toWorld = Matrix3.Of(state.Orientation.Normalized);
            Vector3d sum = Vector3d.Zero;
            foreach (Vector3d point in Points)
            {
                Vector3d arm = toWorld * (point - Mass.CenterOfMass);
                sum += Each * Vector3d.Cross(arm, Vector3d.Cross(state.AngularVelocity, arm));
            }

            return sum;
        }
    }

    /// <summary>Runs a body for some steps, pushes it once, and runs it on.</summary>
    private sealed class Pushed : IRuleUse<(BodyState Before, BodyState After)>
    {
        public BodyDescription Body { get; set; } = null!;

        public Wrench Impulse { get; init; }

        public int After { get; init; }

        public int Then { get; init; }

        public bool CanMove { get; init; } = true;

        public bool CanTurn { get; init; } = true;

        public (BodyState Before, BodyState After) With<TIntegrator>() where TIntegrator : struct, IIntegrator
        {
            TIntegrator body = default;
            body.Start(new Beginning(Body));
            body.Prepare(1.0 / 60, Coasting.Free);
            Nothing nothing = default;
            for (int n = 0; n < After; n++)
                body.Step(new Instant(n, n / 60.0), ref nothing);

            BodyState before = body.State;
            body.Push(Impulse);
            for (int n = After; n < After + Then; n++)
                body.Step(new Instant(n, n / 60.0), ref nothing);

            return (before, body.State);
        }
    }
}
