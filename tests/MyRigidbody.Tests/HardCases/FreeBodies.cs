namespace RigidBodyDynamics.Tests;

/// <summary>Measures of free bodies.</summary>
internal static class FreeBodies
{
    private const double Step = 0.02;

    /// <summary>Largest angle to the truth, in units of the effect of the last bit of the inputs.</summary>
    public static double Floors(string integrator, string motion, string division) =>
        SolvedRun.Of(motion, integrator, division).Floors;

    /// <summary>How much of the needle's momentum across its axis is lost or gained after 60 s, as a part of it.</summary>
    public static double NutationLost(string integrator)
    {
        Body body = Run(integrator, new Vector3d(1e-6, 1, 1), new Vector3d(1000, 0.5, 0.3), 3000, out Body start);
        return Math.Abs(Across(body) / Across(start) - 1);

        static double Across(Body body)
        {
            Vector3d w = body.State.Orientation.RotateInverse(body.State.AngularVelocity);
            return w.Y * w.Y + w.Z * w.Z;
        }
    }

    /// <summary>Energy after so many steps, relative to that of the start, less 1.</summary>
    public static double EnergyDrift(string integrator, Vector3d moments, Vector3d spin, long steps)
    {
        Body body = Run(integrator, moments, spin, steps, out Body start);
        return Finite(Math.Abs(body.KineticEnergy / start.KineticEnergy - 1));
    }

    /// <summary>How far the vector L is from where it was, relative to its length.</summary>
    public static double MomentumDrift(string integrator, Vector3d moments, Vector3d spin, long steps)
    {
        Body body = Run(integrator, moments, spin, steps, out Body start);
        return Finite((body.AngularMomentum - start.AngularMomentum).Length / start.AngularMomentum.Length);
    }

    /// <summary>The angle to the rotation about a principal axis by spin × time after 100 s, the largest of the three axes, rad.</summary>
    public static double OffItsAxis(string integrator)
    {
        double worst = 0;
        foreach (Vector3d axis in new[] { new Vector3d(1, 0, 0), new Vector3d(0, 1, 0), new Vector3d(0, 0, 1) })
        {
            Body body = Run(integrator, new Vector3d(1, 2, 3), 7 * axis, 5000, out _);
            worst = Math.Max(worst, Conserved.AngleBetween(body.State.Orientation, Quaterniond.FromAxisAngle(axis, 7 * Step * 5000)));
        }

        return worst;
    }

    /// <summary>
    /// Beside a stable axis by ε the body swings about it with ε: by how many ε, or last bits, ω is ever farther away
    /// than the ellipse of its free motion lets it be, the largest of four ε and both axes.
    /// </summary>
    public static double SwingBesideStableAxis(string integrator)
    {
        double worst = 0;
        foreach (double epsilon in new[] { 1e-3, 1e-8, 1e-15, 1e-300 })
        {
            foreach (bool isFirst in new[] { true, false })
            {
                // ω₂ starts at ε; the other small component is then at most sqrt(k₃/k₂) ε (axis 1), sqrt(k₁/k₂) ε (axis 3)
                Vector3d spin = isFirst ? new Vector3d(5, epsilon, 0) : new Vector3d(0, epsilon, 5);
                double most = epsilon * Math.Sqrt(isFirst ? 2.0 / 3 : 2);
                Simulation simulation = new(TimeSteps.Every(Step), Top(integrator, new Vector3d(1, 2, 3), spin));
                double unit = Math.Max(epsilon, 1e-15);
                for (int n = 0; n < 2000; n++)
                {
                    if (!simulation.TryStep())
                        return double.PositiveInfinity;

                    BodyState state = simulation.Bodies[0].State;
                    Vector3d w = state.Orientation.RotateInverse(state.AngularVelocity);
                    worst = Math.Max(worst, (Math.Abs(w.Y) - epsilon) / unit);
                    worst = Math.Max(worst, (Math.Abs(isFirst ? w.Z : w.X) - most) / unit);
                    worst = Math.Max(worst, Math.Abs((isFirst ? w.X : w.Z) / 5 - 1) / Math.Max(epsilon * epsilon, 1e-15));
                }
            }
        }

        return Finite(worst);
    }

    private static Body Run(string integrator, Vector3d moments, Vector3d spin, long steps, out Body start)
    {
        Simulation simulation = Scenery.Stepped(TimeSteps.Every(Step), Top(integrator, moments, spin));
        start = new Simulation(TimeSteps.Every(Step), Top(integrator, moments, spin)).Bodies[0];
        simulation.Step(steps);
        return simulation.Bodies[0];
    }

    private static BodyDescription Top(string integrator, Vector3d moments, Vector3d spin) => new("top", MassProperties.FromPrincipal(1, moments))
    {
        Rule = Rules.Named(integrator),
        Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, spin),
    };

    private static double Finite(double figure) => double.IsFinite(figure) ? figure : double.PositiveInfinity;
}
