using System.CommandLine;
using System.Text;
using RigidBodyDynamics.Lab.Inertia;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Commands;

/// <summary>Mass, centre, moments and frame of the bodies of a file, and the errors in them.</summary>
internal static class InertiaCommand
{
    public static Command Create()
    {
        Argument<string> file = new("FILE") { Description = "a scene, a mesh (STL, OBJ) or a robot description (URDF, MJCF)" };
        Option<double?> mass = Number("--mass", "of a mesh, kg", "M");
        Option<double?> density = Number("--density", "of a mesh, kg/m³; 1000 if neither is given", "D");
        Option<double?> scale = Number("--scale", "of a mesh: times every length; 0.001 for one in millimetres", "F");
        Option<string?> scene = new("--scene") { Description = "also a scene of the bodies", HelpName = "OUT.json" };
        Option<bool> json = new("--json") { Description = "as JSON" };
        Command command = new("inertia", "Mass, centre, principal moments and frame of each body of a file, and common mistakes in them; exit code 1 if there is one")
        {
            file, mass, density, scale, scene, json,
        };
        command.SetAction(parsed => Execute(
            parsed.GetRequiredValue(file), Filling(parsed.GetValue(mass), parsed.GetValue(density), parsed.GetValue(scale)), parsed.GetValue(scene), parsed.GetValue(json)));
        return command;
    }

    private static int Execute(string path, Filling? filling, string? scene, bool json)
    {
        InertiaFile file = InertiaFile.Read(path, filling);
        InertiaReport report = new(file);
        if (scene != null)
            Write(file, scene);

        if (json)
            Terminal.WriteJson(report.ToJson());
        else
            report.Print();

        return report.Faulty > 0 ? 1 : 0;
    }

    private static void Write(InertiaFile file, string output)
    {
        (string text, IReadOnlyList<string> leftOut) = InertiaScene.Of(file);
        string folder = Path.GetDirectoryName(Path.GetFullPath(output.Length > 0 ? output : throw new InputException("--scene: must not be empty"))) ?? throw new InputException($"{output}: is a folder");
        using Files files = new(folder, output, [file.Path]);
        files.Write(Path.GetFileName(output), temporary => File.WriteAllText(temporary, text, new UTF8Encoding(false)));
        files.Keep();
        if (leftOut.Count > 0)
            Terminal.Note($"{output}: left out, for no body is like that: {string.Join(", ", leftOut)}");
    }

    private static Option<double?> Number(string name, string about, string unit) =>
        new(name) { Description = about, HelpName = unit, CustomParser = result => Numbers.Parse(result) };

    private static Filling? Filling(double? mass, double? density, double? scale)
    {
        if (mass == null && density == null && scale == null)
            return null;

        if (mass != null && density != null)
            throw new InputException("--mass and --density exclude each other");

        foreach ((string name, double? value) in new[] { ("--mass", mass), ("--density", density), ("--scale", scale) })
        {
            if (value is double number && !(number > 0 && double.IsFinite(number)))
                throw new InputException(FormattableString.Invariant($"{name}: must be finite and above zero, found {number:R}"));
        }

        return new Filling(mass, density ?? Inertia.Filling.Water, scale ?? 1);
    }
}
