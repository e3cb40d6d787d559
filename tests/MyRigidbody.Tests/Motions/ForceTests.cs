using NUnit.Framework;
using RigidBodyDynamics.Lab;
using static RigidBodyDynamics.Tests.Samples;

namespace RigidBodyDynamics.Tests;

/// <summary>Forces at a point of the body, in world and in body axes: a ship with thrusters, and a bar that swings.</summary>
public sealed class ForceTests
{
    private static readonly Vector3d Thrust = new(0, 0, 2100), Left = new(-1, 0, 0), Right = new(1, 0, 0);

    // the bounds for the errors of v (m/s) and of the angle (rad) after a second with steps of 0.02 s
    private static IEnumerable<TestCaseData> ByRule() =>
    [
        .. new[] { "LabEuler", "ExplicitEuler", "ImplicitGyroscopic", "ExplicitGyroscopic", "UnityRigidbody" }
            .Select(rule => new TestCaseData(rule, 8e-4, 0.02)), // measured 6.6e-4, 0.018
        new("Splitting", 3.5e-4, 2e-5), // measured 2.7e-4, 1.2e-5
        new("Exact", 3.5e-4, 1e-15), // measured 2.8e-4, 2.2e-16
        new("RungeKutta4", 3e-8, 4e-10), // measured 1.8e-8, 2.6e-10
        new("Exact4", 4e-11, 1e-15), // measured 2.8e-11, 3.3e-16
        new("Exact6", 2e-14, 1e-15), // measured 7.5e-15, 1.1e-16
    ];

    [TestCaseSource(nameof(ByRule))]
    public void Ship_of_the_report_turns_under_its_thrusters_as_the_integrals_say(string rule, double speed, double angle)
    {
        // one thruster, as the report's file has it; and two, of which one is farther from the centre of mass than the other
        SceneFile file = SceneReader.Read(TestData.Path("reports", "06-force-at-point", "force-at.json"));
        BodyDescription one = By(rule, file.Scene.Bodies[0]), two = Ship(rule).With(new Force(Thrust, at: Left, inBody: true)).With(new Force(Thrust, at: Right, inBody: true));
        Check(one, -0.9, 3);
        Check(two, 1.8, 6);
        Assert.That(Turned(1.8, 6).Velocity.X, Is.EqualTo(1.69850356).Within(1e-8)); // the report's figures
        Assert.That(Turned(1.8, 6).Velocity.Z, Is.EqualTo(5.53188807).Within(1e-8));

        void Check(BodyDescription body, double spin, double acceleration)
        {
            BodyState end = Scenery.Run(file.Scene.Steps, body, 50), expected = Turned(spin, acceleration);
            double v = Apart(end.Velocity, expected.Velocity), turn = Conserved.AngleBetween(end.Orientation, expected.Orientation);
            TestContext.Out.WriteLine($"{rule}: v off by {v:e1} m/s, angle by {turn:e1} rad, spin by {Math.Abs(end.AngularVelocity.Y - spin):e1}");
            Assert.That(v, Is.LessThan(speed));
            Assert.That(turn, Is.LessThan(angle));
            Assert.That(end.AngularVelocity.Y, Is.EqualTo(spin).Within(body.Rule == Rules.UnityRigidbody ? 2e-6 : 1e-14));
        }
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Force_in_world_axes_at_a_point_is_one_at_the_centre_and_the_torque_of_a_heavy_top(string rule)
    {
        // the same wrench by another way: -m g l (axis × up), up against the force
        Vector3d force = new(0.5, -3, 1), centre = Scenery.Body(rule).Mass.CenterOfMass, arm = new(0.2, 0.4, -0.1);
        BodyState point = Run(Scenery.Body(rule).With(new Force(force, at: centre + arm)));
        BodyState top = Run(Scenery.Body(rule).With(new Force(force)).With(new HeavyTop(arm, arm.Length * force.Length, -force)));
        bool isSingle = rule == "UnityRigidbody";
        Assert.That(Apart(point.Velocity, top.Velocity), Is.LessThan(isSingle ? 1e-5 : 1e-13));
        Assert.That(Apart(point.AngularVelocity, top.AngularVelocity), Is.LessThan(isSingle ? 1e-5 : 1e-13));
        Assert.That(Conserved.AngleBetween(point.Orientation, top.Orientation), Is.LessThan(isSingle ? 1e-5 : 1e-13));

        static BodyState Run(BodyDescription body) => Scenery.Run(TimeSteps.Every(1.0 / 64), body, 128);
    }

    [TestCase("LabEuler")]
    [TestCase("Exact")]
    [TestCase("Exact4")]
    public void Constant_force_at_the_centre_coasts_only_where_it_neither_turns_nor_swings(string rule)
    {
        Vector3d f = new(1, 2, 3);
        Assert.That(Coasts(new Force(f)), Is.True);
        Assert.That(Coasts(new Force(f, Vector3d.Zero, Vector3d.Zero, 1)), Is.True);
        Assert.That(Coasts(new Force(f, inBody: true)), Is.False);
        Assert.That(Coasts(new Force(f, at: f)), Is.False);
        Assert.That(Coasts(new Force(f, f, f, 1)), Is.False);

        bool Coasts(Force force)
        {
            StretchPlan stretch = new Simulation(TimeSteps.Every(0.02), Scenery.Body(rule).With(force)).Bodies[0].Plan.Stretches[0];
            return stretch.Pushes.Count == 0 && stretch.Coasts.Count == 1;
        }
    }

    /// <summary>θ = α t²/2 about y, and v the integral of the force along it, by Gauss's rule of two points in 2000 panels.</summary>
    private static BodyState Turned(double spin, double acceleration)
    {
        const int panels = 2000;
        Vector3d v = Vector3d.Zero;
        for (int i = 0; i < 2 * panels; i++)
        {
            double t = (i / 2 + 0.5 + (i % 2 - 0.5) / Math.Sqrt(3)) / panels, angle = 0.5 * spin * t * t;
            v += acceleration / (2 * panels) * new Vector3d(Math.Sin(angle), 0, Math.Cos(angle));
        }

        return new BodyState(Vector3d.Zero, Quaterniond.FromAxisAngle(new Vector3d(0, 1, 0), 0.5 * spin), v, new Vector3d(0, spin, 0));
    }

    private static BodyDescription Ship(string rule) =>
        By(rule, new BodyDescription("ship", Solids.Box(700, new Vector3d(2, 1, 4)).WithCenterOfMass(new Vector3d(0.5, 0, -0.25))));

    private static BodyDescription By(string rule, BodyDescription body)
    {
        body.Rule = Rules.Named(rule);
        body.Unity = new UnitySettings { AngularDrag = 0 };
        return body;
    }
}
