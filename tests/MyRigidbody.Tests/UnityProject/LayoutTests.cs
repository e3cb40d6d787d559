using System.Text.RegularExpressions;
using NUnit.Framework;
using RigidBodyDynamics.Tests.Repository;
using RigidBodyDynamics.UnityFiles;
using RigidBodyDynamics.UnityFiles.Checks;
using YamlDotNet.RepresentationModel;

namespace RigidBodyDynamics.Tests.UnityProject;

/// <summary>The checker's list of Unity's classes agrees with what 2019.4.17f1 writes.</summary>
public sealed partial class LayoutTests
{
    private static readonly string[] Classes = File.ReadAllText(Root.File("tests/data/unity-layouts/2019.4.17f1.txt"))
        .Split('\n').Where(line => Head().IsMatch(line)).ToArray();

    [TestCaseSource(nameof(Classes))]
    public void Fields_their_order_and_the_version_of_the_class_are_those_of_the_editor(string head)
    {
        string[] parts = head.Split(' ');
        (string typeName, YamlMappingNode fields) = Layouts.Of(int.Parse(parts[1], System.Globalization.CultureInfo.InvariantCulture))!.Value;
        string[] ours = [.. fields.Children.Keys.Select(key => key.Text()).Where(name => name is not ("serializedVersion" or "..."))];
        string[] editors = [.. File.ReadLines(Root.File("tests/data/unity-layouts/2019.4.17f1.txt")).SkipWhile(line => line != head).Skip(1).TakeWhile(line => line.StartsWith('\t'))];

        Assert.That(typeName, Is.EqualTo(parts[0]));
        Assert.That(editors, Has.Length.EqualTo(ours.Length));
        // "float field of view": the name is what stands after the type, and both may have spaces
        Assert.That(ours.Zip(editors).Where(pair => !pair.Second.EndsWith(" " + pair.First, StringComparison.Ordinal)), Is.Empty);
        Assert.That(fields.Children.TryGetValue("serializedVersion", out YamlNode? version) ? version.Text() : "=1", Is.EqualTo("=" + parts[3]));
    }

    [Test]
    public void Every_class_that_the_checker_knows_is_among_them() =>
        Assert.That(Classes.Select(head => int.Parse(head.Split(' ')[1], System.Globalization.CultureInfo.InvariantCulture)), Is.EquivalentTo(Layouts.Known));

    [GeneratedRegex(@"^\w+ \d+ version \d+$")]
    private static partial Regex Head();
}
