using System.Text;
using System.Text.Json;
using NUnit.Framework;
using RigidBodyDynamics.Lab.Package;
using RigidBodyDynamics.Tests.CommandLine;
using RigidBodyDynamics.Tests.Repository;

namespace RigidBodyDynamics.Tests.Package;

/// <summary>What a student imports compiles there, from the files of the package alone.</summary>
public sealed class PackageCompileTests
{
    private static readonly string[] To2019 = ["UNITY_EDITOR", "UNITY_5_3_OR_NEWER", "UNITY_2019_3_OR_NEWER", "UNITY_2019_4_OR_NEWER", "CSHARP_7_3_OR_NEWER"];

    private static readonly string[] Later =
    [
        "UNITY_2020_3_OR_NEWER", "UNITY_2021_3_OR_NEWER", "UNITY_2022_3_OR_NEWER", "UNITY_2023_2_OR_NEWER", "UNITY_6000_0_OR_NEWER", "UNITY_6000_1_OR_NEWER",
        "UNITY_6000_3_OR_NEWER", "UNITY_6000_6_OR_NEWER",
    ];

    private static readonly string[] Old = ["ENABLE_LEGACY_INPUT_MANAGER"], New = ["ENABLE_INPUT_SYSTEM"], Both = [.. Old, .. New];

    // nine versions, each kind of input in three of them
    internal static readonly TestCaseData[] Versions =
    [
        Case("2019.4, Input", 0, Old), Case("2020.3, both", 1, Both), Case("2021.3, Input System", 2, New),
        Case("2022.3, Input", 3, Old), Case("2023.2, both", 4, Both), Case("6000.0, Input System", 5, New),
        Case("6000.1, both", 6, Both), Case("6000.3, Input", 7, Old), Case("6000.6, Input System", 8, New),
    ];

    [TestCaseSource(nameof(Versions))]
    public void Unpacked_files_compile_without_a_warning_in(string[] symbols)
    {
        UnityCompiler compiler = new(Unpacked(), symbols);

        string[] always = ["MyRigidbody.Core", "MyRigidbody.Scripts", "MyRigidbody.Editor"];
        Assert.That(compiler.Assemblies, Is.EquivalentTo(symbols.Contains("ENABLE_INPUT_SYSTEM") ? [.. always, "MyRigidbody.InputSystem"] : always));
        Assert.That(compiler.Homeless, Is.Empty);
        foreach (string assembly in compiler.Assemblies)
            Assert.That(compiler.Complaints(assembly), Is.Empty, assembly);
    }

    [Test]
    public void Samples_of_the_library_compile_where_it_is_in_the_project()
    {
        using JsonDocument manifest = JsonDocument.Parse(Tree.Text("MyRigidbody.Core/package.json"));
        Asset like = Unpacked().First(asset => asset.Path.EndsWith("Scripts/ToUnity.cs", StringComparison.Ordinal));
        foreach (JsonElement sample in manifest.RootElement.GetProperty("samples").EnumerateArray())
        {
            string[] scripts = Tree.Files("MyRigidbody.Core/" + sample.GetProperty("path").GetString(), "*.cs");
            UnityCompiler compiler = new(
                [.. Unpacked(), .. scripts.Select(path => like with { Path = "Assets/Samples/" + Path.GetFileName(path), Content = Encoding.UTF8.GetBytes(Tree.Text(path)) })],
                [.. To2019, .. Old]);

            Assert.That(scripts, Is.Not.Empty);
            Assert.That(compiler.Homeless.Count(), Is.EqualTo(scripts.Length));
            Assert.That(compiler.ComplaintsOfStudents(), Is.Empty);
        }
    }

    [TestCase("public class A { public double Root = System.MathF.Sqrt(2); }", "CS0234")]
    [TestCase("public class A { public string? Name; }", "CS8370")]
    [TestCase("public class A : UnityEngine.MonoBehaviour { void Start() { var b = GetComponent<UnityEngine.Rigidbody>(); b.linearVelocity = default; } }", "CS1061")]
    [TestCase("public class A { public int X => 1 switch { _ => 2 }; }", "CS8370")]
    [TestCase("using NUnit.Framework; public class A { }", "CS0246")]
    public void What_Unity_2019_would_refuse_is_refused(string script, string error)
    {
        Asset like = Unpacked().First(asset => asset.Path.EndsWith("Scripts/ToUnity.cs", StringComparison.Ordinal));
        Asset wrong = like with { Path = "Assets/MyRigidbody/Scripts/A.cs", Content = Encoding.UTF8.GetBytes(script) };
        UnityCompiler compiler = new([.. Unpacked(), wrong], [.. To2019, "ENABLE_LEGACY_INPUT_MANAGER"]);

        Assert.That(compiler.Complaints("MyRigidbody.Scripts"), Has.Some.Contains(error));
    }

    private static TestCaseData Case(string name, int version, string[] input)
    {
        // what lies in between: 2021.2 brought .NET Standard 2.1, 2022.2 another way to step physics by a script, 2023.1 made AssemblyBuilder obsolete
        string[] between =
        [
            .. version > 1 ? (string[])["UNITY_2021_2_OR_NEWER", "NET_STANDARD", "NET_STANDARD_2_1"] : ["NET_STANDARD_2_0"],
            .. version > 2 ? (string[])["UNITY_2022_2_OR_NEWER"] : [], .. version > 3 ? (string[])["UNITY_2023_1_OR_NEWER"] : [],
        ];
        return new TestCaseData((object)(string[])[.. To2019, .. Later.Take(version), .. between, .. input]).SetArgDisplayNames(name);
    }

    private static IReadOnlyList<Asset> Unpacked()
    {
        using TemporaryFolder folder = new();
        File.WriteAllBytes(folder.File("a.unitypackage"), PackageWriter.Write(Checkout.Gather(Root.Path)));
        return PackageReader.Read(folder.File("a.unitypackage"));
    }
}
