using System.Security.Cryptography;
using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;

namespace RigidBodyDynamics.Web.Building;

/// <summary>Assembles the parts of the site.</summary>
/// <param name="project">The parts.</param>
/// <param name="folder">The site.</param>
internal sealed class SiteFolder(Project project, string folder)
{
    private const string ServiceWorker = "service-worker.js";

    // writes the plus of base64 unescaped
    private static readonly JsonSerializerOptions Readable = new() { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    private readonly HashSet<string> _belongs = [];

    /// <summary>Creates the folder, so that one that cannot be written is refused before the build.</summary>
    public void Create() => Do(() =>
    {
        Directory.CreateDirectory(folder);
        string probe = Target(".writable");
        File.WriteAllText(probe, string.Empty);
        File.Delete(probe);
    });

    /// <summary>Writes what has changed, and deletes what no longer belongs to the site.</summary>
    public void Write() => Do(() =>
    {
        string[] before = [.. FilesOfTheVersionBefore()];
        string[] names = [.. Parts().Select(part => Copy(part.Name, part.Source))];
        WriteText("licences.txt", new Licences(project).Text());
        WriteServiceWorker([.. names, "licences.txt"]);
        foreach (string file in before.Where(file => !_belongs.Contains(file)))
            File.Delete(file);
    });

    private void Do(Action write)
    {
        try
        {
            write();
        }
        catch (Exception refused) when (refused is IOException or UnauthorizedAccessException)
        {
            throw new RefusedException($"{folder}: cannot be written: {refused.Message}");
        }
    }

    private IEnumerable<(string Name, string Source)> Parts()
    {
        yield return ("index.html", Path.Combine(project.Page, "index.html"));
        yield return (Plotting.Script, Plotting.Extract(project));
        foreach (string file in Directory.EnumerateFiles(project.Bundle).Where(file => Path.GetFileName(file) != ServiceWorker))
            yield return (Path.GetFileName(file), file);

        foreach (string file in Directory.EnumerateFiles(Path.Combine(project.Root, "scenes")))
            yield return ("scenes/" + Path.GetFileName(file), file);

        foreach (string program in Project.Programs)
        {
            foreach (string file in Directory.EnumerateFiles(project.Published(program)))
            {
                string packed = Path.GetExtension(file) == ".js" ? string.Empty : Packing.Always;
                yield return ($"{program.ToLowerInvariant()}/_framework/{Path.GetFileName(file)}{packed}", file);
            }
        }
    }

    private string Copy(string name, string source)
    {
        string target = Target(name);
        DateTime time = File.GetLastWriteTimeUtc(source);
        if (!File.Exists(target) || File.GetLastWriteTimeUtc(target) != time)
        {
            Directory.CreateDirectory(Path.GetDirectoryName(target)!);
            if (name.EndsWith(Packing.Always, StringComparison.Ordinal))
                Packing.Pack(source, target);
            else
                File.Copy(source, target, overwrite: true);

            File.SetLastWriteTimeUtc(target, time);
        }

        Keep(name, target);
        return name;
    }

    private void WriteText(string name, string text)
    {
        string target = Target(name);
        if (!File.Exists(target) || File.ReadAllText(target) != text)
            File.WriteAllText(target, text);

        Keep(name, target);
    }

    // the version of the site is a hash of its files, and the worker lists them
    private void WriteServiceWorker(IEnumerable<string> names)
    {
        Dictionary<string, string> files = names.Order(StringComparer.Ordinal).ToDictionary(
            name => name == "index.html" ? "./" : name, name => "sha256-" + Convert.ToBase64String(SHA256.HashData(File.ReadAllBytes(Target(name)))));
        string list = JsonSerializer.Serialize(files, Readable), script = File.ReadAllText(Path.Combine(project.Bundle, ServiceWorker));
        string version = Convert.ToHexString(SHA256.HashData(Encoding.UTF8.GetBytes(list + script)))[..16];
        WriteText(ServiceWorker, $"self.site={{version:\"{version}\",files:{list}}};\n{script}");
    }

    // only files of an earlier version are deleted
    private IEnumerable<string> FilesOfTheVersionBefore()
    {
        string worker = Target(ServiceWorker);
        if (!File.Exists(worker) || File.ReadLines(worker).FirstOrDefault() is not string first || first.IndexOf("files:", StringComparison.Ordinal) is not (> 0 and int at))
            return [];

        return Names(first[(at + "files:".Length)..]).Select(Target).SelectMany(file => Packing.Encodings.Select(encoding => file + encoding.Ending).Prepend(file)).Where(File.Exists);
    }

    // a damaged list is ignored, and nothing is deleted
    private static IEnumerable<string> Names(string list)
    {
        try
        {
            if (list.EndsWith("};", StringComparison.Ordinal) && JsonSerializer.Deserialize<Dictionary<string, string>>(list[..^2]) is { } files)
                return files.Keys;

            return [];
        }
        catch (JsonException)
        {
            return [];
        }
    }

    private string Target(string name) => Path.Combine(folder, name.Replace('/', Path.DirectorySeparatorChar));

    private void Keep(string name, string target)
    {
        _belongs.Add(target);
        if (!name.EndsWith(Packing.Always, StringComparison.Ordinal))
            _belongs.UnionWith(Packing.PackBeside(target));
    }
}
