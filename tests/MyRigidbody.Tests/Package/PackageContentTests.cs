using System.Text;
using System.Text.RegularExpressions;
using NUnit.Framework;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Lab.Package;
using RigidBodyDynamics.Tests.CommandLine;
using RigidBodyDynamics.Tests.Repository;

namespace RigidBodyDynamics.Tests.Package;

/// <summary>The contents of the package, what it excludes, and what prevents writing one.</summary>
public sealed partial class PackageContentTests
{
    private const string Project = "UnityProject/Assets/MyRigidbody", Script = Project + "/Scripts/MyRigidbody.cs";

    private static readonly (string What, Action<string> Break, string Says)[] Broken =
    [
        ("a file without a meta", root => File.Delete(Path.Combine(root, Script + ".meta")), "MyRigidbody.cs: has no meta"),
        ("a meta without a file", root => File.Delete(Path.Combine(root, Script)), "MyRigidbody.cs.meta: nothing stands beside it"),
        ("a GUID in capitals", root => Edit(root, Script + ".meta", meta => Guid().Replace(meta, guid => guid.Value.ToUpperInvariant())), "MyRigidbody.cs.meta: must begin with"),
        ("a GUID typed by hand", root => Edit(root, Script + ".meta", meta => Guid().Replace(meta, "00000000000000000123000000000000")), "MyRigidbody.cs: its GUID"),
        ("a GUID used twice", root => Edit(root, Script + ".meta", _ => File.ReadAllText(Path.Combine(root, Project + "/Scripts/Panel.cs.meta"))), "has the GUID of"),
        ("a folder's meta for a file", root => Edit(root, Script + ".meta", meta => meta.Replace("MonoImporter:", "folderAsset: yes\nMonoImporter:")), "must not have the line 'folderAsset: yes'"),
        ("a file's meta for a folder", root => Edit(root, Project + "/Scripts.meta", meta => meta.Replace("folderAsset: yes\n", "")), "must have the line 'folderAsset: yes'"),
        ("a carriage return", root => Edit(root, Script, text => text.Replace("\n", "\r\n")), "MyRigidbody.cs: must have LF"),
        ("a byte order mark", root => File.WriteAllText(Path.Combine(root, Script), "class A { }", new UTF8Encoding(true)), "must have no byte order mark"),
        ("a name in Chinese", root => Add(root, Project + "/刚体.txt"), "has a character that not every file system takes"),
        ("a name too long", root => Add(root, Project + "/" + new string('a', 120) + ".txt"), "must begin with Assets/MyRigidbody and have at most 120"),
        ("no scripts at all", root => Directory.Delete(Path.Combine(root, Project), true), "MyRigidbody: cannot be read"),
        ("no license", root => File.Delete(Path.Combine(root, "LICENSE")), "LICENSE: cannot be read"),
    ];

    private static readonly IReadOnlyList<Asset> Assets = Checkout.Gather(Root.Path);

    [Test]
    public void Everything_lands_in_one_folder_with_the_core_as_source()
    {
        string[] paths = [.. Assets.Select(asset => asset.Path)];

        Assert.That(paths, Has.All.StartsWith("Assets/MyRigidbody"));
        Assert.That(paths, Does.Contain("Assets/MyRigidbody/Core/Integrators/LabEuler.cs").And.Contain("Assets/MyRigidbody/Scripts/MyRigidbody.cs")
            .And.Contain("Assets/MyRigidbody/README.md").And.Contain("Assets/MyRigidbody/README.zh.md").And.Contain("Assets/MyRigidbody/LICENSE.txt"));
    }

    [Test]
    public void Nothing_in_it_is_a_test_a_project_a_library_or_compiles_to_nothing()
    {
        Assert.That(Assets.Select(asset => asset.Path), Has.None.Match(@"/Tests(/|$)|\.csproj|packages\.lock|/package\.json|\.dll|\.sln|/Batch|/\.|~$"));
        // NUnit in a student's project would be an error there
        Assert.That(Assets.Where(asset => !asset.IsFolder).Select(asset => Encoding.UTF8.GetString(asset.Content!)), Has.None.Contain("using NUnit"));
        Assert.That(
            Assets.Where(asset => asset.Path.EndsWith(".cs", StringComparison.Ordinal) && Encoding.UTF8.GetString(asset.Content!).StartsWith("#if NET\n", StringComparison.Ordinal)).Select(asset => asset.Path),
            Is.Empty);
    }

    [Test]
    public void Every_asset_is_the_file_of_the_checkout_with_the_GUID_of_its_meta_there()
    {
        string[] others = ["Assets/MyRigidbody/Core", "Assets/MyRigidbody/LICENSE.txt"];
        foreach (Asset asset in Assets.Where(asset => !others.Contains(asset.Path)))
        {
            string source = asset.Path.StartsWith("Assets/MyRigidbody/Core/", StringComparison.Ordinal)
                ? "MyRigidbody.Core/" + asset.Path["Assets/MyRigidbody/Core/".Length..]
                : "UnityProject/" + asset.Path;
            Assert.That(File.ReadAllText(Root.File(source + ".meta")), Does.Contain("guid: " + asset.Guid + "\n"), source);
            Assert.That(Encoding.UTF8.GetString(asset.Meta), Is.EqualTo(File.ReadAllText(Root.File(source + ".meta"))), source);
            if (!asset.IsFolder)
                Assert.That(asset.Content, Is.EqualTo(File.ReadAllBytes(Root.File(source))), source);
        }
    }

