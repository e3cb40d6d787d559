namespace RigidBodyDynamics.Lab.Comparison;

/// <summary>What one rule contributes to the difference of a pair.</summary>
/// <param name="Difference">What was exchanged.</param>
/// <param name="Distance">How far its exchange, in turn, moves the body on the way from mine to Unity's, mean over the run, m.</param>
/// <param name="Turn">The same for the turning, rad.</param>
/// <param name="Alone">How far mine is from itself when this rule and no other is exchanged.</param>
internal sealed record RuleShare(Difference Difference, double Distance, double Turn, Apart Alone);

/// <summary>
/// Explains the difference of a pair. Between mine and Unity's stand the bodies in which the first, the first two, ...
/// rules are exchanged; all move at once. At every moment the way from mine to Unity's is the sum of the ways from each
/// of these bodies to the next; their parts along it are the shares, which therefore add up to the whole. A share is
/// negative where a rule takes back what another gives.
/// </summary>
internal sealed record RuleShares(Apart Whole, IReadOnlyList<RuleShare> Shares)
{
    /// <summary>Runs the pair and everything between it.</summary>
    public static RuleShares Of(Pair pair, TimeSteps steps)
    {
        IReadOnlyList<Difference> rules = Difference.Between(pair);
        int count = rules.Count;
        SideBySide run = new(steps, [.. Between(pair, rules), .. Alone(pair, rules)]);
        Apart whole = new();
        Apart[] alone = [.. rules.Select(_ => new Apart())];
        double[] distance = new double[count], turn = new double[count];
        while (run.Step())
        {
            whole.Add(run.Between(0, count));
            Vector3d way = Direction(run[count].Position - run[0].Position), turnWay = Direction(run.Turned(count) - run.Turned(0));
            for (int i = 0; i < count; i++)
            {
                distance[i] += Vector3d.Dot(way, run[i + 1].Position - run[i].Position) / steps.Count;
                turn[i] += Vector3d.Dot(turnWay, run.Turned(i + 1) - run.Turned(i)) / steps.Count;
                alone[i].Add(run.Between(0, count + 1 + i));
            }
        }

        return new RuleShares(whole, [.. rules.Select((rule, i) => new RuleShare(rule, distance[i], turn[i], alone[i]))]);
    }

    /// <summary>Mine, the bodies between, and Unity's: one more than there are rules.</summary>
    private static IEnumerable<BodyDescription> Between(Pair pair, IReadOnlyList<Difference> rules)
    {
        yield return pair.Mine;
        BodyDescription now = Difference.LabInUnitysShape(pair.Mine);
        foreach (Difference rule in rules.SkipLast(1))
        {
            now = rule.Exchange(now);
            yield return now;
        }

        yield return pair.Default;
    }

    private static IEnumerable<BodyDescription> Alone(Pair pair, IReadOnlyList<Difference> rules) =>
        rules.Select(rule => rule.Exchange(Difference.LabInUnitysShape(pair.Mine)));

    private static Vector3d Direction(Vector3d v) => v.IsZero ? v : v / v.Length;
}
