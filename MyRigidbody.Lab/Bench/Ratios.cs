using System.Globalization;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Bench;

/// <summary>Ratios of times within one run, of measurements taken alternately.</summary>
internal static class Ratios
{
    /// <summary>The names of the compared measurements, so that a test can ensure that they are taken.</summary>
    public static IEnumerable<string> Names =>
        Single().Select(ratio => (ratio.Of, ratio.To)).Concat(Many().Select(ratio => (ratio.Of, ratio.To)))
            .SelectMany(pair => new[] { pair.Of, pair.To }).Distinct();

    /// <summary>All ratios that the measurements allow.</summary>
    public static TextTable Table(IReadOnlyList<Measurement> all)
    {
        TextTable table = new("ratio", "of", "to", "is");
        foreach ((string title, string of, string to) in Single())
            Add(title, of, to);

        foreach (int bodies in all.Select(m => m.Bodies).Distinct().Where(count => count > 1))
        {
            foreach ((string title, string of, string to, int threads) in Many())
                Add(title, of, to, bodies, threads);
        }

        foreach (string what in new[] { "Exact, three moments, one by one", "LabEuler, one by one", "Exact, three moments, described one by one" })
        {
            if (Find(what, 100_000, 1) is Measurement many && Find(what, 1000, 1) is Measurement few)
                table.AddRow("100,000 bodies to 1,000, one by one", many.What, few.What, many.RatioTo(few).ToString("0.00", CultureInfo.InvariantCulture));
        }

        return table;

        void Add(string title, string of, string to, int bodies = 1, int threads = 1)
        {
            Measurement? a = Find(of, bodies, 1), b = Find(to, bodies, threads);
            if (a is not null && b is not null)
            {
                string many = bodies > 1 ? $", {bodies:N0} bodies" : string.Empty;
                table.AddRow(title + many, of, to + (threads > 1 ? ", two threads" : string.Empty),
                    a.RatioTo(b).ToString(a.Median < 0.01 * b.Median ? "0.0e0" : "0.00", CultureInfo.InvariantCulture));
            }
        }

        Measurement? Find(string what, int bodies, int threads) =>
            all.FirstOrDefault(m => m.What == what && m.Bodies == bodies && m.Threads == threads);
    }

    /// <summary>
    /// Whether the ratios are reliable: the ratio of every second repeat of a measurement to the others. Data larger than a cache varies a
    /// little on a quiet machine, too, so one measurement in twenty may deviate.
    /// </summary>
    public static string Quiet(IEnumerable<(string What, double RatioToItself)> all)
    {
        const double Most = 0.02, Part = 0.05;
        List<(string What, double Off)> off = [.. all.Select(m => (m.What, Off: Math.Abs(m.RatioToItself - 1))).OrderByDescending(m => m.Off)];
        int far = off.Count(m => m.Off > Most);
        return FormattableString.Invariant($"measurements to themselves: {off.Count - far} of {off.Count} within 2 %, the worst {100 * off[0].Off:0.0} % apart, {off[0].What}; ")
            + (far <= Part * off.Count ? "the machine was quiet" : "THE RUN IS NOISY, its ratios mean nothing; close other programs and measure again");
    }

    private static IEnumerable<(string Title, string Of, string To)> Single()
    {
        yield return ("Exact to the naive step", "free body by Exact", "free body by LabEuler");
        yield return ("Exact to the naive step, a step a call", "Exact, free, a step a call", "LabEuler, free, a step a call");
        foreach (string torque in new[] { "a constant torque", "a torque by sin t" })
            yield return ("Exact to RungeKutta4", $"Exact, {torque}", $"RungeKutta4, {torque}");

        yield return ("the library's step to one written by hand", "lab's step, by the library", "lab's step, written by hand");
        yield return ("a measurement to itself", "Exact, no effect, again", "Exact, no effect");
        foreach (string effect in new[] { "gravity", "linear damping", "angular damping", "force", "torque", "drag", "spring" })
        {
            yield return ("an effect that is idle", $"Exact, {effect} idle", "Exact, no effect");
            yield return ("an effect that acts", $"Exact, {effect} on", "Exact, no effect");
        }

        yield return ("keys that are not held", "Exact, gravity and keys that are not held", "Exact, gravity on");
        foreach (string rule in new[] { "Exact", "LabEuler" })
        {
            yield return ("an effect that pushes nothing", $"{rule}, falls, and is pushed by nothing, 1000 steps a call", $"{rule}, falls, 1000 steps a call");
            foreach (string what in new[] { "free", "falls", "falls, and is pushed by nothing" })
                yield return ("a step a call", $"{rule}, {what}, a step a call", $"{rule}, {what}, 1000 steps a call");
        }

        yield return ("a body that does not turn", "Exact, no spin", "Exact, three different moments");
        yield return ("two equal moments", "Exact, two equal moments", "Exact, three different moments");
        yield return ("three equal moments", "Exact, three equal moments", "Exact, three different moments");
        yield return ("coasting, state not read", "Exact, coasting, state not read", "Exact, three different moments");
        yield return ("at rest", "Exact, at rest", "Exact, three different moments");
        yield return ("Unity's, asleep", "UnityRigidbody, asleep", "Exact, three different moments");
        yield return ("damped to nothing", "LabEuler, damped for 100000 steps", "LabEuler, damped for 0 steps");
        yield return ("damped to nothing", "Exact, damped for 100000 steps", "Exact, damped for 0 steps");
    }

    private static IEnumerable<(string Title, string Of, string To, int Threads)> Many()
    {
        foreach (string what in new[] { "Exact, three moments", "LabEuler", "translation" })
        {
            yield return ("lanes", what + ", one by one", what + ", together", 1);
            yield return ("two threads", what + ", together", what + ", together", 2);
        }

        yield return ("to what the memory can do", "Exact, three moments, together", "in-place scale of 26 doubles a body", 1);
        yield return ("to what the memory can do", "LabEuler, together", "in-place scale of 13 doubles a body", 1);
        yield return ("all states to a step", "Exact, three moments, all states read", "Exact, three moments, together", 1);
        yield return ("described one by one", "Exact, three moments, described one by one", "Exact, three moments, together", 1);
        yield return ("coasting, state not read", "Exact, coasting, state not read, together", "Exact, three moments, together", 1);
    }
}
