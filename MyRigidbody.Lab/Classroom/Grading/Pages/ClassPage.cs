using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Grading.Likeness;
using RigidBodyDynamics.Lab.Grading.Marks;
using RigidBodyDynamics.Lab.Languages;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Lab.Report;

namespace RigidBodyDynamics.Lab.Grading.Pages;

/// <summary>The page of the class: first what the instructor has to decide, then the table, the mistakes, similar scripts, missing students.</summary>
internal sealed class ClassPage(Class all)
{
    private const int MostPairs = 12, LongestText = 300, LongestLine = 160, MostNames = 12, MostOpen = 5, MostMistakes = 8;

    private static readonly PageTemplate Template = new("class.liquid", GradeWords.All);

    /// <summary>The page as HTML.</summary>
    public static string Html(Class all) => Template.Render(
        ("page", new ClassPage(all)),
        ("style", PageTemplate.Resource("report.css") + PageTemplate.Resource("grade.css")),
        ("scripts", new[] { PageTemplate.Resource("page.js"), PageTemplate.Resource("grade.js") }));

    public Word Title => GradeWords.All["class"].With(Visible.Line(all.Name, LongestText));

    public Word Lead => GradeWords.All["class.lead"].With(all.Submissions.Count, Count(Outcome.Right), Count(Outcome.Wrong), Count(Outcome.Doubtful), Count(Outcome.Refused));

    public string Version => Report.Page.Version;

    public IReadOnlyList<string> StepNames => [.. Verdict.FiveSteps.Select(MarksFile.NameOf)];

    public int QuestionCount => Question.Of(all).Count;

    /// <summary>The questions by kind; doubtful cases are shown open, long lists of the others folded.</summary>
    public IReadOnlyList<QuestionsPart> Questions =>
        [.. Question.Of(all).GroupBy(question => question.Kind).Select(group => new QuestionsPart(group.Key, [.. group.Select(question => new QuestionPart(question))]))];

    public string MarksHead => $"{{\"schema\": \"{MarksFile.Schema}\", \"decisions\": [\n]}}";

    public IReadOnlyList<RowPart> Rows => [.. all.Submissions.Select(one => new RowPart(one))];

    public bool HasRoster => all.Roster != null;

    public IReadOnlyList<string> Missing => [.. all.Missing.Select(student => Visible.Line($"{student.Id} {student.Name}".Trim(), LongestText))];

    public IReadOnlyList<Word> How
    {
        get
        {
            Scheme scheme = all.Scheme;
            object[] points = [.. Verdict.FiveSteps.Select(step => StudentPage.Number(scheme.Points[step]))];
            string each = points.Distinct().Count() == 1 ? (string)points[0] : string.Join(" / ", points);
            return
            [
                GradeWords.All["how.steps"].With(each),
                .. new (string Name, double Points)[] { ("comments", scheme.Comments), ("name", scheme.Name), ("given", scheme.Given) }
                    .Where(part => part.Points > 0).Select(part => GradeWords.All["how." + part.Name].With(StudentPage.Number(part.Points))),
                GradeWords.All["how.default"],
            ];
        }
    }

    /// <summary>The most frequent mistakes, and folded the rarer ones.</summary>
    public IReadOnlyList<MistakesPart> MistakeParts
    {
        get
        {
            IReadOnlyList<MistakePart> all = Mistakes;
            return [.. new MistakesPart[] { new(false, [.. all.Take(MostMistakes)]), new(true, [.. all.Skip(MostMistakes)]) }.Where(part => part.All.Count > 0)];
        }
    }

    public int Run => Fingerprint.RunLength;

    public IReadOnlyList<PairPart> Pairs => [.. LookAlikes.Joining(all.Pairs).Take(MostPairs).Select(pair => new PairPart(pair, all))];

    public int PairsLeft => Math.Max(0, all.Pairs.Count - MostPairs);

    public IReadOnlyList<(string Place, Word What)> Passed =>
        [.. all.Passed.Select(note => (Visible.Line(note.Place, LongestText), new Word(note.Finding.English, note.Finding.Chinese)))];

    public IReadOnlyList<string> Unused => [.. all.Unused.Select(file => Visible.Line(file, LongestText))];

