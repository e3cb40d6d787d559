using System.Text.Json.Serialization;
using Microsoft.CodeAnalysis.Text;

namespace RigidBodyDynamics.Mutants;

/// <summary>A small error in one file of the Core: the text at a place, and its replacement.</summary>
/// <param name="File">From the folder of the Core, with forward slashes.</param>
/// <param name="Line">The line it is in, trimmed: it outlives its number.</param>
internal sealed record Mutant(string File, int Start, int Length, string Line, string Original, string Replacement)
{
    /// <summary>Where it is in the text of the file.</summary>
    [JsonIgnore]
    public TextSpan Span => new(Start, Length);

    /// <summary>The first folder of its path.</summary>
    [JsonIgnore]
    public string Folder => File.Split('/')[0];

    /// <summary>What is done, in one line; the text at the place may run over several.</summary>
    [JsonIgnore]
    public string Change => Short(Original) + " → " + (Replacement.Length == 0 || Replacement == ";" ? "nothing" : Short(Replacement));

    private static string Short(string text)
    {
        string line = string.Join(' ', text.Split((char[])[' ', '\r', '\n', '\t'], StringSplitOptions.RemoveEmptyEntries));
        return line.Length <= 90 ? line : line[..60] + " … " + line[^27..];
    }
}

/// <summary>The result of a mutant.</summary>
internal enum Fate
{
    /// <summary>A test that is not a golden hash failed.</summary>
    Killed,

    /// <summary>The tests did not come to an end, or the process did.</summary>
    TimedOut,

    /// <summary>Only the fingerprint of all bits changed.</summary>
    KilledByGolden,

    /// <summary>No test failed.</summary>
    Survived,

    /// <summary>The compiler refused it, or made the same code of it: not a mutant.</summary>
    NotOne,
}

/// <summary>A mutant, its result, and the test that decided it.</summary>
internal sealed record Outcome(Mutant Mutant, Fate Fate, string By);
