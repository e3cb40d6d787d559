using System.Text.Json;
using NUnit.Framework;
using RigidBodyDynamics.Tests.Repository;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>The files of the last build of the lab in a browser.</summary>
internal static class SiteFiles
{
    /// <summary>Their folder; the test is skipped where the site was not built.</summary>
    public static string Folder => Path.GetDirectoryName(Built("artifacts/site/index.html"))!;

    /// <summary>All of them by their names in the site, without those that lie packed beside a plain one.</summary>
    public static string[] Names =>
        [.. Directory.GetFiles(Folder, "*", SearchOption.AllDirectories).Select(file => Path.GetRelativePath(Folder, file).Replace('\\', '/')).Where(name => !IsPackedBeside(name)).Order()];

    /// <summary>The service worker's list: hashes by name.</summary>
    public static Dictionary<string, string> OfTheWorker()
    {
        string first = File.ReadLines(InFolder("service-worker.js")).First();
        return JsonSerializer.Deserialize<Dictionary<string, string>>(first[(first.IndexOf("files:", StringComparison.Ordinal) + 6)..^2])!;
    }

    /// <summary>One of them.</summary>
    public static string InFolder(string name) => Path.Combine(Folder, name);

    /// <summary>A file that the build of the site writes; the test is skipped where it did not.</summary>
    public static string Built(string path)
    {
        if (!File.Exists(Root.File(path)))
            Assert.Ignore($"no {path} here (dotnet run -c Release --project MyRigidbody.Web -- --out artifacts/site)");

        return Root.File(path);
    }

    private static bool IsPackedBeside(string name) => name.EndsWith(".br", StringComparison.Ordinal) || name.EndsWith(".gz", StringComparison.Ordinal);
}
