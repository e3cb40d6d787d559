namespace RigidBodyDynamics.Lab.Comparison;

/// <summary>The share of one rule in the difference of a pair.</summary>
/// <param name="Difference">The exchanged rule.</param>
/// <param name="Distance">How far its exchange, in its place in the order, moves the body along the difference, mean over the run, m.</param>
/// <param name="Turn">The same for the turn, rad.</param>
/// <param name="Alone">The difference of the body from itself when only this rule is exchanged.</param>
internal sealed record RuleShare(Difference Difference, double Distance, double Turn, Apart Alone);

/// <summary>
/// Explains the difference of a pair. Between the two are the bodies in which the first, the first two, ... rules are exchanged;
/// all move at the same time. At every time the difference of the pair is the sum of the differences from each of these bodies to
/// the next; their components along it are the shares, which therefore add up to the whole. A share is negative where one rule
/// cancels a part of another's.
/// </summary>
internal sealed record RuleShares(Apart Whole, IReadOnlyList<RuleShare> Shares)
{
    /// <summary>Runs the pair and the bodies between.</summary>
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

    /// <summary>The first body of the pair, those between, and the second: one more than there are rules.</summary>
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
