namespace RigidBodyDynamics.Tests;

/// <summary>A body with as many effects as possible, and the steps for it.</summary>
internal static class Scenery
{
    public const long Steps = 90;

    /// <summary>Steps of one length, and steps of three lengths one after another.</summary>
    public static IEnumerable<TimeSteps> Divisions()
    {
        yield return TimeSteps.Every(1.0 / 60, Steps);
        yield return TimeSteps.Of([.. Enumerable.Range(0, (int)Steps).Select(n => new[] { 0.005, 0.02, 0.025 }[n % 3])]);
    }

    /// <summary>Names of the catalogue's rows; Unity's twice, for its two precisions.</summary>
    public static IEnumerable<string> Integrators => Rules.All.Select(rule => rule.Name).Append(InDouble);

    private const string InDouble = "UnityRigidbody in double";

    public static BodyDescription Body(string integrator, string name = "body")
    {
        MassProperties mass = MassProperties.FromPrincipal(
            2, new Vector3d(1, 2, 2.5), new Quaterniond(0.9, 0.1, -0.3, 0.2), new Vector3d(0.1, -0.2, 0.3));
        return new BodyDescription(name, mass)
        {
            Rule = integrator == InDouble ? Rules.UnityRigidbody : Rules.Named(integrator),
            Start = Pushes.State,
            Unity = new UnitySettings { InDouble = integrator == InDouble, Drag = 0.1 },
        };
    }

    /// <summary>More pushes than the library gives a type of their own, in windows that overlap.</summary>
    public static BodyDescription Busy(string integrator, string name = "body")
    {
        Vector3d[] kicks = [.. Enumerable.Range(0, 50).Select(n => new Vector3d(Math.Sin(n), 0.1 * n, -1))];
        return Body(integrator, name)
            .With(new Gravity(new Vector3d(0, -9.81, 0)), 0.1, 1)
            .With(new LinearDamping(0.3), 0.25)
            .With(new AngularDamping(0.2))
            .With(new DecayPerStep(0.98, 0.97), 0.4, 0.7)
            .With(new Force(new Vector3d(5, 0, 0)), 0.05, 0.9)
            .With(new KeyPush(LabKey.R), 0.2)
            .With(new KeyPush(LabKey.UpArrow), 0.2, 0.5)
            .With(new QuadraticDrag(0.05))
            .With(new Spring(new Vector3d(0, 0.5, 0), new Vector3d(0, 3, 0), 4), 0.3)
            .With(new HeavyTop(new Vector3d(0, 0, 1), 0.4, new Vector3d(0, 1, 0)), 0.3, 1.2)
            .With(new Torque(new Vector3d(0.1, 0, 0), new Vector3d(0, 0.2, 0), Vector3d.Zero, 1.5, inBody: true))
            .With(new PerStep(kicks, kicks), 0.1);
    }

    /// <summary>True for an integrator of higher order whose step has no way back: it composes no exact motions, but evaluates rates in stages.</summary>
    public static bool TakesStages(string integrator) => Body(integrator).Rule is { Order: > 1 } rule && !rule.Keeps.HasFlag(Keeps.WayBack);

    /// <summary>A simulation that takes every step, also of bodies that coast.</summary>
    public static Simulation Stepped(TimeSteps steps, params BodyDescription[] bodies) =>
        new(new SceneDescription("stepped", string.Empty, steps, bodies), Omissions.None);

    public static BodyState Run(TimeSteps steps, BodyDescription body, long count)
    {
        Simulation simulation = new(steps, body);
        simulation.Step(count);
        return simulation.Bodies[0].State;
    }
}
