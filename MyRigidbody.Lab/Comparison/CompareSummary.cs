using System.Globalization;
using System.Text.Encodings.Web;
using System.Text.Json;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Comparison;

/// <summary>A comparison for programs: all numbers in SI units and radians, unrounded.</summary>
internal static class CompareSummary
{
    /// <summary>Indented, and letters not escaped.</summary>
    internal static readonly JsonSerializerOptions Options = new()
    {
        WriteIndented = true,
        Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping,
    };

    /// <summary>The comparisons of a scene as JSON.</summary>
    public static string Json(SceneDescription scene, IEnumerable<Findings> found) => Text(
        new
        {
            scene = scene.Name,
            scene.About,
            steps = scene.Steps.Count,
            duration = scene.Steps.StartOf(scene.Steps.Count),
            pairs = found.Select(Pair),
        }) + "\n";

    /// <summary>A value as JSON without invisible characters.</summary>
    public static string Text(object value) => Visible.Json(JsonSerializer.Serialize(value, Options));

    /// <summary>The differences of each pair over time, as CSV.</summary>
    public static string Csv(IEnumerable<Findings> found)
    {
        List<string> lines = ["body,step,t,distance,angle,turn"];
        foreach (Findings pair in found)
        {
            string name = Output.Csv.Cell(pair.Pair.Mine.Name);
            lines.AddRange(pair.Course.Select(row => string.Create(
                CultureInfo.InvariantCulture,
                $"{name},{row.Step},{row.Apart.Time:R},{row.Apart.Distance:R},{row.Apart.Angle:R},{row.Apart.Turn:R}")));
        }

        return string.Join('\n', lines) + "\n";
    }

    private static object Pair(Findings found) => new
    {
        mine = found.Pair.Mine.Name,
        integrator = found.Pair.Mine.Rule.Name,
        unitys = found.Pair.Default.Name,
        inWords = CompareTables.InWords(found),
        whole = Apart(found.Shares.Whole),
        rules = found.Shares.Shares.Select(share => new
        {
            rule = share.Difference.Name,
            mine = share.Difference.Mine,
            unitys = share.Difference.Unitys,
            distanceShare = share.Distance,
            turnShare = share.Turn,
            alone = Apart(share.Alone),
        }),
        pushedInUpdate = found.FrameRates.Select(rate => new
        {
            framesPerSecond = rate.FramesPerSecond,
            impulse = OrNull(rate.Impulse),
            angularImpulse = OrNull(rate.AngularImpulse),
            apart = Apart(rate.Apart),
        }),
    };

    private static object Apart(Apart apart) => new
    {
        meanDistance = apart.MeanDistance,
        meanTurn = apart.MeanTurn,
        farthestDistance = apart.Farthest.Distance,
        widestAngle = apart.Farthest.Angle,
        lastDistance = apart.Last.Distance,
        lastAngle = apart.Last.Angle,
        lastTurn = apart.Last.Turn,
    };

    private static double? OrNull(double value) => Guard.IsFinite(value) ? value : null;
}
