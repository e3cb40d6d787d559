using System.Text.RegularExpressions;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Grading.Judging;
using RigidBodyDynamics.Lab.Grading.Reading;
using RigidBodyDynamics.StudentScripts;
using Match = System.Text.RegularExpressions.Match;

namespace RigidBodyDynamics.Tests.Grading;

/// <summary>
/// Replaces the judge in tests about reading, deciding and writing: a script states its own verdict in comments like
/// <c>//wrong: orientation half-missing</c>. Without any it is right.
/// </summary>
internal sealed partial class StandInBench : IBench
{
    private int _judged;

    /// <summary>The number of scripts that were judged and not taken from the store.</summary>
    public int Judged => _judged;

    /// <summary>After this many scripts the run ends as if it were killed.</summary>
    public int EndsAfter { get; init; } = int.MaxValue;

    public string Version { get; init; } = "stand-in";

    public string Starter { get; init; } = string.Empty;

    public IScriptJudge NewJudge() => new Judge(this);

    [GeneratedRegex(@"// (right|wrong|doubtful|missing|refused|unknown): (\w+) ?(\S*)")]
    private static partial Regex Said();

    private sealed class Judge(StandInBench bench) : IScriptJudge
    {
        Judgement IScriptJudge.Judge(IReadOnlyList<Script> scripts)
        {
            if (Interlocked.Increment(ref bench._judged) > bench.EndsAfter)
                throw new OperationCanceledException("killed");

            string text = SourceText.Decode(scripts[0].Bytes).Text;
            Dictionary<Step, Mark> marks = Verdict.FiveSteps.ToDictionary(step => step, _ => Mark.Right);
            List<Finding> findings = [];
            bool refused = false;
            foreach (Match said in Said().Matches(text))
            {
                Step step = Enum.Parse<Step>(said.Groups[2].Value, ignoreCase: true);
                Finding finding = new Finding(step, said.Groups[3].Value, "k = ½ Δt", "k = 1.00 Δt", $"Step {step}: {said.Groups[3].Value}.", $"{step}：{said.Groups[3].Value}。")
                    .At(text[..said.Index].Count(letter => letter == '\n') + 1).From("box", 3);
                refused |= said.Groups[1].Value == "refused";
                findings.Add(said.Groups[1].Value is "doubtful" or "unknown" ? finding.ForInstructor() : finding);
                if (said.Groups[1].Value == "unknown")
                    marks = [];

                if (!refused)
                    marks[step] = Enum.Parse<Mark>(said.Groups[1].Value, ignoreCase: true);
            }

            int statements = text.Count(letter => letter == ';');
            return new Judgement(refused ? Verdict.Refused([.. findings]) : new Verdict(marks, findings), statements, [.. Enumerable.Range(1, statements / 5)], null, text);
        }

        public void Dispose()
        {
        }
    }
}
