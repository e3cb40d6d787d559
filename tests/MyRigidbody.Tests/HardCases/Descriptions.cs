namespace RigidBodyDynamics.Tests;

/// <summary>One body described in several ways: all must move alike.</summary>
internal static class Descriptions
{
    private static readonly Vector3d Spin = new(1, 2, -1.5);

    /// <summary>The angle between a body of moments 1, 2, 2.5 and the same with its moments in another unit, largest of many, rad.</summary>
    public static double InAnotherUnit(string integrator)
    {
        Quaterniond here = After(integrator, MassProperties.FromPrincipal(1, new Vector3d(1, 2, 2.5)), 5000);
        return new[] { 1e-300, 1e-18, 1e-9, 1e9, 1e18, 1e300 }.Max(unit => Conserved.AngleBetween(
            here, After(integrator, MassProperties.FromPrincipal(1, unit * new Vector3d(1, 2, 2.5)), 5000)));
    }

    /// <summary>The same with its axes in every order and with a tilted frame.</summary>
    public static double InAnotherOrder(string integrator)
    {
        // frames that take principal axes to body axes: two thirds of half a revolution about (1, 1, 1), quarters about one axis
        double r = Math.Sqrt(0.5);
        (Vector3d Moments, Quaterniond Frame)[] orders =
        [
            (new(2, 2.5, 1), new(0.5, 0.5, 0.5, 0.5)),
            (new(2.5, 1, 2), new(0.5, -0.5, -0.5, -0.5)),
            (new(2, 1, 2.5), new(r, 0, 0, r)),
            (new(1, 2.5, 2), new(r, r, 0, 0)),
            (new(2.5, 2, 1), new(r, 0, r, 0)),
        ];
        Quaterniond here = After(integrator, MassProperties.FromPrincipal(1, new Vector3d(1, 2, 2.5)), 5000);
        double worst = orders.Max(order => Conserved.AngleBetween(
            here, After(integrator, MassProperties.FromPrincipal(1, order.Moments, order.Frame, Vector3d.Zero), 5000)));

        // and as a tensor in tilted axes, diagonalised by the library
        Quaterniond tilt = new Quaterniond(0.7, -0.4, 0.5, 0.3).Normalized;
        SymmetricMatrix3 tensor = MassProperties.FromPrincipal(1, new Vector3d(1, 2, 2.5), tilt, Vector3d.Zero).Inertia;
        BodyDescription tilted = Body(integrator, MassProperties.FromTensor(1, tensor, Vector3d.Zero));
        tilted.Start = new BodyState(Vector3d.Zero, tilt.Conjugate, Vector3d.Zero, Spin);
        Simulation simulation = Scenery.Stepped(TimeSteps.Every(0.02), tilted);
        simulation.Step(5000);
        return Math.Max(worst, Conserved.AngleBetween(here, simulation.Bodies[0].State.Orientation * tilt));
    }

    /// <summary>
    /// Two moments that differ by δ against the closed form for two that are equal, in every order of the axes, after 100 s:
    /// the angle less what δ itself can do, rad.
    /// </summary>
    public static double AlmostEqual(string integrator)
    {
        double worst = 0;
        foreach (double delta in new[] { 1e-9, 1e-12, 1e-15 })
        {
            foreach ((Vector3d Equal, Vector3d Off) m in new (Vector3d, Vector3d)[]
            {
                (new(1, 1, 1.5), new(1, 1 + delta, 1.5)), (new(1, 1, 1.5), new(1 + delta, 1, 1.5)), (new(1, 1.5, 1), new(1, 1.5, 1 + delta)),
                (new(1.5, 1, 1), new(1.5, 1 + delta, 1)), (new(1, 1, 1), new(1, 1 + delta, 1)), (new(1, 1, 1), new(1, 1 - delta, 1 + delta)),
            })
            {
                BodyState right = new FreeMotion(Body(integrator, MassProperties.FromPrincipal(1, m.Equal))).At(100);
                double angle = Conserved.AngleBetween(right.Orientation, After(integrator, MassProperties.FromPrincipal(1, m.Off), 5000));
                worst = Math.Max(worst, angle - 3 * delta * Spin.Length * 100);
            }
        }

        return worst;
    }

    private static Quaterniond After(string integrator, MassProperties mass, long steps)
    {
        Simulation simulation = Scenery.Stepped(TimeSteps.Every(0.02), Body(integrator, mass));
        simulation.Step(steps);
        return simulation.Bodies[0].State.Orientation;
    }

    private static BodyDescription Body(string integrator, MassProperties mass) => new("body", mass)
    {
        Rule = Rules.Named(integrator),
        Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, Spin),
    };
}
