using System.Text.Json;

namespace RigidBodyDynamics.Mutants;

/// <summary>Why a survivor survives, as somebody found who looked at it: reasons.json beside this file.</summary>
internal sealed class Reasons
{
    private readonly List<Reason> _all;
    private readonly HashSet<Reason> _used = [];

    private Reasons(List<Reason> all) => _all = all;

    /// <summary>Reasons that no survivor has asked for.</summary>
    public IEnumerable<string> Unused => _all.Where(reason => !_used.Contains(reason)).Select(reason => $"{reason.File}: {reason.Line}: {reason.Change}");

    public static Reasons Read(string path) =>
        new(JsonSerializer.Deserialize<List<Reason>>(File.ReadAllText(path), new JsonSerializerOptions(JsonSerializerDefaults.Web) { ReadCommentHandling = JsonCommentHandling.Skip })!);

    /// <summary>The first reason that fits; nothing if nobody has looked yet.</summary>
    public string? For(Mutant mutant)
    {
        Reason? found = _all.Find(reason => reason.File == mutant.File && reason.Fits(mutant));
        if (found != null)
            _used.Add(found);
        return found?.Because;
    }

    /// <summary>For the mutants of a file whose line contains a text and whose change contains one of some others.</summary>
    private sealed record Reason(string File, string Line, string[] Change, string Because)
    {
        public bool Fits(Mutant mutant) =>
            mutant.Line.Contains(Line, StringComparison.Ordinal) && (Change.Length == 0 || Change.Contains(mutant.Change));
    }
}
