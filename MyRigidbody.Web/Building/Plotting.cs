using System.Reflection;

namespace RigidBodyDynamics.Web.Building;

/// <summary>The plotting library from the report's package: the page and the reports that it saves use the same one.</summary>
internal static class Plotting
{
    /// <summary>The package that contains it.</summary>
    public const string Package = "Plotly.NET";

    /// <summary>Its name in the site.</summary>
    public const string Script = "plotly.min.js";

    /// <summary>Extracts it from the package.</summary>
    /// <returns>The file.</returns>
    public static string Extract(Project project)
    {
        string file = Path.Combine(project.Work, Script);
        string package = Path.Combine(project.Root, "artifacts", "bin", "MyRigidbody.Lab", "release", Package + ".dll");
        new Stamp(project, "plotting").Do([package], file, () =>
        {
            Assembly assembly = Assembly.LoadFrom(package);
            string name = assembly.GetManifestResourceNames().Single(resource => resource.EndsWith(".min.js", StringComparison.Ordinal));
            using Stream from = assembly.GetManifestResourceStream(name)!, to = File.Create(file);
            from.CopyTo(to);
        });
        return file;
    }
}
