namespace RigidBodyDynamics.Tests;

/// <summary>
/// The times at which a body that rotates about its middle axis, a little beside it, flips: ω₂ passes through zero a quarter of a
/// period after its greatest value, and then every half period.
/// </summary>
internal static class Flips
{
    /// <summary>
    /// The times, s, from a start at (ε, ω, 0) with I₁ &lt; I₂ &lt; I₃: (n + ½) 2K(k)/p, where p² = (I₂ − I₁)(2T I₃ − L²)/(I₁I₂I₃)
    /// and k'² = (I₃ − I₁) I₁ ε²/(2T I₃ − L²) (Landau and Lifshitz, Mechanics, § 37); K = π/(2 M(1, k')) by Gauss's mean.
    /// </summary>
    public static IEnumerable<double> True(Vector3d i, double epsilon, double spin)
    {
        double rest = i.X * epsilon * epsilon * (i.Z - i.X) + i.Y * spin * spin * (i.Z - i.Y);
        double p = Math.Sqrt((i.Y - i.X) * rest / (i.X * i.Y * i.Z));
        double complement = Math.Sqrt((i.Z - i.X) * i.X / rest) * epsilon;
        double a = 1, g = complement;
        while (Math.Abs(a - g) > 1e-15 * a)
            (a, g) = (0.5 * (a + g), Math.Sqrt(a) * Math.Sqrt(g));

        double half = Math.PI / a / p;
        for (int n = 0; ; n++)
            yield return (n + 0.5) * half;
    }

    /// <summary>The times at which a run has them, by the straight line between two steps.</summary>
    public static List<double> Of(string integrator, Vector3d moments, double epsilon, double spin, double step, double duration)
    {
        BodyDescription body = new("slab", MassProperties.FromPrincipal(1, moments))
        {
            Rule = Rules.Named(integrator),
            Unity = new UnitySettings { AngularDrag = 0, MaxAngularVelocity = double.PositiveInfinity, SleepThreshold = 0, InDouble = true },
            Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, new Vector3d(epsilon, spin, 0)),
        };
        Simulation simulation = new(TimeSteps.Every(step), body);
        List<double> times = [];
        double before = spin;
        for (long n = 1; n * step <= duration; n++)
        {
            simulation.Step();
            BodyState state = simulation.Bodies[0].State;
            double now = state.Orientation.RotateInverse(state.AngularVelocity).Y;
            if (now * before < 0)
                times.Add((n - 1 + before / (before - now)) * step);

            before = now != 0 ? now : before;
        }

        return times;
    }

    /// <summary>The largest deviation from the true times, s; infinite if there are more or fewer.</summary>
    public static double Off(string integrator, double epsilon, double spin, double step, double duration)
    {
        Vector3d moments = new(1, 2, 3);
        List<double> right = [.. True(moments, epsilon, spin).TakeWhile(t => t <= duration)];
        List<double> found = Of(integrator, moments, epsilon, spin, step, duration);
        return right.Count == found.Count && right.Count > 0 ? right.Zip(found, (a, b) => Math.Abs(a - b)).Max() : double.PositiveInfinity;
    }
}
