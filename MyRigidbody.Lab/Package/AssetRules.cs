using System.Text;
using System.Text.RegularExpressions;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Package;

/// <summary>Requirements of a package that every editor can import; each is a mistake that has occurred.</summary>
internal static partial class AssetRules
{
    // longer paths fail on Windows inside the folder of a project
    private const int LongestPath = 120;

    // one random GUID in 27 million has fewer different digits; GUIDs typed by hand and Unity's own have
    private const int FewestDigits = 8;

    private static readonly string[] Texts = [".cs", ".asmdef", ".md", ".txt", ".unity", ".mat", ".shader", ".json"];

    /// <summary>The assets, if they meet the requirements.</summary>
    public static IReadOnlyList<Asset> Checked(IReadOnlyList<Asset> assets)
    {
        if (!assets.Any(asset => !asset.IsFolder))
            throw new InputException("pack: there is no file to pack");

        Dictionary<string, string> guids = [];
        HashSet<string> paths = new(StringComparer.OrdinalIgnoreCase);
        foreach (Asset asset in assets)
        {
            if (!guids.TryAdd(asset.Guid, asset.Path))
                throw new InputException($"{asset.Path}: has the GUID of {guids[asset.Guid]}");

            if (!paths.Add(asset.Path))
                throw new InputException($"{asset.Path}: is there twice, where capitals do not count");

            if (asset.Guid.Distinct().Count() < FewestDigits)
                throw new InputException($"{asset.Path}: its GUID {asset.Guid} is not random, and another package may have it too");

            Path(asset.Path);
            Content(asset);
        }

        foreach (Asset asset in assets)
        {
            string folder = asset.Path[..asset.Path.LastIndexOf('/')];
            if (folder != "Assets" && !paths.Contains(folder))
                throw new InputException($"{asset.Path}: its folder is not in the package");
        }

        return assets;
    }

    private static void Path(string path)
    {
        if (!path.StartsWith("Assets/MyRigidbody", StringComparison.Ordinal) || path.Length > LongestPath)
            throw new InputException($"{path}: must begin with Assets/MyRigidbody and have at most {LongestPath} characters");

        if (Reserved().IsMatch(path))
            throw new InputException($"{path}: has a name that Windows keeps for a device");

        if (path.Any(c => c is < ' ' or > '~' or '\\' or ':' or '*' or '?' or '"' or '<' or '>' or '|')
            || path.Split('/').Any(part => part.Length == 0 || part.EndsWith('.') || part.EndsWith(' ')))
        {
            throw new InputException($"{path}: has a character that not every file system takes");
        }
    }

    /// <summary>Why an asset at this path should not be imported; empty where it may be.</summary>
    public static string? Danger(string path) =>
        Visible.Line(path) != path ? "has invisible characters"
        : !path.StartsWith("Assets/", StringComparison.Ordinal) && !path.StartsWith("Packages/", StringComparison.Ordinal) && path is not ("Assets" or "Packages") ? "is outside of Assets and Packages"
        : path.Split('/', '\\').Any(part => part is ".." or ".") ? "leads out of its folder"
        : path.Contains(':') ? "names a drive or a stream"
        : Reserved().IsMatch(path) ? "has a name that Windows keeps for a device"
        : null;

    [GeneratedRegex(@"(^|[/\\])\s*(con|prn|aux|nul|conin\$|conout\$|(com|lpt)[0-9¹²³])\s*(\.[^/\\]*)?($|[/\\])", RegexOptions.IgnoreCase | RegexOptions.CultureInvariant)]
    private static partial Regex Reserved();

    private static void Content(Asset asset)
    {
        bool saysFolder = Encoding.UTF8.GetString(asset.Meta).Contains("\nfolderAsset: yes\n", StringComparison.Ordinal);
        if (saysFolder != asset.IsFolder)
            throw new InputException($"{asset.Path}.meta: must {(asset.IsFolder ? "have" : "not have")} the line 'folderAsset: yes'");

        if (asset.Meta.Contains((byte)'\r'))
            throw new InputException($"{asset.Path}.meta: must have LF at the end of its lines");

        if (asset.Content is not byte[] content || !Texts.Contains(System.IO.Path.GetExtension(asset.Path)))
            return;

        if (content.Contains((byte)'\r'))
            throw new InputException($"{asset.Path}: must have LF at the end of its lines");

        if (content.AsSpan().StartsWith(Encoding.UTF8.Preamble))
            throw new InputException($"{asset.Path}: must have no byte order mark");
    }
}
