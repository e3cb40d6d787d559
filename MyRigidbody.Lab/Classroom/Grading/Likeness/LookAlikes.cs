namespace RigidBodyDynamics.Lab.Grading.Likeness;

/// <summary>Two scripts that share much which is neither the starter's nor common in the class.</summary>
/// <param name="First">Number of the one, in the given order.</param>
/// <param name="Second">Number of the other.</param>
/// <param name="Share">The part of the shorter one's own tokens that the other has, too, from 0 to 1.</param>
/// <param name="FirstLines">Lines of the one with shared tokens.</param>
/// <param name="SecondLines">Lines of the other with shared tokens.</param>
internal sealed record Pair(int First, int Second, double Share, IReadOnlySet<int> FirstLines, IReadOnlySet<int> SecondLines);

/// <summary>Finds scripts to compare side by side. It measures what two texts share, and does not say why.</summary>
internal static class LookAlikes
{
    /// <summary>The share from which a pair is named.</summary>
    public const double Least = 0.6;

    // a sequence in this share of the scripts is common; in a small class two or three equal scripts are not
    private const double CommonShare = 0.4;
    private const int CommonCount = 3;

    // with fewer own tokens no comparison is meaningful
    private const int FewestTokens = 60;

    /// <summary>The pairs, the most alike first.</summary>
    /// <param name="scripts">Texts of the class.</param>
    /// <param name="owners">The student of each; two scripts of one student are not compared.</param>
    /// <param name="starter">The text that all received.</param>
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

    /// <summary>As few pairs as connect scripts that are all alike: for four scripts three pairs, and not six.</summary>
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
