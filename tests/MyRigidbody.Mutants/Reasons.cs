using System.Text.Json;

namespace RigidBodyDynamics.Mutants;

/// <summary>
/// Why a survivor survives, as found by examining it: reasons.json beside this file. A reason either says that the mutant does
/// the same as the original, except for time and the last bits, or that the tests are too weak for it.
/// </summary>
internal sealed class Reasons
{
    private readonly List<Reason> _all;
    private readonly HashSet<Reason> _used = [];

    private Reasons(List<Reason> all) => _all = all;

    /// <summary>Reasons that no survivor has used.</summary>
    public IEnumerable<string> Unused => _all.Where(reason => !_used.Contains(reason)).Select(reason => $"{reason.File}: {reason.Line}: {reason.Change}");

    public static Reasons Read(string path) =>
        new(JsonSerializer.Deserialize<List<Reason>>(File.ReadAllText(path), new JsonSerializerOptions(JsonSerializerDefaults.Web) { ReadCommentHandling = JsonCommentHandling.Skip })!);

    /// <summary>True if a reason says that the mutant does the same as the original.</summary>
    public bool IsSame(Mutant mutant) => Find(mutant)?.Same == true;

    /// <summary>The first reason that fits; none if the survivor has not been examined yet.</summary>
    public string? For(Mutant mutant) => Find(mutant)?.Because;

    private Reason? Find(Mutant mutant)
    {
        Reason? found = _all.Find(reason => reason.File == mutant.File && reason.Fits(mutant));
        if (found != null)
            _used.Add(found);
        return found;
    }

    /// <summary>For the mutants of a file whose line contains a text and whose change is one of those listed, or any if none is.</summary>
    private sealed record Reason(string File, string Line, string[] Change, bool Same, string Because)
    {
        public bool Fits(Mutant mutant) =>
            mutant.Line.Contains(Line, StringComparison.Ordinal) && (Change.Length == 0 || Change.Contains(mutant.Change));
    }
}
