using System.Text.RegularExpressions;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests.Repository;

/// <summary>Unity knows the files of the package by the GUIDs in their metas.</summary>
public sealed partial class MetaFilesTests
{
    private const string Package = "MyRigidbody.Core";

    private static readonly string[] Metas = Tree.Files(Package, "*.meta");
    private static readonly string[] Assets =
        [.. Tree.Files(Package, "*").Where(path => !path.EndsWith(".meta", StringComparison.Ordinal)), .. Tree.Folders(Package)];

    [Test]
    public void Every_file_and_folder_of_the_package_has_a_meta_and_every_meta_has_its_file() =>
        Assert.That(Metas, Is.EquivalentTo(Assets.Select(path => path + ".meta")), "bash .ci/metas writes those that are missing");

    [TestCaseSource(nameof(Assets))]
    public void Meta_is_as_Unity_2019_writes_it(string asset)
    {
        string meta = Tree.Text(asset + ".meta");

        Assert.That(meta, Is.EqualTo(AsUnityWritesIt(asset, GuidOf(meta))));
    }

    [Test]
    public void No_GUID_is_used_twice() => Assert.That(Metas.Select(path => GuidOf(Tree.Text(path))), Is.Unique);

    [Test]
    public void No_GUID_is_made_by_hand()
    {
        // C(16, 7) (7/16)^32: one random GUID in 27 million has fewer than 8 different digits; Unity's built-in ones have two
        Assert.That(Metas.Select(path => GuidOf(Tree.Text(path)).Distinct().Count()), Has.All.AtLeast(8));
    }

    private static string GuidOf(string meta)
    {
        Match guid = GuidLine().Match(meta);
        Assert.That(guid.Success, Is.True, meta);
        return guid.Groups[1].Value;
    }

    private static string AsUnityWritesIt(string asset, string guid)
    {
        bool isFolder = Directory.Exists(Root.File(asset));
        string importer = Path.GetExtension(asset) switch
        {
            _ when isFolder => "DefaultImporter",
            ".cs" => "MonoImporter",
            ".asmdef" => "AssemblyDefinitionImporter",
            ".json" when Path.GetFileName(asset) == "package.json" => "PackageManifestImporter",
            ".json" or ".md" => "TextScriptImporter",
            _ => "DefaultImporter",
        };
        string[] script =
            ["  serializedVersion: 2", "  defaultReferences: []", "  executionOrder: 0", "  icon: {instanceID: 0}"];
        string[] lines =
        [
            "fileFormatVersion: 2",
            "guid: " + guid,
            .. isFolder ? ["folderAsset: yes"] : Array.Empty<string>(),
            importer + ":",
            "  externalObjects: {}",
            .. importer == "MonoImporter" ? script : [],
            "  userData: ",
            "  assetBundleName: ",
            "  assetBundleVariant: ",
        ];
        return string.Concat(lines.Select(line => line + "\n"));
    }

    [GeneratedRegex(@"\AfileFormatVersion: 2\nguid: ([0-9a-f]{32})\n")]
    private static partial Regex GuidLine();
}
