using System.CommandLine;
using RigidBodyDynamics.UnityFiles.Checks;
using RigidBodyDynamics.UnityFiles.Drawing;

namespace RigidBodyDynamics.UnityFiles;

/// <summary>Checks the files of the Unity project, and draws its scenes.</summary>
internal static class Program
{
    private static int Main(string[] args)
    {
        RootCommand root = new("What an editor would say of the Unity project, and what a student will see.") { Check(), Draw() };
        return root.Parse(args).Invoke();
    }

    private static Command Check()
    {
        Argument<string> root = new("root") { Description = "The folder of the repository.", DefaultValueFactory = _ => "." };
        Command check = new("check", "Lists what an editor would complain about; exit code 1 if there is anything.") { root };
        check.SetAction(parsed =>
        {
            IReadOnlyList<string> findings = ProjectChecker.Findings(ProjectFiles.Read(parsed.GetValue(root)!));
            foreach (string finding in findings)
                Console.WriteLine(finding);

            return findings.Count == 0 ? 0 : 1;
        });
        return check;
    }

    private static Command Draw()
    {
        Argument<string> scene = new("scene") { Description = "A .unity file below a folder Assets." };
        Argument<string> picture = new("png") { Description = "The picture to write." };
        Option<string?> poses = new("--poses") { Description = "A CSV file of the command line's run: bodies stand as it says." };
        Option<double> time = new("--at") { Description = "At which time of the CSV file, s." };
        Option<string?> panel = new("--panel") { Description = "The rows of the panel; without them its place is shown." };
        Command draw = new("draw", "Draws a scene as its camera sees it.") { scene, picture, poses, time, panel };
        draw.SetAction(parsed =>
        {
            string? file = parsed.GetValue(poses);
            DrawnScene drawn = DrawnScene.Read(parsed.GetValue(scene)!, file == null ? null : Pose.Read(file, parsed.GetValue(time)));
            using SkiaSharp.SKBitmap bitmap = Picture.Annotated(drawn, parsed.GetValue(panel) is string rows ? File.ReadAllLines(rows) : null);
            Picture.Save(bitmap, parsed.GetValue(picture)!);
        });
        return draw;
    }
}
