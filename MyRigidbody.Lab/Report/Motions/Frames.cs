namespace RigidBodyDynamics.Lab.Report;

/// <summary>Which moments of a run a page holds: all of a short one, evenly chosen ones of a long one, and always the last.</summary>
internal static class Frames
{
    /// <summary>The start and 3000 steps: more than a minute at 40 pictures a second.</summary>
    public const int Most = 3001;

    /// <summary>Bodies beyond these are not drawn.</summary>
    public const int MostBodies = 40;

    // what is left of 5 MB beside the plotting library
    private const int MostPoses = 4 * Most;

    /// <summary>The first and last of so many moments, and those between them that are a multiple of one number.</summary>
    public static IEnumerable<long> Of(long moments, int bodies)
    {
        long most = Math.Clamp(MostPoses / Math.Max(1, bodies), 2, Most);
        long stride = moments <= most ? 1 : (moments - 2) / (most - 1) + 1;
        for (long at = 0; at < moments - 1; at += stride)
        {
            yield return at;
        }

        yield return moments - 1;
    }
}
