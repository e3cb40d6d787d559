namespace RigidBodyDynamics.Mutants;

/// <summary>
/// Which tests are run for a mutant, and in which order: those that reach it, first those that killed its neighbours,
/// then those that are fast and reach little else, in batches that double, and no more than can run in three and a half seconds.
/// </summary>
internal sealed class Plan(Coverage coverage, Marks marks)
{
    // the only fixture whose expected value is the program's own output
    private const string Golden = "RigidBodyDynamics.Tests.FingerprintTests";
    private const double Longest = 3500;
    private readonly HashSet<int> _once = [.. coverage.Once];
    private readonly Dictionary<string, int> _noticed = [];

    /// <summary>The batches for a mutant; none if nothing reaches it.</summary>
    public Batch[] For(Mutant mutant, bool golden)
    {
        // code outside all marks, or run when a type is first used, may affect any test
        bool isFeltEverywhere = marks.Around(mutant) is not int mark || _once.Contains(mark);
        int around = marks.Around(mutant) ?? -1;
        IEnumerable<KnownTest> tests = coverage.Tests.Where(test => (test.Fixture == Golden) == golden);
        List<KnownTest> reaching = [.. tests.Where(test => isFeltEverywhere || test.Marks.Contains(around))];
        lock (_noticed)
        {
            reaching = [.. reaching
                .OrderByDescending(test => test.Milliseconds < 100 ? Math.Min(3, _noticed.GetValueOrDefault(test.Name + mutant.File)) : 0)
                .ThenBy(test => test.Milliseconds * test.Marks.Length)];
        }

        double sum = 0, longest = golden ? double.PositiveInfinity : isFeltEverywhere ? 6 * Longest : Longest;
        reaching = [.. reaching.TakeWhile(test => (sum += test.Milliseconds) < longest)];
        List<Batch> batches = [];
        for (int from = 0, count = 2; from < reaching.Count; from += count, count *= 2)
            batches.Add(BatchOf(reaching.GetRange(from, Math.Min(count, reaching.Count - from))));
        return [.. batches];
    }

    /// <summary>Remembers that a test killed a mutant.</summary>
    public void Noticed(Mutant mutant, string test)
    {
        lock (_noticed)
            _noticed[test + mutant.File] = _noticed.GetValueOrDefault(test + mutant.File) + 1;
    }

    // ten times what it takes on a quiet machine, and time to load
    private static Batch BatchOf(List<KnownTest> tests) => new(
        [.. tests.Select(test => test.Fixture).Distinct()],
        [.. tests.Select(test => test.Name)],
        10_000 + 10 * tests.Sum(test => test.Milliseconds));
}