    private IReadOnlyList<MistakePart> Mistakes
    {
        get
        {
            // once for each submission
            IGrouping<(Step Step, string Code), (Graded One, Finding Finding)>[] groups = [.. all.Submissions.Where(one => one.Counts)
                .SelectMany(one => one.Judgement.Verdict.Findings.Where(finding => !finding.IsDoubtful).DistinctBy(finding => (finding.Step, finding.Code)).Select(finding => (One: one, Finding: finding)))
                .GroupBy(pair => (pair.Finding.Step, pair.Finding.Code))
                .OrderByDescending(group => group.Count()).ThenBy(group => group.Key.Step).ThenBy(group => group.Key.Code, StringComparer.Ordinal)];
            int most = groups.Length == 0 ? 1 : groups[0].Count();
            return [.. groups.Select(group => new MistakePart(
                group.First().Finding, group.Count(), 100.0 * group.Count() / most, [.. group.Take(MostNames).Select(pair => new RowPart(pair.One))], Math.Max(0, group.Count() - MostNames)))];
        }
    }

    private int Count(Outcome outcome) => all.Submissions.Count(one => one.Judgement.Verdict.Outcome == outcome);

    /// <summary>A submission as a row or a link.</summary>
    internal sealed class RowPart(Graded one)
    {
        public string Title => StudentPage.Title(one);

        // names of pages consist of letters, digits and - _ . only
        public string Page => "students/" + Uri.EscapeDataString(one.Page);

        public string File => Visible.Line(one.File, LongestText);

        public IReadOnlyList<string> Marks => [.. Verdict.FiveSteps.Select(step => MarksFile.NameOf(one.Judgement.Verdict[step]))];

        public string Comments => one.Judgement.Statements == 0 ? "–" : $"{one.Judgement.Commented}/{one.Judgement.Statements}";

        public string Points => StudentPage.Number(one.Marked.Total);

        public string Outcome => MarksFile.NameOf(one.Judgement.Verdict.Outcome);

        public bool Counts => one.Counts;

        public bool IsSettled => one.Decision != null;
    }

    internal sealed record QuestionsPart(string Kind, IReadOnlyList<QuestionPart> All)
    {
        public bool IsOpen => Kind == "doubt" || All.Count <= MostOpen;
    }

    /// <summary>Something to decide.</summary>
    internal sealed class QuestionPart(Question question)
    {
        public RowPart About => new(question.About);

        public Word What => new(Visible.Line(question.What.En, LongestText), Visible.Line(question.What.Zh, LongestText));

        public string Expected => Visible.Line(question.Expected ?? string.Empty, LongestText);

        public string Found => Visible.Line(question.Found ?? string.Empty, LongestText);

        public IReadOnlyList<Answer> Answers => question.Answers;
    }

    /// <summary>Mistakes, the most frequent first.</summary>
    internal sealed record MistakesPart(bool IsRare, IReadOnlyList<MistakePart> All);

    /// <summary>A mistake, how often, and in whose.</summary>
    internal sealed record MistakePart(Finding Finding, int Count, double Width, IReadOnlyList<RowPart> Who, int More)
    {
        public string Step => MarksFile.NameOf(Finding.Step);

        public Word What => new(Visible.Line(Finding.English, LongestText), Visible.Line(Finding.Chinese, LongestText));

        public string Code => Finding.Code;

        public string Share => StudentPage.Number(Math.Round(Width, 1));
    }

    /// <summary>Two scripts side by side, line by line.</summary>
    internal sealed class PairPart(Pair pair, Class all)
    {
        public string Share => $"{Math.Round(100 * pair.Share)} %";

        public RowPart First => new(all.Submissions[pair.First]);

        public RowPart Second => new(all.Submissions[pair.Second]);

        public IReadOnlyList<LinePart> FirstLines => Lines(all.Submissions[pair.First], pair.FirstLines);

        public IReadOnlyList<LinePart> SecondLines => Lines(all.Submissions[pair.Second], pair.SecondLines);

        private static IReadOnlyList<LinePart> Lines(Graded one, IReadOnlySet<int> same) =>
            [.. one.Judgement.Text.ReplaceLineEndings("\n").Split('\n').Select((text, i) => new LinePart(i + 1, Visible.Line(text.Replace("\t", "    "), LongestLine), same.Contains(i + 1)))];
    }

    /// <summary>A line of a script.</summary>
    internal sealed record LinePart(int Number, string Text, bool IsSame);
}
