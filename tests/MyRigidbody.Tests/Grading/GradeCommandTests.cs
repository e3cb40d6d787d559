using System.Text.Json;
using NUnit.Framework;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.Tests.Grading;

/// <summary>The command as an instructor runs it, with scripts really run.</summary>
public sealed class GradeCommandTests
{
    [Test]
    public void Packages_and_archives_of_the_sample_are_judged_as_labelled()
    {
        using TemporaryFolder folder = new();
        using JsonDocument labels = JsonDocument.Parse(File.ReadAllBytes(TestData.Path("submissions", "labels-packages.json")));

        LabProcess run = LabProcess.Run(folder.Path, "grade", TestData.Path("submissions", "packages"), "--out", "marks of 数媒");

        Assert.That((run.ExitCode, run.Error), Is.EqualTo((0, string.Empty)), run.Output);
        using JsonDocument json = JsonDocument.Parse(File.ReadAllBytes(folder.File("marks of 数媒/grade.json")));
        ILookup<string, JsonElement> found = json.RootElement.GetProperty("submissions").EnumerateArray().ToLookup(one => Text(one, "file").Split('!')[0]);
        foreach (JsonElement label in labels.RootElement.EnumerateArray().Where(label => Text(label, "verdict") != "mixed"))
            Assert.That(Text(found[Text(label, "file")].Single(), "verdict"), Is.EqualTo(Text(label, "verdict")), Text(label, "expected"));

        Assert.That(found["packages/数媒21-1.zip"].Select(one => Text(one, "verdict")), Is.EqualTo(new[] { "right", "wrong", "wrong" }));
        Assert.That(Steps("packages/210841002_学生二.unitypackage"), Is.EqualTo("right right right wrong right"));
        Assert.That(Steps("packages/210841006_学生六.zip"), Is.EqualTo("right right right right wrong"));
        Assert.That(Steps("packages/210841008_学生八.unitypackage"), Is.EqualTo("unknown unknown unknown unknown unknown"));
        Assert.That(Steps("packages/210841016_学生一六.unitypackage"), Is.EqualTo("missing missing missing missing missing"));
        Assert.That(Steps("packages/实验3-最终版.unitypackage"), Is.EqualTo("right right right right right"));
        Assert.That(found["packages/实验3-最终版.unitypackage"].Single().GetProperty("student").ValueKind, Is.EqualTo(JsonValueKind.Null));

        string Steps(string file) => string.Join(' ', found[file].Single().GetProperty("steps").EnumerateObject().Select(step => step.Value.GetString()));
    }

    [TestCase("error: nothing.zip: there is no such file", "nothing.zip")]
    [TestCase("error: .: there is no script, package or archive in it", ".")]
    [TestCase("error: list.txt: is no script (.cs), no .unitypackage and no .zip", "list.txt")]
    [TestCase("error: list.txt: line 1: there is no heading 学号 or 姓名", "--roster", "list.txt", ".")]
    [TestCase("error: list.txt: line 1, column 1:", "--marks", "list.txt", ".")]
    [TestCase("error: nothing.cs: there is no such file", "--starter", "nothing.cs", ".")]
    [TestCase("error: list.txt: is no script of Unity", "--starter", "list.txt", ".")]
    [TestCase("error: PATH: must not be empty", "")]
    [TestCase("error: Required argument 'PATH' missing")]
    public void What_cannot_be_graded_is_one_line(string line, params string[] arguments)
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("list.txt"), "a,b\n");

        LabProcess run = LabProcess.Run(folder.Path, ["grade", .. arguments]);

        Assert.That((run.ExitCode, run.Output), Is.EqualTo((2, string.Empty)));
        Assert.That(run.Error.TrimEnd(), Does.StartWith(line).And.Not.Contain("\n"));
        Assert.That(Directory.Exists(folder.File("out")), Is.False);
    }

    [Test]
    public void Roster_called_like_a_table_of_marks_is_not_written_over()
    {
        using TemporaryFolder folder = new();
        const string List = "学号,姓名\n210840007,学生一\n";
        File.WriteAllText(folder.File("marks.csv"), List);
        Directory.CreateDirectory(folder.File("class"));
        File.WriteAllText(folder.File("class/210840007_学生一.cs"), Archives.Source);

        LabProcess run = LabProcess.Run(folder.Path, "grade", "class", "--roster", "marks.csv", "--out", ".");

        Assert.That((run.ExitCode, run.Output), Is.EqualTo((2, string.Empty)));
        Assert.That(File.ReadAllText(folder.File("marks.csv")), Is.EqualTo(List));
        Assert.That(Directory.EnumerateFileSystemEntries(folder.Path).Select(Path.GetFileName), Is.EquivalentTo(new[] { "class", "marks.csv" }));
    }

    private static string Text(JsonElement element, string name) => element.GetProperty(name).GetString()!;
}
