using System.Text.Json;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests.Repository;

/// <summary>Pages and manifests agree with what they describe.</summary>
public sealed partial class DocumentTests
{
    private static readonly string[] Pages = Tree.Files(".", "*.md");

    private static string Version =>
        XDocument.Parse(Tree.Text("Directory.Build.props")).Descendants("Version").Single().Value;

    [Test]
    public void Unity_package_has_the_version_of_the_library()
    {
        using JsonDocument manifest = JsonDocument.Parse(Tree.Text("MyRigidbody.Core/package.json"));

        Assert.That(manifest.RootElement.GetProperty("version").GetString(), Is.EqualTo(Version));
    }

    [Test]
    public void Changelog_has_an_entry_for_the_version() =>
        Assert.That(Tree.Text("CHANGELOG.md"), Does.Contain($"\n## [{Version}]"));

    [TestCaseSource(nameof(Pages))]
    public void Links_to_files_lead_somewhere(string page)
    {
        string folder = Path.GetDirectoryName(Root.File(page))!;
        IEnumerable<string> broken = Link().Matches(CodeBlock().Replace(Tree.Text(page), string.Empty))
            .Select(match => match.Groups[1].Value)
            .Where(target => !target.Contains("://", StringComparison.Ordinal) && !target.StartsWith('#'))
            .Where(target => !Path.Exists(Path.Combine(folder, Uri.UnescapeDataString(target.Split('#')[0]))));

        Assert.That(broken, Is.Empty);
    }

    [TestCaseSource(nameof(Pages))]
    public void Links_to_headings_lead_to_headings(string page)
    {
        string folder = Path.GetDirectoryName(Root.File(page))!;
        IEnumerable<string> broken = Link().Matches(CodeBlock().Replace(Tree.Text(page), string.Empty))
            .Select(match => match.Groups[1].Value)
            .Where(target => target.Contains('#') && !target.Contains("://", StringComparison.Ordinal))
            .Where(target => target.Split('#') is [string file, string heading]
                && !Headings(file.Length > 0 ? Path.Combine(folder, Uri.UnescapeDataString(file)) : Root.File(page)).Contains(heading));

        Assert.That(broken, Is.Empty);
    }

    /// <summary>As GitHub makes them: small letters, no marks, hyphens for blanks.</summary>
    private static IEnumerable<string> Headings(string path) => CodeBlock().Replace(File.ReadAllText(path), string.Empty).Split('\n')
        .Where(line => line.StartsWith('#'))
        .Select(line => Mark().Replace(line.TrimStart('#').Trim().ToLowerInvariant(), string.Empty).Replace(' ', '-'));

    [GeneratedRegex(@"[^\w\- ]")]
    private static partial Regex Mark();

    [GeneratedRegex(@"\]\(([^)\s]+)")]
    private static partial Regex Link();

    [GeneratedRegex(@"^```.*?^```", RegexOptions.Multiline | RegexOptions.Singleline)]
    private static partial Regex CodeBlock();
}
