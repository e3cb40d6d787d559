using System.Text.Json;
using System.Text.Json.Nodes;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Inertia;

/// <summary>The bodies of a file as a table with the errors below it, and as JSON.</summary>
internal sealed class InertiaReport
{
    private static readonly JsonSerializerOptions Indented = new() { WriteIndented = true, Encoder = System.Text.Encodings.Web.JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    // a longer table is not read, and laying out 50,000 rows takes half a minute; --json has all
    private const int MostShown = 500;

    private readonly InertiaFile _file;
    private readonly IReadOnlyList<(DescribedBody Body, IReadOnlyList<Finding> Findings)> _bodies;

    public InertiaReport(InertiaFile file)
    {
        _file = file;
        _bodies = [.. file.Bodies.Select(body => (body, Diagnosis.Of(body)))];
    }

    /// <summary>The number of bodies with a wrong or doubtful number.</summary>
    public int Faulty => _bodies.Count(body => body.Findings.Any(finding => finding.Severity > Severity.Note));

    /// <summary>For people.</summary>
    public void Print()
    {
        TextTable table = new TextTable("body", "mass, kg", "centre of mass, m", "principal moments, kg m²", "their frame, w x y z", "found").RightAligned(1);
        foreach ((DescribedBody body, IReadOnlyList<Finding> findings) in _bodies.Take(MostShown))
        {
            if (body.Mass is not double mass)
            {
                table.AddRow(body.Name, "–", "–", "–", "–", "no inertia");
                continue;
            }

            (Vector3d moments, Quaterniond frame) = Principal(body);
            string worst = findings.Count == 0 ? "ok" : string.Join(", ", findings.Select(finding => finding.Code).Distinct());
            table.AddRow(
                body.Name, Tensors.Short(mass), Words(body.Center.X, body.Center.Y, body.Center.Z), Words(moments.X, moments.Y, moments.Z), Words(frame.W, frame.X, frame.Y, frame.Z), worst);
        }

        Terminal.Write(table);
        if (_bodies.Count > MostShown)
            Terminal.WriteText($"and {_bodies.Count - MostShown} bodies more, which --json shows");

        foreach ((DescribedBody body, IReadOnlyList<Finding> findings) in _bodies.Where(body => body.Findings.Count + body.Body.Notes.Count > 0).Take(MostShown))
        {
            string name = body.Name + (body.Place.Length > 0 ? $" ({body.Place})" : string.Empty);
            foreach (Finding finding in findings)
                Terminal.WriteText($"{name}: {finding.Severity.ToString().ToLowerInvariant()}, {finding.Code}: {finding.Text}");

            foreach (string note in body.Notes)
                Terminal.WriteText($"{name}: note: {note}");
        }

        foreach (string note in _file.Notes)
            Terminal.WriteText("note: " + note);

        if (Faulty > 0)
            Terminal.WriteText($"{Faulty} of {_bodies.Count} bodies {(Faulty == 1 ? "is" : "are")} wrong or doubtful");
    }

    /// <summary>For programs.</summary>
    public string ToJson() => new JsonObject
    {
        ["file"] = _file.Path,
        ["kind"] = _file.Kind,
        ["bodies"] = new JsonArray([.. _bodies.Select(body => (JsonNode)Body(body.Body, body.Findings))]),
        ["notes"] = List(_file.Notes),
    }.ToJsonString(Indented);

    /// <summary>The principal moments and their frame, in body axes.</summary>
    public static (Vector3d Moments, Quaterniond Frame) Principal(DescribedBody body)
    {
        Vector3d moments = PrincipalAxes.Of(body.Tensor, out Quaterniond frame);
        return (moments, body.Axes == Quaterniond.Identity ? frame : body.Axes.Normalized * frame);
    }

    private static JsonObject Body(DescribedBody body, IReadOnlyList<Finding> findings)
    {
        JsonObject json = new() { ["name"] = body.Name, ["place"] = body.Place };
        if (body.Mass is double mass)
        {
            (Vector3d moments, Quaterniond frame) = Principal(body);
            SymmetricMatrix3 t = body.InBodyAxes;
            json["mass"] = Number(mass);
            json["centerOfMass"] = new JsonArray(Number(body.Center.X), Number(body.Center.Y), Number(body.Center.Z));
            json["tensor"] = new JsonObject { ["xx"] = Number(t.XX), ["yy"] = Number(t.YY), ["zz"] = Number(t.ZZ), ["xy"] = Number(t.XY), ["xz"] = Number(t.XZ), ["yz"] = Number(t.YZ) };
            json["principalMoments"] = new JsonArray(Number(moments.X), Number(moments.Y), Number(moments.Z));
            json["frame"] = new JsonArray(Number(frame.W), Number(frame.X), Number(frame.Y), Number(frame.Z));
            json["isPossible"] = mass > 0 && Tensors.IsPossible(body.Tensor);
            json["isComputedFromGeometry"] = body.IsComputed;
        }

        json["findings"] = new JsonArray([.. findings.Select(finding => (JsonNode)new JsonObject
        {
            ["code"] = finding.Code, ["severity"] = finding.Severity.ToString().ToLowerInvariant(), ["text"] = finding.Text,
        })]);
        json["notes"] = List(body.Notes);
        return json;
    }

    // JSON has no infinity and no NaN
    private static JsonNode? Number(double number) => double.IsFinite(number) ? number : null;

    private static JsonArray List(IReadOnlyList<string> texts) => new([.. texts.Select(text => (JsonNode)text)]);

    private static string Words(params double[] numbers) => string.Join("  ", numbers.Select(number => Tensors.Short(Math.Abs(number) < 1e-15 ? 0 : number)));
}
