using System.Globalization;

namespace RigidBodyDynamics.Lab;

/// <summary>The step lengths that are tried for a scene: numbers that can be typed after <c>run --step</c>.</summary>
/// <remarks>
/// Numbers of three digits, from the whole duration down; equal parts of the duration where these are few; and, where effects
/// begin or end, the lengths that coincide with all those times, because otherwise the error is larger than that of any integrator.
/// </remarks>
internal static class StepSizes
{
    private const double Ratio = 1.005, Meets = 1e-7;
    private const int FewSteps = 16, Most = 200_000;

    /// <summary>From the longest down, s.</summary>
    public static double[] Of(SceneDescription scene, double duration)
    {
        return [.. Decimals(duration).Concat(Whole(duration)).Concat(Aligned(scene, duration)).Where(step => EndsInTime(step, duration)).Distinct().OrderDescending()];
    }

    /// <summary>The times at which effects begin and end, in order.</summary>
    public static double[] Cuts(SceneDescription scene, double duration) => [.. scene.Bodies
        .SelectMany(body => new Cuts(body, duration * Truth.Beyond).Times)
        .Where(time => time > 0 && time <= duration).Distinct().Order()];

    /// <summary>The number of such steps that reach the end.</summary>
    public static long Count(double duration, double step) => TimeSteps.Until(duration, step).Count;

    // the last step may pass the end of the scene, but not the end of the known motion
    private static bool EndsInTime(double step, double duration) => Count(duration, step) * step <= duration * (Truth.Beyond - Meets);

    private static IEnumerable<double> Whole(double duration) => Enumerable.Range(1, FewSteps).Select(count => Plain(duration / count));

    private static IEnumerable<double> Decimals(double duration)
    {
        for (double step = duration; step > duration / Most; step /= Ratio)
            yield return double.Parse(step.ToString("G3", CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);
    }

    /// <summary>The step lengths that coincide with all times at which effects begin and end, from the longest down; none where there are no such times.</summary>
    public static IEnumerable<double> Aligned(SceneDescription scene, double duration)
    {
        double[] cuts = Cuts(scene, duration);
        if (cuts.Length == 0)
            yield break;

        double last = double.PositiveInfinity;
        for (long k = 1; cuts[0] / k > duration / Most; k++)
        {
            double step = Plain(cuts[0] / k);
            if (step * Math.Sqrt(Ratio) <= last && cuts.All(cut => Math.Abs(cut / step - Math.Round(cut / step)) < Meets))
                yield return last = step;
        }
    }

    /// <summary>0.2 in place of 0.20000000000000004, because the number is typed.</summary>
    private static double Plain(double step)
    {
        double plain = double.Parse(step.ToString("G12", CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);
        return Math.Abs(plain - step) < 4 * Math.BitIncrement(step) - 4 * step ? plain : step;
    }
}
