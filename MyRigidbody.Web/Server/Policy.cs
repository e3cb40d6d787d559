using System.Text.RegularExpressions;

namespace RigidBodyDynamics.Web.Server;

/// <summary>What the browser may do for the page: the page states it, and the server repeats it for every file.</summary>
internal static partial class Policy
{
    /// <summary>The Content-Security-Policy of the site's page.</summary>
    public static string Of(string folder) => Meta().Match(File.ReadAllText(Path.Combine(folder, "index.html"))).Groups[1].Value;

    [GeneratedRegex("http-equiv=\"Content-Security-Policy\" content=\"([^\"]+)\"")]
    private static partial Regex Meta();
}
