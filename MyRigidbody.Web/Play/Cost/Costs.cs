using System.Diagnostics;
using System.Runtime.InteropServices.JavaScript;
using System.Text.Json.Nodes;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Languages;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Lab.Report;

namespace RigidBodyDynamics.Web.Play;

/// <summary>Accuracy against time for a scene, measured in the page: in a worker, which may be ended at any time.</summary>
internal static partial class Costs
{
    // parts of the time allowed; a truth that is not found by then is given up after its last refinement
    private const double ForTruth = 0.25, MostForTruth = 6;

    /// <summary>The page's data: the trials of the diagram, the rows of the table, the source of the truth and the clock's resolution; or an error in one line.</summary>
    /// <param name="file">Name of the scene's file.</param>
    /// <param name="text">The text of the file.</param>
    /// <param name="seconds">The time allowed, s.</param>
    [JSExport]
    internal static string Of(string file, string text, double seconds)
    {
        try
        {
            File.WriteAllText(file, text);
            return Measure(file, seconds).ToJsonString();
        }
        catch (Exception refused) when (refused is InputException or BrokenEffectException)
        {
            return new JsonObject { ["refused"] = Refused.InBoth(refused.Message) }.ToJsonString();
        }
    }

    /// <summary>Stores a file that the scene names.</summary>
    [JSExport]
    internal static void Keep(string file, string text) => File.WriteAllText(file, text);

    private static JsonObject Measure(string file, double seconds)
    {
        Stopwatch clock = Stopwatch.StartNew();
        CostMotion motion = CostMotion.Of(file, done =>
        {
            if (clock.Elapsed.TotalSeconds > MostForTruth * seconds)
                throw new InputException(FormattableString.Invariant($"{file}: its true motion does not stand still after {clock.Elapsed.TotalSeconds:0} s of ever shorter steps"));

            Tell(ForTruth * Math.Min(1, clock.Elapsed.TotalSeconds / (ForTruth * seconds)));
        });
        double left = Math.Max((1 - ForTruth) * seconds, seconds - clock.Elapsed.TotalSeconds);
        CostFindings found = CostInTime.Of(motion, left, done => Tell(ForTruth + ((1 - ForTruth) * done)));
        CostDiagrams.Of shown = new(found);
        double tick = StepClock.Tick();
        return new JsonObject
        {
            ["sameCost"] = Advisor.SameCost,
            ["words"] = CostJson.OfWords(Words.OfScripts.Concat(Words.All)),
            ["rules"] = Texts(Rules.All.Select(rule => rule.Name)),
            ["motions"] = new JsonArray(CostJson.Of(found)),
            ["origin"] = CostJson.Both(shown.Origin),
            ["bounds"] = Texts(shown.Bounds),
            ["rows"] = new JsonArray([.. shown.Rows.Select(row => (JsonNode)Texts(row))]),
            ["tick"] = tick,
            ["each"] = StepClock.SecondsAtOnce(tick),
        };
    }

    private static JsonArray Texts(IEnumerable<string> texts) => new([.. texts.Select(text => (JsonNode)text)]);

    /// <summary>Tells the page the finished fraction.</summary>
    [JSImport("globalThis.postMessage")]
    private static partial void Tell(double done);
}
