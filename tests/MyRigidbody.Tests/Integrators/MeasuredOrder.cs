using System.Collections.Concurrent;

namespace RigidBodyDynamics.Tests;

/// <summary>
/// The power of the step with which an integrator's error falls, after two seconds of a body's motion. The motion is known from
/// RungeKutta4 in 2048 and in 4096 steps, extrapolated to steps of no length; for integrators without a gyroscopic term it is a cube's.
/// </summary>
internal static class MeasuredOrder
{
    public const double Time = 2;

    /// <summary>No two equal, and all three.</summary>
    public static readonly Vector3d Moments = new(1, 2, 2.5), Cube = new(1.5, 1.5, 1.5);

    // below it the roundings of 4096 steps count
    private const double Floor = 2e-12;
    private const int FineSteps = 2048;
    private static readonly ConcurrentDictionary<(string, Vector3d, bool), BodyState> Truths = new();

    /// <summary>The order under effects that act all the time, or in a window; infinite where the integrator makes no error.</summary>
    public static double Of(string integrator, bool inWindow, params OrderedEffect[] effects) =>
        Of(integrator, Rules.Named(integrator).Keeps.HasFlag(Keeps.Motion) ? Moments : Cube, inWindow, effects);

    /// <summary>The same of a body with other moments (kg m²).</summary>
    public static double Of(string integrator, Vector3d moments, bool inWindow, params OrderedEffect[] effects) =>
        Of(Rules.Named(integrator).Order, steps => Run(integrator, steps, moments, inWindow, effects), Truth(moments, inWindow, effects));

    /// <summary>The order of an integrator that declares this one, from its results with several numbers of steps.</summary>
    public static double Of(int declared, Func<int, BodyState> run, BodyState truth)
    {
        double coarse = double.NaN, observed = double.NaN;
        int first = declared == 1 ? 512 : declared == 2 ? 64 : 8, last = declared == 1 ? 1024 : declared == 2 ? 256 : 2048;
        for (int steps = first; steps <= last; steps *= 2)
        {
            double fine = Apart(run(steps), truth);
            if (fine < Floor)
                return double.IsNaN(coarse) ? double.PositiveInfinity : observed;

            observed = Math.Log2(coarse / fine);
            coarse = fine;
        }

        return observed;
    }

    /// <summary>The true motion's end.</summary>
    public static BodyState Truth(Vector3d moments, bool inWindow, params OrderedEffect[] effects) =>
        Truths.GetOrAdd((string.Join('+', effects.Select(effect => effect.Name)), moments, inWindow), _ =>
        {
            OrderedEffect[] rates = [.. effects.SelectMany(effect => effect.InRates())];
            BodyState coarse = Run("RungeKutta4", FineSteps, moments, inWindow, rates), fine = Run("RungeKutta4", 2 * FineSteps, moments, inWindow, rates);
            return new BodyState(
                fine.Position + 1 / 15.0 * (fine.Position - coarse.Position),
                (fine.Orientation + 1 / 15.0 * (fine.Orientation + -1 * coarse.Orientation)).Normalized,
                fine.Velocity + 1 / 15.0 * (fine.Velocity - coarse.Velocity),
                fine.AngularVelocity + 1 / 15.0 * (fine.AngularVelocity - coarse.AngularVelocity));
        });

    /// <summary>A body on which nothing acts yet.</summary>
    public static BodyDescription Body(string integrator, Vector3d moments) => new("body", MassProperties.FromPrincipal(
        2, moments, new Quaterniond(0.9, 0.1, -0.3, 0.2), new Vector3d(0.1, -0.2, 0.3)))
    {
        Rule = Rules.Named(integrator),
        Start = new BodyState(new(1, 0.5, -1), new Quaterniond(0.8, 0.2, -0.4, 0.4).Normalized, new(0.5, -1, 1.25), new(0.9, 1.5, -1.1)),
        Unity = new UnitySettings { AngularDrag = 0, MaxAngularVelocity = double.PositiveInfinity, SleepThreshold = 0, InDouble = true },
    };

    private static BodyState Run(string integrator, int steps, Vector3d moments, bool inWindow, OrderedEffect[] effects)
    {
        double step = Time / steps, from = inWindow ? 0.5 : 0, to = inWindow ? 1.5 : double.PositiveInfinity;
        BodyDescription body = Body(integrator, moments);
        // a sum of pushes is a type, and hundreds of them take long to compile: more than one go into one
        bool isSum = effects.Length > 1;
        foreach (OrderedEffect effect in effects.Where(effect => effect.Push == null || !isSum))
            effect.GiveTo(body, step, from, to);

        if (isSum)
            body.With(new Many([.. effects.Where(effect => effect.Push != null).Select(effect => effect.Push!(step))]), from, to);

        return Scenery.Run(TimeSteps.Every(step, steps), body, steps);
    }

    private static double Apart(BodyState a, BodyState b) => Math.Max(
        Math.Max(Samples.Apart(a.Position, b.Position), Conserved.AngleBetween(a.Orientation, b.Orientation)),
        Math.Max(Samples.Apart(a.Velocity, b.Velocity), Samples.Apart(a.AngularVelocity, b.AngularVelocity)));
}
