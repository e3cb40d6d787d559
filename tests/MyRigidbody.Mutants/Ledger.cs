using System.Text.Json;

namespace RigidBodyDynamics.Mutants;

/// <summary>The outcomes of the last whole run, so that after a new test only its survivors have to be asked again.</summary>
internal sealed class Ledger(string path)
{
    /// <summary>What survived the last whole run.</summary>
    public HashSet<(string, string, string, int)> Survivors =>
        [.. Read().Where(entry => entry.Fate is Fate.Survived or Fate.KilledByGolden).Select(entry => Key(entry.Mutant))];

    /// <summary>Whether a mutant is among some outcomes; its place counts within its file, until that is edited.</summary>
    public static (string, string, string, int) Key(Mutant mutant) => (mutant.File, mutant.Line, mutant.Change, mutant.Start);

    /// <summary>The last whole run, with new outcomes in the place of old ones.</summary>
    public Outcome[] Renewed(IEnumerable<Outcome> outcomes)
    {
        Dictionary<(string, string, string, int), Outcome> renewed = outcomes.ToDictionary(outcome => Key(outcome.Mutant));
        return [.. Read().Select(entry => renewed.GetValueOrDefault(Key(entry.Mutant), entry))];
    }

    public void Write(IEnumerable<Outcome> outcomes) => File.WriteAllText(path, JsonSerializer.Serialize(outcomes));

    private Outcome[] Read() => JsonSerializer.Deserialize<Outcome[]>(File.ReadAllText(path))!;
}
