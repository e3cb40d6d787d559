using System.Text.Json;
using System.Text.RegularExpressions;
using RigidBodyDynamics.Judging;

namespace RigidBodyDynamics.Tests.Judging;

/// <summary>
/// One script of <c>tests/data/variations</c>: a right script with some text exchanged and some regions replaced.
/// </summary>
/// <param name="Name">The variation.</param>
/// <param name="Outcome">The expected outcome.</param>
/// <param name="Steps">The steps that are wrong; 0 is the given code.</param>
/// <param name="Code">The code of the mistake, where it has one.</param>
/// <param name="Text">The script.</param>
internal sealed record Variation(string Name, Outcome Outcome, int[] Steps, string? Code, string Text)
{
    public static IEnumerable<Variation> All()
    {
        string common = File.ReadAllText(TestData.Path("variations", "MyRigidbody.cs")).ReplaceLineEndings("\n");
        return new[] { Outcome.Right, Outcome.Wrong, Outcome.Doubtful }.SelectMany(outcome =>
            JsonSerializer.Deserialize<Entry[]>(File.ReadAllText(TestData.Path("variations", outcome.ToString().ToLowerInvariant() + ".json")), JsonSerializerOptions.Web)!
                .Select(entry => new Variation(entry.Name, outcome, entry.Steps ?? [], entry.Code, entry.From(common))));
    }

    public override string ToString() => Name;

    private sealed record Entry(string Name, int[]? Steps, string? Code, Dictionary<string, string>? Replace, Dictionary<string, string[]>? Put)
    {
        public string From(string text)
        {
            foreach ((string old, string other) in Replace ?? [])
            {
                if (!text.Contains(old, StringComparison.Ordinal))
                    throw new InvalidDataException($"{Name}: there is no '{old}'");
                text = text.Replace(old, other, StringComparison.Ordinal);
            }

            foreach ((string region, string[] lines) in Put ?? [])
            {
                Regex body = new($@"(?<=#region {region}\n).*?(?= *#endregion)", RegexOptions.Singleline);
                if (body.Count(text) != 1)
                    throw new InvalidDataException($"{Name}: there is no region '{region}'");
                text = body.Replace(text, _ => string.Concat(lines.Select(line => line + "\n")));
            }

            return text;
        }
    }
}
