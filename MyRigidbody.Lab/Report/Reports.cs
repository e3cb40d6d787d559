using RigidBodyDynamics.Lab.Comparison;
using RigidBodyDynamics.Lab.Languages;

namespace RigidBodyDynamics.Lab.Report;

/// <summary>The page of each command, composed of common sections.</summary>
internal static class Reports
{
    /// <summary>The name of the page in a folder.</summary>
    public const string FileName = "report.html";

    /// <summary>The page of <c>compare</c> for a scene.</summary>
    /// <param name="file">The scene.</param>
    /// <param name="simulation">Its bodies, for their plans.</param>
    /// <param name="found">The results for each pair.</param>
    /// <param name="motion">Their motion.</param>
    public static Page Of(SceneFile file, Simulation simulation, IReadOnlyList<Findings> found, Motion motion) =>
        Page(file, file.Scene, Compare(file.Path), motion,
        [
            new Replay(motion),
            new TimePlots(Words.All["plots.label"].With("trajectory.csv, apart.csv")),
            RuleTable.From(found),
            Plan.From(Plans(simulation)),
        ]);

    /// <summary>The page of <c>compare</c> for a recording.</summary>
    public static Page Of(SceneFile file, Simulation simulation, RecordingTable table, Motion motion) =>
        Page(file, file.Scene, Compare(file.Path), motion,
        [
            new Replay(motion),
            new TimePlots(Words.All["plots.label"].With("trajectory.csv, " + Path.GetFileName(file.Recording!.Path))),
            table,
            Plan.From(Plans(simulation)),
        ]);

    /// <summary>The page of <c>run</c>.</summary>
    public static Page Of(SceneFile file, SceneDescription scene, Simulation simulation, string command)
    {
        Motion motion = Motion.Of(file, scene, simulation);
        return Page(file, scene, command, motion,
        [
            new Replay(motion),
            new TimePlots(Words.All["plots.run"]),
            Plan.From(Plans(new Simulation(ManyBodies.WithFirst(scene, file.Crowds)))),
        ]);
    }

    /// <summary>The page of <c>cost</c>.</summary>
    public static Page Of(IReadOnlyList<CostFindings> found, string command) => new(
        Words.All["cost.page"], string.Empty, string.Empty, command, [new CostDiagrams(found), Facts.OfMachine()]);

    private static Page Page(SceneFile file, SceneDescription scene, string command, Motion motion, List<Section> sections)
    {
        string shown = Report.Page.Shown(file.Path);
        return new Page(Word.Name(scene.Name), scene.About, shown, command, [.. sections, Facts.Of(scene, shown, motion.At.Count)]);
    }

    private static string Compare(string path) =>
        path == Gallery.Lab ? string.Empty : Shell.Line("compare", Report.Page.Shown(path));

    private static IEnumerable<(string Name, BodyPlan Plan)> Plans(Simulation simulation) =>
        simulation.Bodies.Select(body => (body.Name, body.Plan));
}
