using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Grading.Reading;

namespace RigidBodyDynamics.Lab.Grading.Judging;

/// <summary>The result for the script of a submission.</summary>
/// <param name="Verdict">Marks of the five steps, and their reasons.</param>
/// <param name="Statements">Statements that the student added to the starter.</param>
/// <param name="Uncommented">Lines of those statements that have no comment.</param>
/// <param name="File">The place of the script; null where there is none.</param>
/// <param name="Text">The script.</param>
internal sealed record Judgement(Verdict Verdict, int Statements, IReadOnlyList<int> Uncommented, string? File, string Text)
{
    /// <summary>The judgement of each script where a submission has more than one that may be the one; else none.</summary>
    public IReadOnlyList<Judgement> Candidates { get; init; } = [];

    /// <summary>Statements that have a comment.</summary>
    public int Commented => Statements - Uncommented.Count;

    /// <summary>The judgement of a submission in which nothing can be judged.</summary>
    public static Judgement Nothing(Mark mark, Finding reason) =>
        new(new Verdict(Verdict.FiveSteps.ToDictionary(step => step, _ => mark), [reason]), 0, [], null, string.Empty);

    /// <summary>The judgement where two scripts or more may be the one: their common marks, and doubt about the rest.</summary>
    public static Judgement Between(IReadOnlyList<Judgement> candidates)
    {
        Dictionary<Step, Mark> marks = Verdict.FiveSteps.ToDictionary(
            step => step, step => candidates.All(one => one.Verdict[step] == Mark.Right) ? Mark.Right : Mark.Doubtful);
        return candidates[0] with { Verdict = new Verdict(marks, [Problems.TwoScripts(candidates.Select(one => one.File!))]), Candidates = candidates };
    }
}

/// <summary>Judges the scripts of one submission. Used by one thread.</summary>
internal interface IScriptJudge : IDisposable
{
    /// <summary>Judges the first script, compiled together with the others.</summary>
    Judgement Judge(IReadOnlyList<Script> scripts);
}