    [Test]
    public void Two_packs_have_the_same_bytes_wherever_whenever_and_in_whatever_language_they_are_made()
    {
        using TemporaryFolder folder = new();
        string copy = Copy(folder);
        foreach (string file in Directory.EnumerateFiles(copy, "*", SearchOption.AllDirectories))
            File.SetLastWriteTimeUtc(file, new DateTime(2031, 2, 3, 4, 5, 6, DateTimeKind.Utc));

        string[] pack = ["pack", "--out", folder.File("a.unitypackage")];
        LabProcess packed = LabProcess.Run(copy, new() { ["TZ"] = "Asia/Shanghai", ["LC_ALL"] = "de_DE.UTF-8", ["LANG"] = "tr_TR.UTF-8" }, pack);

        Assert.That((packed.ExitCode, packed.Error), Is.EqualTo((0, string.Empty)));
        Assert.That(File.ReadAllBytes(folder.File("a.unitypackage")), Is.EqualTo(PackageWriter.Write(Assets)));
        Assert.That(packed.Output, Does.Contain(FormattableString.Invariant($"{Assets.Count(asset => !asset.IsFolder)} files in {Assets.Count(asset => asset.IsFolder)} folders")));
    }

    [TestCaseSource(nameof(Broken))]
    public void Checkout_that_would_make_a_broken_package_is_refused((string What, Action<string> Break, string Says) flaw)
    {
        using TemporaryFolder folder = new();
        string copy = Copy(folder);
        flaw.Break(copy);

        InputException refused = Assert.Throws<InputException>(() => Checkout.Gather(copy))!;

        Assert.That(refused.Message, Does.Contain(flaw.Says).And.Not.Contain("\n"));
    }

    [Test]
    public void Refused_package_leaves_no_file_and_one_line()
    {
        using TemporaryFolder folder = new();
        string copy = Copy(folder);
        File.Delete(Path.Combine(copy, Script + ".meta"));

        LabProcess refused = LabProcess.Run(copy, "pack", "--out", Path.Combine(copy, "out", "a.unitypackage"));

        Assert.That((refused.ExitCode, refused.Error.TrimEnd().Split('\n').Length), Is.EqualTo((2, 1)));
        Assert.That(Directory.Exists(Path.Combine(copy, "out")), Is.False);
    }

    [TestCase("a.zip")]
    [TestCase(".unitypackage")]
    [TestCase("")]
    public void Name_that_Unity_would_not_show_is_refused(string name)
    {
        using TemporaryFolder folder = new();
        LabProcess refused = LabProcess.Run(folder.Path, "pack", "--out", name);

        Assert.That((refused.ExitCode, refused.Error), Is.EqualTo((2, $"error: --out: must be a file that ends in .unitypackage, found \"{name}\"{Environment.NewLine}")));
    }

    [Test]
    public void Command_that_is_run_from_elsewhere_packs_the_checkout_it_was_built_from()
    {
        using TemporaryFolder folder = new();
        LabProcess packed = LabProcess.Run(folder.Path, "pack");

        Assert.That((packed.ExitCode, packed.Error), Is.EqualTo((0, string.Empty)));
        Assert.That(File.ReadAllBytes(folder.File("MyRigidbody.unitypackage")), Is.EqualTo(PackageWriter.Write(Assets)));
    }

    private static string Copy(TemporaryFolder folder)
    {
        string to = folder.File("checkout");
        foreach (string part in new[] { "UnityProject/Assets", "MyRigidbody.Core" })
        {
            foreach (string from in Directory.EnumerateFiles(Root.File(part), "*", SearchOption.AllDirectories))
            {
                string path = Path.Combine(to, Path.GetRelativePath(Root.Path, from));
                Directory.CreateDirectory(Path.GetDirectoryName(path)!);
                File.Copy(from, path);
            }
        }

        File.Copy(Root.File("LICENSE"), Path.Combine(to, "LICENSE"));
        File.WriteAllText(Path.Combine(to, "MyRigidbody.sln"), string.Empty);
        return to;
    }

    private static void Edit(string root, string path, Func<string, string> change) =>
        File.WriteAllText(Path.Combine(root, path), change(File.ReadAllText(Path.Combine(root, path))));

    private static void Add(string root, string path)
    {
        File.WriteAllText(Path.Combine(root, path), "text");
        File.WriteAllBytes(Path.Combine(root, path + ".meta"), Meta.Text("0123456789abcdef0123456789abcdef"));
    }

    [GeneratedRegex("(?<=guid: )[0-9a-f]{32}")]
    private static partial Regex Guid();
}
