using System.IO.Compression;

namespace RigidBodyDynamics.Web.Building;

/// <summary>Puts the parts of the site together.</summary>
/// <param name="project">The parts.</param>
/// <param name="folder">The site.</param>
internal sealed class SiteFolder(Project project, string folder)
{
    /// <summary>Writes what has changed, and removes what no longer belongs to the site.</summary>
    public void Write()
    {
        try
        {
            Directory.CreateDirectory(folder);
            HashSet<string> belongs = [];
            foreach ((string name, string source) in Parts())
            {
                string target = Path.Combine(folder, name.Replace('/', Path.DirectorySeparatorChar));
                belongs.Add(Path.GetFullPath(target));
                FileInfo from = new(source), to = new(target);
                if (to.Exists && to.LastWriteTimeUtc == from.LastWriteTimeUtc)
                    continue;

                Directory.CreateDirectory(Path.GetDirectoryName(target)!);
                if (name.EndsWith(Packed, StringComparison.Ordinal))
                    Pack(source, target);
                else
                    File.Copy(source, target, overwrite: true);

                File.SetLastWriteTimeUtc(target, from.LastWriteTimeUtc);
            }

            foreach (string file in Directory.EnumerateFiles(folder, "*", SearchOption.AllDirectories).Where(file => !belongs.Contains(Path.GetFullPath(file))))
                File.Delete(file);
        }
        catch (Exception refused) when (refused is IOException or UnauthorizedAccessException)
        {
            throw new RefusedException($"{folder}: {refused.Message}");
        }
    }

    // assemblies and WebAssembly go over the wire packed by gzip whatever the server does, and the page unpacks them: no server
    // takes a .bin for something to refuse, to pack again or to unpack
    private const string Packed = ".bin";

    private IEnumerable<(string Name, string Source)> Parts()
    {
        yield return ("index.html", Path.Combine(project.Page, "index.html"));
        foreach (string file in Directory.EnumerateFiles(Path.Combine(project.Work, "bundle")))
            yield return (Path.GetFileName(file), file);

        foreach (string file in Directory.EnumerateFiles(Path.Combine(project.Root, "scenes")))
            yield return ("scenes/" + Path.GetFileName(file), file);

        foreach (string program in new[] { "Play", "Write" })
        {
            foreach (string file in Directory.EnumerateFiles(project.Published(program)))
            {
                bool isScript = Path.GetExtension(file) == ".js";
                yield return ($"{program.ToLowerInvariant()}/_framework/{Path.GetFileName(file)}{(isScript ? string.Empty : Packed)}", file);
            }
        }
    }

    private static void Pack(string source, string target)
    {
        using FileStream from = File.OpenRead(source), to = File.Create(target);
        using GZipStream gzip = new(to, CompressionLevel.SmallestSize);
        from.CopyTo(gzip);
    }
}
