using System.Text;
using System.Text.Json;
using System.Xml.Linq;

namespace RigidBodyDynamics.Web.Building;

/// <summary>The licences of all that the site contains, from the packages' own metadata.</summary>
/// <param name="project">The sources of the site.</param>
internal sealed class Licences(Project project)
{
    private readonly SortedSet<string> _known = new(StringComparer.Ordinal);
    private readonly StringBuilder _text = new();

    /// <summary>The text of the file.</summary>
    public string Text()
    {
        Add("MyRigidbody", "MIT", string.Empty, File.ReadAllText(Path.Combine(project.Root, "LICENSE")));
        foreach (string folder in Bundled())
            AddFromNpm(folder);

        // the plotting library states its licence in its first lines
        string plotting = File.ReadAllText(Plotting.Extract(project));
        Add(Plotting.Script, "MIT", string.Join('\n', plotting.Split("*/")[0].Split('\n').Select(line => line.Trim('/', '*', ' '))).Trim(), string.Empty);

        // both programs contain the runtime and many common packages
        HashSet<string> seen = [];
        foreach (string program in Project.Programs)
            AddFromNuGet(program, seen);

        foreach (string licence in _known)
            Heading("The text of " + licence).AppendLine(FullText(licence));

        return _text.ToString().ReplaceLineEndings("\n");
    }

    // the packages whose files are in the bundle
    private IEnumerable<string> Bundled()
    {
        using JsonDocument bundle = JsonDocument.Parse(File.ReadAllBytes(project.BundleList));
        return [.. bundle.RootElement.GetProperty("inputs").EnumerateObject().Select(input => input.Name.Split('/'))
            .Where(path => path[0] == "node_modules").Select(path => path[1].StartsWith('@') ? $"{path[1]}/{path[2]}" : path[1]).Distinct()];
    }

    private void AddFromNpm(string name)
    {
        string folder = Path.Combine(project.Page, "node_modules", name);
        using JsonDocument package = JsonDocument.Parse(File.ReadAllBytes(Path.Combine(folder, "package.json")));
        string licence = package.RootElement.GetProperty("license").GetString()!;
        Add($"{name} {package.RootElement.GetProperty("version").GetString()}", licence, string.Empty, Own(folder));
    }

    private void AddFromNuGet(string program, HashSet<string> seen)
    {
        using JsonDocument assets = JsonDocument.Parse(File.ReadAllBytes(Path.Combine(project.Root, "artifacts", "obj", program, "project.assets.json")));
        JsonElement root = assets.RootElement;
        string[] caches = [.. root.GetProperty("packageFolders").EnumerateObject().Select(folder => folder.Name)];
        HashSet<string> shipped = [.. Directory.EnumerateFiles(project.Published(program)).Select(file => Path.GetFileNameWithoutExtension(file)), Plotting.Package];
        foreach (JsonElement framework in root.GetProperty("project").GetProperty("frameworks").EnumerateObject().Select(framework => framework.Value))
        {
            foreach (JsonElement pack in framework.GetProperty("downloadDependencies").EnumerateArray())
                AddPackage(caches, $"{pack.GetProperty("name").GetString()}/{pack.GetProperty("version").GetString()!.Split('[', ',')[1]}", seen);
        }

        foreach (JsonProperty package in root.GetProperty("targets").GetProperty("net10.0/browser-wasm").EnumerateObject())
        {
            if (package.Value.GetProperty("type").GetString() == "package" && package.Value.TryGetProperty("runtime", out JsonElement files)
                && files.EnumerateObject().Any(file => shipped.Contains(Path.GetFileNameWithoutExtension(file.Name))))
            {
                AddPackage(caches, package.Name, seen);
            }
        }
    }

    private void AddPackage(string[] caches, string nameAndVersion, HashSet<string> seen)
    {
        if (!seen.Add(nameAndVersion))
            return;

        string folder = caches.Select(cache => Path.Combine(cache, nameAndVersion.ToLowerInvariant())).First(Directory.Exists);
        XElement metadata = XDocument.Load(Directory.EnumerateFiles(folder, "*.nuspec").Single()).Root!.Elements().First();
        string Value(string name) => metadata.Elements().FirstOrDefault(element => element.Name.LocalName == name)?.Value ?? string.Empty;
        string whose = Value("copyright") is { Length: > 0 } copyright ? copyright : Value("authors");
        Add(nameAndVersion.Replace('/', ' '), Value("license"), whose, Own(folder));
    }

    private void Add(string name, string licence, string whose, string own)
    {
        Heading($"{name} ({licence})");
        if (whose.Length > 0)
            _text.AppendLine(whose).AppendLine();

        if (own.Length > 0)
            _text.AppendLine(own);
        else
            _known.UnionWith(licence.Split([" OR ", " AND ", "(", ")"], StringSplitOptions.RemoveEmptyEntries));
    }

    private StringBuilder Heading(string title) => _text.AppendLine(new string('=', 100)).AppendLine(title).AppendLine();

    // licence files inside a package
    private static string Own(string folder) => string.Join('\n', Directory.EnumerateFiles(folder)
        .Where(file => Path.GetFileName(file).ToUpperInvariant() is "LICENSE" or "LICENSE.TXT" or "LICENSE.MD" or "LICENCE" or "THIRD-PARTY-NOTICES.TXT")
        .Order(StringComparer.Ordinal).Select(File.ReadAllText));

    private string FullText(string licence)
    {
        string file = Path.Combine(project.Page, "node_modules", "spdx-license-list", "licenses", licence + ".json");
        if (!File.Exists(file))
            throw new RefusedException($"a package of the site has a licence without a text: {licence}");

        using JsonDocument text = JsonDocument.Parse(File.ReadAllBytes(file));
        return text.RootElement.GetProperty("licenseText").GetString()!;
    }
}
