using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Grading.Judging;
using RigidBodyDynamics.Lab.Grading.Likeness;
using RigidBodyDynamics.Lab.Grading.Marks;
using RigidBodyDynamics.Lab.Grading.Reading;
using RigidBodyDynamics.Lab.Grading.Students;

namespace RigidBodyDynamics.Lab.Grading;

/// <summary>The class: all submissions, missing students, similar scripts.</summary>
/// <param name="Name">Its name: the given path.</param>
/// <param name="Submissions">Ordered by student.</param>
/// <param name="Roster">The class list; null where none was given.</param>
/// <param name="Pairs">Pairs of submissions, by their numbers, that share much.</param>
/// <param name="Scheme">The points.</param>
/// <param name="Passed">Files that were skipped, by place.</param>
/// <param name="Unused">Decisions about files that do not exist.</param>
internal sealed record Class(
    string Name,
    IReadOnlyList<Graded> Submissions,
    Roster? Roster,
    IReadOnlyList<Pair> Pairs,
    Scheme Scheme,
    IReadOnlyList<(string Place, Finding Finding)> Passed,
    IReadOnlyList<string> Unused)
{
    /// <summary>Students on the list without a submission.</summary>
    public IReadOnlyList<Student> Missing => Roster == null ? [] : [.. Roster.Students.Where(student => Submissions.All(one => one.Student is not Student known || Roster.Find(known) != student))];

    /// <summary>Combines what was read and judged.</summary>
    public static Class Of(string name, HandedIn handedIn, IReadOnlyList<(Submission Submission, Judgement Judgement)> judged, Roster? roster, MarksFile marks, string starter)
    {
        Graded[] all = [.. judged.Select(one => Settled(one.Submission, one.Judgement, roster, marks))
            .OrderBy(one => one.Student?.Id ?? "~", StringComparer.Ordinal)
            .ThenBy(one => one.File, StringComparer.Ordinal)];
        all = [.. all.Select(one => one with { Counts = Counting(one, all) == one })];
        IReadOnlyList<string> pages = PageNames.Of(all);
        int[] readable = [.. Enumerable.Range(0, all.Length).Where(i => all[i].Judgement.Text.Length > 0)];
        Pair[] pairs = [.. LookAlikes.Of([.. readable.Select(i => all[i].Judgement.Text)], [.. readable.Select(i => Owner(all[i]))], starter)
            .Select(pair => pair with { First = readable[pair.First], Second = readable[pair.Second] })];
        Graded[] submissions = [.. all.Select((one, i) => one with
        {
            Page = pages[i],
            Alike = [.. pairs.Where(pair => pair.First == i || pair.Second == i).Select(pair => new Alike(all[pair.First == i ? pair.Second : pair.First].File, pair.Share))],
        })];
        string[] unused = [.. marks.Decisions.Where(decision => !all.Any(one => IsAbout(decision, one.Submission, one.Measured))).Select(decision => decision.File)];
        return new Class(name, submissions, roster, pairs, marks.Scheme, handedIn.Notes, unused);
    }

    private static Graded Settled(Submission submission, Judgement measured, Roster? roster, MarksFile marks)
    {
        Graded open = new(submission, submission.Student, measured, measured, new(0, 0, 0, 0, 0), marks.Decisions.LastOrDefault(one => IsAbout(one, submission, measured)));
        bool isOld = open.Decision?.Content is string content && content != open.Content;
        Decision? decision = isOld ? null : open.Decision;
        Student? student = decision?.Student is Student named ? roster?.Find(named) ?? named : submission.Student;
        bool nameIsRight = submission.NameAsAsked || decision?.Steps.GetValueOrDefault(Step.Name) == true;
        Judgement settled = decision?.Settle(WithName(measured, submission)) ?? WithName(measured, submission);
        Marked marked = marks.Scheme.Of(settled, nameIsRight);
        marked = decision?.Points is double points ? marked with { Total = points, IsSet = true } : marked;
        return open with { Student = student, Judgement = settled, Marked = marked, Decision = decision, IsDecisionOld = isOld };
    }

    // a student named the package; a loose script may have been unpacked by anyone
    private static Judgement WithName(Judgement judgement, Submission submission) =>
        submission.NameAsAsked || submission.Student != null || !(submission.Spot.Shown.Contains('!') || FileKinds.IsArchive(submission.Spot.Name))
            ? judgement
            : judgement with { Verdict = judgement.Verdict.With(Problems.Name(submission.Spot.Name)) };

    private static bool IsAbout(Decision decision, Submission submission, Judgement judgement) =>
        decision.File == (judgement.File ?? submission.Spot.Shown) || decision.File == submission.Spot.Shown;

    /// <summary>The submission of a student that counts: the chosen one, or else the first of those with most points.</summary>
    private static Graded Counting(Graded one, IEnumerable<Graded> all) =>
        all.Where(other => Owner(other) == Owner(one) && other.Decision?.Counts != false).OrderByDescending(other => other.Decision?.Counts == true).ThenByDescending(other => other.Marked.Total).FirstOrDefault()!;

    private static string Owner(Graded one) => one.Student is Student student ? $"{student.Id}\n{(student.Id.Length > 0 ? string.Empty : student.Name)}" : one.File;
}
