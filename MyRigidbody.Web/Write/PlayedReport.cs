using System.Runtime.InteropServices.JavaScript;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Comparison;
using RigidBodyDynamics.Lab.Languages;
using RigidBodyDynamics.Lab.Report;

namespace RigidBodyDynamics.Web.Write;

/// <summary>The report of a played motion: the page that compare writes for its scene, with the script's object in its replay.</summary>
internal static partial class PlayedReport
{
    private const int PerPose = 7;

    /// <summary>Stores a file that the scene names.</summary>
    [JSExport]
    internal static void Put(string file, byte[] bytes) => File.WriteAllBytes(file, bytes);

    /// <summary>The report as HTML.</summary>
    /// <param name="file">The name of the scene's file.</param>
    /// <param name="text">Its text.</param>
    /// <param name="names">The name of the script's object, in English and in Chinese.</param>
    /// <param name="poses">Seven numbers for its start and for every step; none without a script.</param>
    /// <param name="plotting">The plotting library.</param>
    [JSExport]
    internal static string Html(string file, string text, string[] names, double[] poses, string plotting)
    {
        File.WriteAllText(file, text);
        SceneFile scene = SceneReader.Read(file);
        Simulation simulation = new(scene.Scene);
        if (scene.Scene.Bodies.All(body => body.Rule == Rules.UnityRigidbody))
            return PageWriter.Html(Reports.Of(scene, scene.Scene, simulation, $"run {file}"), plotting);

        IReadOnlyList<Findings> found = [.. Pair.Of(scene).Select(pair => Findings.Of(pair, scene.Scene.Steps, _ => { }))];
        Motion motion = Motion.Of(scene, found);
        if (poses.Length >= PerPose)
            Add(motion, new Word(names[0], names[1]), poses);

        return PageWriter.Html(Reports.Of(scene, simulation, found, motion), plotting);
    }

    private static void Add(Motion motion, Word names, double[] poses)
    {
        Track first = motion.Tracks[0], track = new(names.En, first.Mass, first.Shape) { Names = names };
        ScriptBody script = new(first.Mass, new BodyState(Position(poses, 0), Orientation(poses, 0).Normalized, Vector3d.Zero, Vector3d.Zero));
        long step = 0;
        foreach (long at in motion.At)
        {
            for (; step < at && step < poses.Length / PerPose - 1; step++)
                script.Move(Position(poses, step + 1), Orientation(poses, step + 1), motion.Steps.Length(step));

            track.States.Add(script.State);
        }

        motion.Tracks.Add(track);
        motion.Pairs.Add(new Distances(
            0,
            motion.Tracks.Count - 1,
            [.. first.States.Zip(track.States, (a, b) => (a.Position - b.Position).Length)],
            [.. first.States.Zip(track.States, (a, b) => Conserved.AngleBetween(a.Orientation, b.Orientation))]));
    }

    private static Vector3d Position(double[] poses, long step) =>
        new(poses[PerPose * step], poses[PerPose * step + 1], poses[PerPose * step + 2]);

    private static Quaterniond Orientation(double[] poses, long step) =>
        new(poses[PerPose * step + 3], poses[PerPose * step + 4], poses[PerPose * step + 5], poses[PerPose * step + 6]);
}
