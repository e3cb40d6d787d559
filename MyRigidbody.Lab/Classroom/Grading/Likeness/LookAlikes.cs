namespace RigidBodyDynamics.Lab.Grading.Likeness;

/// <summary>Two scripts that have much in common which is neither the starter's nor the class's.</summary>
/// <param name="First">Number of the one, in the order they were given.</param>
/// <param name="Second">Number of the other.</param>
/// <param name="Share">Part of the shorter one's own tokens that the other has too, from 0 to 1.</param>
/// <param name="FirstLines">Lines of the one that hold what both have.</param>
/// <param name="SecondLines">Lines of the other that do.</param>
internal sealed record Pair(int First, int Second, double Share, IReadOnlySet<int> FirstLines, IReadOnlySet<int> SecondLines);

/// <summary>Finds scripts that are worth being looked at side by side. It measures what two texts share, and says nothing about why.</summary>
internal static class LookAlikes
{
    /// <summary>The share from which a pair is named.</summary>
    public const double Least = 0.6;

    // what so many have written, everybody writes; in a small class two or three alike are not everybody
    private const double CommonShare = 0.4;
    private const int CommonCount = 3;

    // of fewer tokens of one's own nothing can be said
    private const int FewestTokens = 60;

    /// <summary>The pairs, the most alike first.</summary>
    /// <param name="scripts">Texts of the class.</param>
    /// <param name="owners">Whose each is; two of one student's are not compared.</param>
    /// <param name="starter">The text that all were given.</param>
    /// <param name="least">The share from which a pair is named.</param>
    public static IReadOnlyList<Pair> Of(IReadOnlyList<string> scripts, IReadOnlyList<string> owners, string starter, double least = Least)
    {
        Fingerprint[] all = [.. scripts.Select(Fingerprint.Of)];
        IReadOnlySet<string> given = Fingerprint.Of(starter).Runs;
        Dictionary<string, int> counts = [];
        foreach (string run in all.SelectMany(one => one.Runs))
            counts[run] = counts.GetValueOrDefault(run) + 1;

        double most = Math.Max(CommonCount, CommonShare * scripts.Count);
        HashSet<string>[] own = [.. all.Select(one => one.Runs.Where(run => counts[run] <= most && !given.Contains(run)).ToHashSet())];
        int[] tokens = [.. all.Zip(own, (one, runs) => one.Covered(runs.Contains))];
        List<Pair> pairs = [];
        for (int i = 0; i < all.Length; i++)
        {
            for (int j = i + 1; j < all.Length; j++)
            {
                int shorter = Math.Min(tokens[i], tokens[j]);
                if (owners[i] == owners[j] || shorter < FewestTokens || !own[i].Overlaps(own[j]))
                    continue;

                bool InBoth(string run) => own[i].Contains(run) && own[j].Contains(run);
                double share = Math.Min(1, (double)Math.Min(all[i].Covered(InBoth), all[j].Covered(InBoth)) / shorter);
                if (share >= least)
                    pairs.Add(new Pair(i, j, share, all[i].Lines(InBoth), all[j].Lines(InBoth)));
            }
        }

        return [.. pairs.OrderByDescending(pair => pair.Share).ThenBy(pair => pair.First).ThenBy(pair => pair.Second)];
    }

    /// <summary>Of pairs among several that are all alike, as few as join them: of four alike three pairs, and not six.</summary>
    public static IEnumerable<Pair> Joining(IEnumerable<Pair> pairs)
    {
        Dictionary<int, int> parents = [];
        return pairs.Where(pair =>
        {
            int first = Root(pair.First), second = Root(pair.Second);
            parents[first] = second;
            return first != second;
        }).ToArray();

        int Root(int one) => parents.TryGetValue(one, out int parent) && parent != one ? Root(parent) : one;
    }
}
