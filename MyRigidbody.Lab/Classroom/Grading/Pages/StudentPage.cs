using System.Globalization;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Checking;
using RigidBodyDynamics.Lab.Grading.Marks;
using RigidBodyDynamics.Lab.Languages;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Lab.Report;

namespace RigidBodyDynamics.Lab.Grading.Pages;

/// <summary>The page of a student, on one sheet of A4.</summary>
internal sealed class StudentPage
{
    // what fits on the sheet beside the five steps
    private const int MostFindings = 7, MostLines = 24, LongestText = 110, LongestName = 60;

    private static readonly PageTemplate Template = new("student.liquid", GradeWords.All);

    private readonly Graded _graded;

    private StudentPage(Graded graded, Scheme scheme)
    {
        _graded = graded;
        string[] source = graded.Judgement.Text.ReplaceLineEndings("\n").Split('\n');
        Finding[] all = [.. graded.Judgement.Verdict.Findings.Concat(graded.Submission.Notes)], shown = [.. all.Take(MostFindings)];
        Left = all.Length - shown.Length;
        Parts =
        [
            .. Verdict.FiveSteps.Concat(shown.Select(finding => finding.Step).Where(step => !Verdict.FiveSteps.Contains(step)).Distinct())
                .Select(step => new Part(step, graded.Judgement.Verdict[step], [.. shown.Where(finding => finding.Step == step).Select(finding => new FindingPart(finding, source))])),
        ];
        Full = Number(scheme.Full);
    }

    /// <summary>The name on the page.</summary>
    public string Name => Title(_graded);

    /// <summary>The file that was judged.</summary>
    public string File => Visible.Line(_graded.File);

    /// <summary>The whole verdict, which also gives the colour.</summary>
    public string Outcome => MarksFile.NameOf(_graded.Judgement.Verdict.Outcome);

    /// <summary>The five steps, and other parts with findings.</summary>
    public IReadOnlyList<Part> Parts { get; }

    /// <summary>The number of findings that do not fit on the page.</summary>
    public int Left { get; }

    /// <summary>The points of a submission without errors.</summary>
    public string Full { get; }

    /// <summary>The points.</summary>
    public string Total => Number(_graded.Marked.Total);

    /// <summary>True where the instructor has given them.</summary>
    public bool IsSet => _graded.Marked.IsSet;

    /// <summary>True where the instructor has something to decide.</summary>
    public bool IsDoubtful => _graded.Judgement.Verdict.Findings.Any(finding => finding.IsDoubtful);

    /// <summary>The parts of the points.</summary>
    public IReadOnlyList<(string Name, string Points)> Sum =>
    [
        ("steps", Number(_graded.Marked.Steps)),
        .. new[] { ("comments", _graded.Marked.Comments), ("name", _graded.Marked.Name), ("given", _graded.Marked.Given) }
            .Where(part => part.Item2 > 0).Select(part => (part.Item1, "−" + Number(part.Item2))),
    ];

    /// <summary>The number of added statements that have a comment.</summary>
    public Word Comments => _graded.Judgement.Statements == 0
        ? GradeWords.All["student.comments.none"]
        : GradeWords.All["student.comments"].With(_graded.Judgement.Commented, _graded.Judgement.Statements);

    /// <summary>The lines without one.</summary>
    public string Uncommented => string.Join(", ", _graded.Judgement.Uncommented.Distinct().Take(MostLines)) + (_graded.Judgement.Uncommented.Distinct().Count() > MostLines ? ", …" : string.Empty);

    /// <summary>The instructor's note.</summary>
    public string Note => Visible.Line(_graded.Decision?.Note ?? string.Empty, 300);

    /// <summary>The page as HTML.</summary>
    public static string Html(Graded graded, Scheme scheme) => Template.Render(
        ("page", new StudentPage(graded, scheme)),
        ("style", PageTemplate.Resource("report.css") + PageTemplate.Resource("grade.css")),
        ("script", PageTemplate.Resource("page.js")));

    /// <summary>True for a page that <see cref="Html"/> has written.</summary>
    public static bool IsOne(string html) => html.Contains("<body class=\"student\">", StringComparison.Ordinal);

    /// <summary>The student, or else the name of the file.</summary>
    public static string Title(Graded graded) =>
        Visible.Line(graded.Student is { } student ? $"{student.Id} {student.Name}".Trim() : graded.Submission.Spot.Name, LongestName);

    /// <summary>A number without needless digits.</summary>
    public static string Number(double number) => number.ToString("0.##", CultureInfo.InvariantCulture);

    /// <summary>A part of the verdict.</summary>
    internal sealed record Part(Step Step, Mark Mark, IReadOnlyList<FindingPart> Findings)
    {
        public bool IsStep => Verdict.FiveSteps.Contains(Step);

        public string Name => MarksFile.NameOf(Step);

        public string MarkName => MarksFile.NameOf(Mark);
    }

    /// <summary>A finding on the page, with its line of the script.</summary>
    internal sealed record FindingPart(Finding Finding, string[] Source)
    {
        public Word What => new(Visible.Line(Finding.English, 2 * LongestText), Visible.Line(Finding.Chinese, 2 * LongestText));

        public string Expected => Measured(Finding.Expected);

        public string Found => Measured(Finding.Found);

        // beside a sentence about code stand words of a programmer, in English alone
        private string Measured(string? value) => CheckWords.IsMeasured(Finding) ? Visible.Line(value ?? string.Empty, LongestText) : string.Empty;

        public int? Line => Finding.Line;

        public string Code => Finding.Line is int line && line >= 1 && line <= Source.Length ? Visible.Line(Source[line - 1].Replace('\t', ' ').Trim(), LongestText) : string.Empty;

        public Word? Since => Finding.Since is not int frame ? null
            : string.IsNullOrEmpty(Finding.Experiment) ? GradeWords.All["student.since"].With(frame)
            : GradeWords.All["student.experiment"].With(frame, Word.Of(Terminology.OfExperiment(Finding.Experiment)));
    }
}
