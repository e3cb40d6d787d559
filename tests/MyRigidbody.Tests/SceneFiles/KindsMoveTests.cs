using NUnit.Framework;

namespace RigidBodyDynamics.Tests.SceneFiles;

/// <summary>Every kind of inertia moves as its moments say, by every integrator, one by one and together.</summary>
public sealed class KindsMoveTests
{
    private const double Torque = 0.05, Force = 0.3, Seconds = 2;

    // each with its mass and its moment about z through the centre of mass, from a table (Goldstein, chapter 5)
    private static readonly (string Fields, double Mass, double Moment)[] Kinds =
    [
        ("\"mass\": 2, \"inertia\": { \"solidCylinder\": { \"radius\": 0.3, \"height\": 0.8, \"axis\": \"z\" } }", 2, 2 * 0.09 / 2),
        ("\"mass\": 2, \"inertia\": { \"solidCylinder\": { \"radius\": 0.3, \"height\": 0.8 } }", 2, 2 * (3 * 0.09 + 0.64) / 12),
        // r = 0.3, h = 0.6: 1.2 of 2 kg in the cylinder, 0.8 kg in two half balls whose centres are h/2 + 3/8 r out
        ("\"mass\": 2, \"inertia\": { \"solidCapsule\": { \"radius\": 0.3, \"height\": 0.6, \"axis\": \"z\" } }", 2, 1.2 * 0.09 / 2 + 0.8 * 0.4 * 0.09),
        ("\"mass\": 2, \"inertia\": { \"solidCapsule\": { \"radius\": 0.3, \"height\": 0.6, \"axis\": \"x\" } }", 2,
            1.2 * (3 * 0.09 + 0.36) / 12 + 0.8 * ((0.4 - 9.0 / 64) * 0.09 + (0.3 + 0.1125) * (0.3 + 0.1125))),
        ("\"mass\": 2, \"inertia\": { \"tensor\": { \"xx\": 0.3, \"yy\": 0.2, \"zz\": 0.25, \"xy\": 0.05 } }", 2, 0.25),
        ("\"mass\": 2, \"about\": \"origin\", \"centerOfMass\": [0.5, 0, 0], \"inertia\": { \"tensor\": { \"xx\": 0.3, \"yy\": 0.7, \"zz\": 0.75, \"xy\": 0.05 } }", 2, 0.25),
        ("\"mass\": 2, \"inertia\": { \"principal\": [0.333333, 0.333333, 0.666667] }", 2, 2.0 / 3),
        // two balls of 1 and 3 kg, 2/5 m r², 0.6 and 0.2 m from their common centre
        ("\"inertia\": { \"compound\": [{ \"mass\": 1, \"inertia\": { \"solidSphere\": 0.1 }, \"position\": [0.8, 0, 0] }, { \"mass\": 3, \"inertia\": { \"solidSphere\": 0.2 } }] }", 4,
            0.4 * 0.01 + 0.4 * 3 * 0.04 + 0.36 + 3 * 0.04),
    ];

    private static IEnumerable<TestCaseData> Cases =>
        from rule in Rules.All
        from kind in Enumerable.Range(0, Kinds.Length)
        select new TestCaseData(rule, kind).SetArgDisplayNames(rule.Name, Kinds[kind].Fields.Replace("\"", string.Empty));

    // a torque about z from rest leaves every integrator its own closed form: ω = τ t / I, and v = F t / m beside it
    [TestCaseSource(nameof(Cases))]
    public void Torque_and_force_from_rest_make_the_velocities_of_mass_and_moment(Rule rule, int kind)
    {
        (string fields, double mass, double moment) = Kinds[kind];
        BodyDescription body = SceneText.Read($$"""
            { "schema": "rigid-body-scene/1", "name": "n", "step": 0.02, "steps": 100, "bodies": [
              { "name": "b", "integrator": "{{rule.Name}}", {{fields}},
                "effects": [ { "torque": { "frame": "body", "constant": [0, 0, {{Torque}}] } }, { "force": [0, 0, {{Force}}] } ] } ] }
            """).Scene.Bodies[0];
        body.Unity.InDouble = true;
        body.Unity.AngularDrag = 0;
        Simulation simulation = new(TimeSteps.Every(0.02));
        for (int i = 0; i < 9; i++)
            simulation.Add(body);

        simulation.Step(100);

        BodyState state = simulation.Bodies[0].State;
        Assert.That(state.AngularVelocity.Z * moment / (Torque * Seconds), Is.EqualTo(1).Within(2e-14)); // measured 3.1e-15
        Assert.That(state.Velocity.Z * mass / (Force * Seconds), Is.EqualTo(1).Within(5e-15)); // measured 6.7e-16
        Assert.That(Math.Abs(state.AngularVelocity.X) + Math.Abs(state.AngularVelocity.Y), Is.LessThan(1e-14)); // measured 0
        Assert.That(simulation.Bodies.Select(alike => alike.State), Has.All.EqualTo(state));
    }
}
