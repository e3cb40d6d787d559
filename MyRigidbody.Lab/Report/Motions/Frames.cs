namespace RigidBodyDynamics.Lab.Report;

/// <summary>The moments of a run that a page contains: all of a short run, evenly chosen ones of a long one, and always the last.</summary>
internal static class Frames
{
    /// <summary>The start and 3000 steps: more than a minute at 40 pictures a second.</summary>
    public const int Most = 3001;

    /// <summary>The largest number of bodies that are drawn.</summary>
    public const int MostBodies = 40;

    // for a page of 5 MB with the plotting library
    private const int MostPoses = 4 * Most;

    /// <summary>The first and the last moment, and those between that are a multiple of one number.</summary>
    public static IEnumerable<long> Of(long moments, int bodies)
    {
        long most = Math.Clamp(MostPoses / Math.Max(1, bodies), 2, Most);
        long stride = moments <= most ? 1 : (moments - 2) / (most - 1) + 1;
        for (long at = 0; at < moments - 1; at += stride)
            yield return at;

        yield return moments - 1;
    }
}
