using System.Reflection;

namespace RigidBodyDynamics.Web.Building;

/// <summary>The folders of the site's sources and of its build.</summary>
/// <param name="Web">The folder of this project.</param>
internal sealed record Project(string Web)
{
    /// <summary>The page's two programs, each in a folder of its own.</summary>
    public static IReadOnlyList<string> Programs { get; } = ["Play", "Write"];

    /// <summary>The root of the repository.</summary>
    public string Root => Path.GetDirectoryName(Web)!;

    /// <summary>The page: HTML, style and scripts.</summary>
    public string Page => Path.Combine(Web, "Page");

    /// <summary>The folder of the site unless another one is named.</summary>
    public string Site => Path.Combine(Root, "artifacts", "site");

    /// <summary>Files kept between two builds.</summary>
    public string Work => Path.Combine(Root, "artifacts", "site-work");

    /// <summary>The page's scripts and style, bundled.</summary>
    public string Bundle => Path.Combine(Work, "bundle");

    /// <summary>The list of bundled files.</summary>
    public string BundleList => Path.Combine(Work, "bundle.json");

    /// <summary>The project from which this program was built.</summary>
    public static Project OfThisProgram()
    {
        string folder = typeof(Project).Assembly.GetCustomAttributes<AssemblyMetadataAttribute>().Single(one => one.Key == "Folder").Value!;
        return Directory.Exists(folder)
            ? new Project(folder)
            : throw new RefusedException($"{folder}: the sources of the site are no longer there");
    }

    /// <summary>The published output of one of the page's two programs.</summary>
    public string Published(string program) => Path.Combine(Root, "artifacts", "publish", program, "release", "wwwroot", "_framework");
}
