using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Grading.Students;

namespace RigidBodyDynamics.Lab.Grading.Marks;

/// <summary>The instructor's file: points, deductions, and decisions about doubtful cases.</summary>
/// <param name="Scheme">The points.</param>
/// <param name="Decisions">The decisions.</param>
internal sealed record MarksFile(Scheme Scheme, IReadOnlyList<Decision> Decisions)
{
    /// <summary>The name of the format.</summary>
    public const string Schema = "rigid-body-marks/1";

    /// <summary>The values without a file.</summary>
    public static MarksFile Default { get; } = new(Scheme.Default, []);

    private static readonly Step[] Settled = [.. Verdict.FiveSteps, Step.Given, Step.Code, Step.Package, Step.Name];

    /// <summary>Reads it; an error is one line with file and place.</summary>
    public static MarksFile Read(string path) => JsonFile.Read(path, root =>
    {
        Fields fields = root.Fields();
        if (fields.Required("schema") is var schema && schema.Text() != Schema)
            throw schema.Not($"\"{Schema}\"");

        Scheme usual = Scheme.Default;
        Dictionary<Step, double> points = fields.Optional("points") is Place given ? Points(given.Fields()) : new(usual.Points);
        Scheme scheme = fields.Optional("deductions") is Place taken ? Deductions(taken.Fields(), points) : usual with { Points = points };
        Decision[] decisions = fields.Or("decisions", [], list => list.Items("a list of decisions", Decision));
        fields.End();
        return new MarksFile(scheme, decisions);
    });

    /// <summary>The name of a part of a verdict in JSON.</summary>
    public static string NameOf<T>(T part)
        where T : struct, Enum => char.ToLowerInvariant($"{part}"[0]) + $"{part}"[1..];

    private static Dictionary<Step, double> Points(Fields fields)
    {
        Dictionary<Step, double> points = Verdict.FiveSteps.ToDictionary(step => step, step => fields.Or(NameOf(step), Scheme.Default.Points[step], NotNegative));
        fields.End();
        return points;
    }

    private static Scheme Deductions(Fields fields, Dictionary<Step, double> points)
    {
        Scheme usual = Scheme.Default;
        Scheme scheme = new(
            points, fields.Or("comments", usual.Comments, NotNegative), fields.Or("name", usual.Name, NotNegative), fields.Or("given", usual.Given, NotNegative));
        fields.End();
        return scheme;
    }

    private static Decision Decision(Place place)
    {
        Fields fields = place.Fields();
        string file = fields.Required("file").Text();
        Dictionary<Step, bool> steps = [];
        foreach (Step step in Settled)
        {
            if (fields.Optional(NameOf(step)) is Place settled)
                steps[step] = settled.OneOf("right", "wrong") == 0;
        }

        Decision decision = new(
            file,
            fields.Optional("content")?.Text(),
            steps,
            fields.Optional("use")?.Text(),
            fields.Optional("student")?.Fields() is Fields student ? new Student(student.Required("id").Text().ToUpperInvariant(), student.Or("name", string.Empty, name => name.Text())) : null,
            fields.Optional("counts")?.Flag(),
            fields.Optional("points") is Place points ? NotNegative(points) : null,
            fields.Or("note", string.Empty, note => note.Text()));
        fields.End();
        return decision;
    }

    private static double NotNegative(Place place) => place.Number() is >= 0 and <= 1e6 and double number ? number : throw place.Not("a number from 0");
}
