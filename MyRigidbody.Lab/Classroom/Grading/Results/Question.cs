using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Unicode;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Checking;
using RigidBodyDynamics.Lab.Grading.Judging;
using RigidBodyDynamics.Lab.Grading.Marks;
using RigidBodyDynamics.Lab.Grading.Students;
using RigidBodyDynamics.Lab.Languages;

namespace RigidBodyDynamics.Lab.Grading;

/// <summary>An answer that an instructor can give: a line for the file of <c>--marks</c>.</summary>
/// <param name="Meaning">Its meaning.</param>
/// <param name="Line">The line.</param>
internal sealed record Answer(Word Meaning, string Line);

/// <summary>A decision that an instructor has to make.</summary>
/// <param name="Kind">Its reason: <c>doubt</c>, <c>run</c>, <c>twice</c>, <c>whose</c>.</param>
/// <param name="About">The submission.</param>
/// <param name="What">The question.</param>
/// <param name="Expected">The sheet's formula.</param>
/// <param name="Found">The script's formula.</param>
/// <param name="Answers">The possible answers.</param>
internal sealed record Question(string Kind, Graded About, Word What, string Expected, string Found, IReadOnlyList<Answer> Answers)
{
    private static readonly JsonSerializerOptions Options = new() { Encoder = JavaScriptEncoder.Create(UnicodeRanges.All) };

    /// <summary>All open questions of a class, those about steps first.</summary>
    public static IReadOnlyList<Question> Of(Class all) =>
    [
        .. all.Submissions.SelectMany(Doubts),
        .. all.Submissions.Where(one => one.IsDecisionOld).Select(one => new Question(
            "doubt", one, GradeWords.All["ask.old"], one.Decision?.Content ?? string.Empty, one.Content, [])),
        .. all.Submissions.SelectMany(NotRun),
        .. all.Submissions.GroupBy(one => one.Student?.Id).Where(group => !string.IsNullOrEmpty(group.Key) && group.Count() > 1 && group.All(one => one.Decision?.Counts == null)).SelectMany(Twice),
        .. all.Submissions.Where(one => one.Student == null || one.Student.Id.Length == 0 || (all.Roster != null && all.Roster.Find(one.Student) == null)).Select(one => Whose(one, all.Roster)),
    ];

    private static IEnumerable<Question> Doubts(Graded one)
    {
        // a script that has not run gets a question below: points are possible, but its steps cannot be declared right
        IEnumerable<Finding> doubtful = one.Judgement.Verdict.Findings.Where(finding => finding.IsDoubtful && !(finding.Step == Step.Code && HasNotRun(one)));
        foreach (IGrouping<Step, Finding> doubts in doubtful.GroupBy(finding => finding.Step))
        {
            Finding first = doubts.First();
            IReadOnlyList<Answer> answers = one.Judgement.Candidates.Count > 0
                ? [.. one.Judgement.Candidates.Select(candidate => new Answer(GradeWords.All["answer.use"].With(candidate.File!, Marks(candidate)), Line(one, "use", candidate.File!)))]
                : [.. new[] { "right", "wrong" }.Select(value => new Answer(GradeWords.All["answer." + value], Line(one, MarksFile.NameOf(doubts.Key), value)))];
            yield return new Question("doubt", one, new Word(first.English, first.Chinese), Measured(first, first.Expected), Measured(first, first.Found), answers);
        }
    }

    private static IEnumerable<Question> NotRun(Graded one) =>
        HasNotRun(one)
            ? one.Marked.IsSet ? [] : one.Judgement.Verdict.Findings.Take(1).Select(finding => new Question(
                "run", one, new Word(finding.English, finding.Chinese), Measured(finding, finding.Expected), Measured(finding, finding.Found), [new Answer(GradeWords.All["answer.points"], Line(one, "points", 0))]))
            : [];

    // beside a sentence about code stand words of a programmer, in English alone
    private static string Measured(Finding finding, string value) => CheckWords.IsMeasured(finding) ? value : string.Empty;

    private static bool HasNotRun(Graded one) =>
        one.Judgement.Verdict.Outcome == Outcome.Refused || Verdict.FiveSteps.All(step => one.Judgement.Verdict[step] == Mark.Unknown);

    private static IEnumerable<Question> Twice(IEnumerable<Graded> group) => group.Select(one => new Question(
        "twice",
        one,
        GradeWords.All[one.Counts ? "ask.twice.counts" : "ask.twice"],
        string.Empty,
        Marks(one.Judgement),
        [new Answer(GradeWords.All["answer.counts"], Line(one, "counts", true)), new Answer(GradeWords.All["answer.counts.not"], Line(one, "counts", false))]));

    private static Question Whose(Graded one, Roster? roster) => new(
        "whose",
        one,
        GradeWords.All[one.Student == null ? "ask.whose" : one.Student.Id.Length == 0 ? "ask.id" : "ask.roster"],
        "学号_姓名",
        one.Student is { } student ? $"{student.Id} {student.Name}".Trim() : one.Submission.Spot.Name,
        [new Answer(GradeWords.All["answer.student"], Line(one, "student", new
        {
            // the number may have been mistyped
            id = roster?.Namesake(one.Student?.Name ?? string.Empty)?.Id ?? one.Student?.Id ?? string.Empty,
            name = one.Student?.Name ?? string.Empty,
        }))]);

    private static string Marks(Judgement judgement) => string.Concat(Verdict.FiveSteps.Select(step => judgement.Verdict[step] switch
    {
        Mark.Right => "✓",
        Mark.Wrong => "✗",
        Mark.Doubtful => "?",
        Mark.Missing => "–",
        _ => "·",
    }));

    private static string Line(Graded one, string name, object value) => JsonSerializer.Serialize(
        new Dictionary<string, object> { ["file"] = one.File, ["content"] = one.Content, [name] = value }, Options) + ",";
}
