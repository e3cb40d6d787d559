using System.Text.RegularExpressions;
using System.Xml.Linq;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests.Repository;

/// <summary>Requirements of the sources that no compiler checks.</summary>
public sealed partial class SourceTests
{
    private static readonly string[] Core = [.. Tree.Files("MyRigidbody.Core", "*.cs").Where(path => !path.Contains("/Samples~/", StringComparison.Ordinal))];
    private static readonly string[] Tests = Tree.Files("tests/MyRigidbody.Tests", "*.cs");
    private static readonly string[] All = [.. Core, .. Tree.Files("MyRigidbody.Lab", "*.cs"), .. Tree.Files("tests", "*.cs")];

    // correctly rounded, or exact: all runtimes agree on them to the last bit
    private static readonly string[] SameEverywhere = ["Math.Abs", "Math.Ceiling", "Math.Floor", "Math.Max", "Math.Min", "Math.Sqrt"];

    [TestCase("MyRigidbody.Core/MyRigidbody.Core.csproj")]
    [TestCase("tests/MyRigidbody.BitHash/MyRigidbody.BitHash.csproj")]
    [TestCase("tests/UnityStubs/Unity.props")]
    public void What_Unity_and_Mono_compile_is_held_to_CSharp_7_3(string project)
    {
        IEnumerable<string> versions = XDocument.Parse(Tree.Text(project)).Descendants("LangVersion").Select(element => element.Value);

        Assert.That(versions, Is.EqualTo(new[] { "7.3" }));
    }

    [Test]
    public void Core_knows_nothing_of_the_engine() =>
        Assert.That(Matches(Core, UnityNames()), Is.Empty);

    [Test]
    public void Core_calls_only_functions_on_which_all_runtimes_agree() =>
        Assert.That(
            Matches(Core, MathCalls()).Where(found => !SameEverywhere.Contains(found.Text)),
            Is.EqualTo(new[] { ("MyRigidbody.Core/Bodies/Conserved.cs", "Math.Atan2") }));

    [Test]
    public void No_source_file_is_longer_than_300_lines() =>
        Assert.That(All.Where(path => File.ReadLines(Root.File(path)).Count() > 300), Is.Empty);

    // lines that are not empty, a comment or a brace; what Unity does not compile is not what a student reads, and of effects and integrators he
    // reads those of his scene
    [TestCase(true, 4219)] // measured 4214, 300 of them for kinds of inertia, impulses and masses that change
    [TestCase(false, 2700)] // measured 2656, 165 of them for all states at once, 124 for closed meshes, 220 for bodies of a crowd that are added, pushed, saved or fail one by one
    public void Core_is_short_enough_to_be_read_in_an_evening(bool inUnity, int fewerThan)
    {
        int lines = Core.Where(path => File.ReadLines(Root.File(path)).First() is not ("#if NET" or "#if !UNITY_5_3_OR_NEWER") == inUnity)
            .Where(path => !OneOfMany().IsMatch(Tree.Text(path)))
            .Sum(path => File.ReadLines(Root.File(path)).Count(line => !NoCode().IsMatch(line)));
        TestContext.Out.WriteLine(lines);
        Assert.That(lines, Is.LessThan(fewerThan));
    }

    [Test]
    public void Tests_assert_by_constraint_and_none_is_switched_off() =>
        Assert.That(
            Matches(Tests, OtherAsserts()),
            Is.EqualTo(new[]
            {
                ("tests/MyRigidbody.Tests/Determinism/MonoTests.cs", "Assert.Ignore"),
                ("tests/MyRigidbody.Tests/StudentScripts/WorkerTests.cs", "Assert.Ignore"),
                ("tests/MyRigidbody.Tests/StudentScripts/WorkerTests.cs", "Assert.Ignore"),
                ("tests/MyRigidbody.Tests/UnityProject/ShaderTests.cs", "Assert.Ignore"),
            }));

    private static IEnumerable<(string Path, string Text)> Matches(IEnumerable<string> files, Regex pattern) =>
        from path in files
        from line in File.ReadLines(Root.File(path))
        from Match match in pattern.Matches(Comment().Replace(line, string.Empty))
        select (path, match.Value);

    [GeneratedRegex("//.*")]
    private static partial Regex Comment();

    // blank, a comment, or braces alone
    [GeneratedRegex(@"^[\s{}]*(//.*)?$")]
    private static partial Regex NoCode();

    [GeneratedRegex(@"public (readonly )?struct \w+ : (IPush|ICoast|IEffect)|internal (readonly )?struct \w+ : IIntegrator")]
    private static partial Regex OneOfMany();

    [GeneratedRegex("Unity(Engine|Editor)")]
    private static partial Regex UnityNames();

    [GeneratedRegex(@"\bMathF?\.\w+|using static .*")]
    private static partial Regex MathCalls();

    [GeneratedRegex(@"\b(Collection|String|File|Directory)?Assert\.(?!That\b)\w+(?=\()|\[(Ignore|Explicit)\b")]
    private static partial Regex OtherAsserts();
}
