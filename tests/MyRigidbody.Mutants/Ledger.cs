using System.Text.Json;

namespace RigidBodyDynamics.Mutants;

/// <summary>
/// The stored results of all mutants, so that an interrupted run can continue, and after a new test only the survivors have to
/// be run again.
/// </summary>
internal sealed class Ledger
{
    private readonly string _path;
    private readonly Dictionary<Mutant, Outcome> _known;

    public Ledger(string path)
    {
        _path = path;
        Outcome[] written = File.Exists(path) ? JsonSerializer.Deserialize<Outcome[]>(File.ReadAllText(path))! : [];
        _known = written.ToDictionary(outcome => outcome.Mutant);
    }

    /// <summary>The result of a mutant; null if it has not been run, or its file has changed.</summary>
    public Fate? this[Mutant mutant] => _known.GetValueOrDefault(mutant)?.Fate;

    /// <summary>Writes these, and what was known of others.</summary>
    public void Add(IEnumerable<Outcome> outcomes)
    {
        lock (_known)
        {
            foreach (Outcome outcome in outcomes)
                _known[outcome.Mutant] = outcome;
            File.WriteAllText(_path, JsonSerializer.Serialize(_known.Values));
        }
    }

    /// <summary>The outcomes of some mutants, in their order.</summary>
    public Outcome[] Of(IEnumerable<Mutant> mutants) => [.. mutants.Where(_known.ContainsKey).Select(mutant => _known[mutant])];
}
