using NUnit.Framework;
using RigidBodyDynamics.Lab.Grading.Reading;
using RigidBodyDynamics.Lab.Grading.Students;

namespace RigidBodyDynamics.Tests.Grading;

/// <summary>The packages and archives of the sample, as their labels say (tests/data/submissions/labels-packages.json).</summary>
public sealed class LabelledPackageTests
{
    // the script that each holds is one of the class, with its student there
    [TestCase("210841001_学生一.unitypackage", "210841001", "学生一", "Assets/MyRigidbody.cs", 2)]
    [TestCase("210841002_学生二.unitypackage", "210841002", "学生二", "Assets/Scripts/MyRigidbody.cs", 2)]
    [TestCase("210841003_学生三.unitypackage", "210841003", "学生三", "Assets/实验3/脚本/MyRigidbody.cs", 2)]
    [TestCase("210841005_学生五.unitypackage", "210841005", "学生五", "Assets/MyRigidbody.cs", 3)]
    [TestCase("210841016_学生一六.unitypackage", "210841016", "学生一六", "Assets/MyRigidbody.cs", 2)]
    public void Package_is_read_with_its_student_and_all_its_scripts(string file, string id, string name, string main, int scripts)
    {
        Submission read = Submissions(file).Single();

        Assert.That(read.Student, Is.EqualTo(new Student(id, name)));
        Assert.That(read.NameAsAsked, Is.True);
        Assert.That((read.Problem, read.Notes.Count), Is.EqualTo(((object?)null, 0)));
        Assert.That(read.Scripts, Has.Count.EqualTo(scripts));
        Assert.That(read.Scripts.Where(Grouping.IsMain).Select(script => script.Spot.Shown), Is.EqualTo(new[] { $"{file}!{main}" }));
    }

    [Test]
    public void Zip_of_a_folder_with_the_package_and_the_report_is_one_submission()
    {
        Submission read = Submissions("210841006_学生六.zip").Single();

        Assert.That(read.Spot.Shown, Is.EqualTo("210841006_学生六.zip!210841006_学生六/210841006_学生六.unitypackage"));
        Assert.That((read.Student, read.NameAsAsked, read.Scripts.Count(Grouping.IsMain)), Is.EqualTo((new Student("210841006", "学生六"), true, 1)));
    }

    [Test]
    public void Package_that_is_cut_off_says_so_and_has_its_student()
    {
        Submission read = Submissions("210841008_学生八.unitypackage").Single();

        Assert.That((read.Problem?.Code, read.Student?.Id), Is.EqualTo(("truncated", "210841008")));
    }

    [Test]
    public void Package_without_a_script_has_none()
    {
        Submission read = Submissions("210841013_学生一三.unitypackage").Single();

        Assert.That((read.Problem, read.Scripts.Count), Is.EqualTo(((object?)null, 0)));
    }

    [Test]
    public void Package_that_is_not_named_as_asked_has_no_student()
    {
        Submission read = Submissions("实验3-最终版.unitypackage").Single();

        Assert.That((read.Student, read.NameAsAsked, read.Scripts.Count(Grouping.IsMain)), Is.EqualTo(((Student?)null, false, 1)));
    }

    [Test]
    public void Zip_of_the_class_with_names_in_GBK_gives_its_three_students() =>
        Assert.That(
            Submissions("数媒21-1.zip").Select(read => (read.Student, read.Scripts.Count(Grouping.IsMain))),
            Is.EqualTo(new[] { (new Student("210841031", "学生三一"), 1), (new Student("210841032", "学生三二"), 1), (new Student("210841033", "学生三三"), 1) }));

    [Test]
    public void Folder_of_the_class_is_41_submissions_of_as_many_students()
    {
        IReadOnlyList<Submission> read = Grouping.Of(HandedIn.Read([TestData.Path("submissions", "class")], "out"), null);

        Assert.That(read, Has.Count.EqualTo(41));
        Assert.That(read.Select(one => one.Student!.Id).Distinct().Count(), Is.EqualTo(41));
        Assert.That(read.Select(one => one.NameAsAsked), Is.All.True);
        Assert.That(read.Select(one => one.Scripts.Single().Spot.Shown), Does.Contain("class/210840007_学生一/MyRigidbody.cs"));
    }

    private static IReadOnlyList<Submission> Submissions(string file) =>
        Grouping.Of(new HandedIn(Reader.Read(new Spot(file, [file]), File.ReadAllBytes(TestData.Path("submissions", "packages", file))), []), null);
}
