using System.Globalization;
using System.Text.RegularExpressions;

namespace RigidBodyDynamics.UnityFiles.Checks;

/// <summary>Every file and folder that Unity imports has a meta as 2019.4 writes it, with a random GUID of its own.</summary>
internal static partial class Metas
{
    // C(16, 7) (7/16)^32: one random GUID in 27 million has fewer than 8 different digits; Unity's built-in ones have two
    private const int FewestDigits = 8;

    // one random GUID in 38 thousand counts upwards for seven digits, one in 80 thousand alternates letters and numbers for 20
    private const int LongestCount = 7;

    /// <summary>What is wrong with the metas below some folders.</summary>
    public static IEnumerable<string> Findings(ProjectFiles files, params string[] folders)
    {
        Dictionary<string, string> guids = [];
        foreach (string folder in folders)
        {
            IReadOnlySet<string> imported = files.ImportedFrom(folder);
            string[] metas = [.. files.Texts.Keys.Where(path => path.StartsWith(folder + "/", StringComparison.Ordinal) && ProjectFiles.IsMeta(path))];
            foreach (string asset in imported.Where(asset => !files.Texts.ContainsKey(asset + ".meta")))
                yield return $"{asset}: has no meta; bash .ci/metas {folder} writes one";

            foreach (string meta in metas)
            {
                string asset = meta[..^".meta".Length];
                if (!imported.Contains(asset))
                    yield return $"{meta}: nothing stands beside it";
                else if (Finding(files, asset, meta, guids) is string finding)
                    yield return $"{meta}: {finding}";
            }
        }
    }

    /// <summary>How Unity 2019.4 writes the meta of an asset; there is a space after an empty value.</summary>
    public static string AsUnityWritesIt(string asset, bool isFolder, string guid)
    {
        string importer = isFolder ? "DefaultImporter" : Importer(asset);
        string[] own = importer switch
        {
            "MonoImporter" => ["  serializedVersion: 2", "  defaultReferences: []", "  executionOrder: 0", "  icon: {instanceID: 0}"],
            "NativeFormatImporter" => ["  mainObjectFileID: 2100000"],
            "ShaderImporter" => ["  defaultTextures: []", "  nonModifiableTextures: []"],
            _ => [],
        };
        string[] lines =
        [
            "fileFormatVersion: 2", "guid: " + guid, .. isFolder ? ["folderAsset: yes"] : Array.Empty<string>(),
            importer + ":", "  externalObjects: {}", .. own, "  userData: ", "  assetBundleName: ", "  assetBundleVariant: ",
        ];
        return string.Concat(lines.Select(line => line + "\n"));
    }

    private static string Importer(string asset) => Path.GetExtension(asset) switch
    {
        ".cs" => "MonoImporter",
        ".asmdef" => "AssemblyDefinitionImporter",
        ".mat" => "NativeFormatImporter",
        ".shader" => "ShaderImporter",
        ".json" when Path.GetFileName(asset) == "package.json" => "PackageManifestImporter",
        ".json" or ".md" or ".txt" or ".csv" or ".xml" => "TextScriptImporter",
        _ => "DefaultImporter",
    };

    private static string? Finding(ProjectFiles files, string asset, string meta, Dictionary<string, string> guids)
    {
        string text = files.Texts[meta];
        if (Project.GuidIn(text) is not string guid)
            return "must begin with 'fileFormatVersion: 2' and a GUID of 32 lower-case hex digits";

        if (!guids.TryAdd(guid, meta))
            return $"has the GUID of {guids[guid]}";

        if (text != AsUnityWritesIt(asset, !files.Texts.ContainsKey(asset), guid))
            return "is not as Unity 2019.4 writes it";

        return IsMadeUp(guid) ? $"GUID {guid} is not random; others make up the same" : null;
    }

    private static bool IsMadeUp(string guid)
    {
        int[] digits = [.. guid.Select(digit => int.Parse(digit.ToString(), NumberStyles.HexNumber, CultureInfo.InvariantCulture))];
        int[] steps = [.. digits.Zip(digits.Skip(1), (a, b) => (b - a + 16) % 16)];
        return guid.Distinct().Count() < FewestDigits || LongestRun(steps) + 1 >= LongestCount || InTurns().IsMatch(guid);
    }

    private static int LongestRun(int[] numbers)
    {
        int longest = 1, run = 1;
        for (int i = 1; i < numbers.Length; i++)
        {
            run = numbers[i] == numbers[i - 1] ? run + 1 : 1;
            longest = Math.Max(longest, run);
        }

        return longest;
    }

    [GeneratedRegex("([0-9][a-f]){10}|([a-f][0-9]){10}")]
    private static partial Regex InTurns();
}
