using System.Text;
using System.Text.RegularExpressions;
using NUnit.Framework;
using RigidBodyDynamics.Lab.Package;
using RigidBodyDynamics.StudentScripts;
using RigidBodyDynamics.Tests.Repository;

namespace RigidBodyDynamics.Tests.Package;

/// <summary>The students' package: it compiles, it contains no solution, and it can be imported beside the other one.</summary>
public sealed partial class StarterPackageTests
{
    private const string Top = "Assets/MyRigidbodyStarter/";

    private static readonly IReadOnlyList<Asset> Assets = Checkout.GatherStarter(Root.Path);

    [Test]
    public void Student_gets_his_script_Unitys_body_two_scenes_a_page_and_a_window() => Assert.That(
        Assets.Select(asset => asset.Path),
        Is.SupersetOf(new[]
        {
            Top + "MyRigidbody.cs", Top + "DefaultRigidbody.cs", Top + "Scenes/Starter.unity", Top + "Scenes/StarterBox.unity", Top + "README.md",
            Top + "README.zh.md", Top + "LICENSE.txt", Top + "Editor/CheckWindow.cs", Top + "Editor/Judge/Judge.cs",
        }));

    [Test]
    public void It_has_no_solution_in_it()
    {
        string script = Text("MyRigidbody.cs");

        Assert.That(Assets.Select(asset => asset.Path), Has.None.Match("/Core/|LabEuler|/Tests"));
        // the last five lines of Update are the TODOs, and nothing stands between them
        Assert.That(TodosAtTheEnd().IsMatch(script), Is.True);
        Assert.That(script, Does.Not.Contain("0.98").And.Not.Contain("transform."));
        foreach (Asset code in Assets.Where(asset => asset.Path.EndsWith(".cs", StringComparison.Ordinal)))
            Assert.That(Encoding.UTF8.GetString(code.Content!), Does.Not.Contain("I_ref * R"), code.Path);
    }

    [Test]
    public void Script_is_the_one_that_comments_are_compared_with() => Assert.That(ScriptRunner.SheetStarter, Is.EqualTo(Text("MyRigidbody.cs")));

    [TestCaseSource(typeof(PackageCompileTests), nameof(PackageCompileTests.Versions))]
    public void It_compiles_without_a_warning_in(string[] symbols)
    {
        UnityCompiler compiler = new(Assets, symbols);

        Assert.That(compiler.Assemblies, Is.EquivalentTo(new[] { "MyRigidbody.Judge", "MyRigidbody.Starter.Editor" }));
        Assert.That(compiler.Homeless, Is.EquivalentTo(new[] { Top + "MyRigidbody.cs", Top + "DefaultRigidbody.cs", Top + "BoxMesh.cs" }));
        foreach (string assembly in compiler.Assemblies)
            Assert.That(compiler.Complaints(assembly), Is.Empty, assembly);

        Assert.That(compiler.ComplaintsOfStudents(), Is.Empty);
    }

    [Test]
    public void Both_packages_can_be_imported_into_one_project()
    {
        IReadOnlyList<Asset> whole = Checkout.Gather(Root.Path);

        Assert.That(whole.Select(asset => asset.Guid).Intersect(Assets.Select(asset => asset.Guid)), Is.Empty);
        Assert.That(whole.Select(asset => asset.Path).Intersect(Assets.Select(asset => asset.Path)), Is.Empty);
        UnityCompiler together = new([.. whole, .. Assets], "UNITY_EDITOR", "UNITY_2019_3_OR_NEWER", "UNITY_2019_4_OR_NEWER", "ENABLE_LEGACY_INPUT_MANAGER");
        foreach (string assembly in together.Assemblies)
            Assert.That(together.Complaints(assembly), Is.Empty, assembly);
    }

    [Test]
    public void Packing_twice_gives_the_same_bytes() =>
        Assert.That(PackageWriter.Write(Checkout.GatherStarter(Root.Path)), Is.EqualTo(PackageWriter.Write(Assets)));

    private static string Text(string path) => Encoding.UTF8.GetString(Assets.Single(asset => asset.Path == Top + path).Content!);

    [GeneratedRegex(@"(// TODO [^\n]+\s+){5}\}\s*\}\s*\z")]
    private static partial Regex TodosAtTheEnd();
}
