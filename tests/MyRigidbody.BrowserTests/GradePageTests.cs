using NUnit.Framework;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>The pages of a class: in both languages, on a phone, and a student's on one sheet of paper.</summary>
public sealed class GradePageTests : BrowserFixture
{
    private const string Script = """
        using UnityEngine;
        public class MyRigidbody : MonoBehaviour
        {
            Vector3 v, w; float dt = 0.02f;
            void Update() { v = v + new Vector3(5, 0, 0); transform.Translate(v * dt); w = w * dt; transform.Rotate(w); }
        }
        """;

    private TemporaryFolder _folder = null!;

    [OneTimeSetUp]
    public void Grade()
    {
        _folder = new TemporaryFolder();
        foreach (string student in new[] { "210840007_学生一", "210840014_学生二" })
        {
            Directory.CreateDirectory(_folder.File("class/" + student));
            File.WriteAllText(_folder.File($"class/{student}/MyRigidbody.cs"), Script);
        }

        LabProcess run = LabProcess.Run(_folder.Path, "grade", "class", "--out", "out");
        Assert.That(run.ExitCode, Is.EqualTo(0), run.Error);
    }

    [OneTimeTearDown]
    public void Stop() => _folder?.Dispose();

    [TestCase("zh", "需要您判断")]
    [TestCase("en", "Needs you")]
    public void Page_of_the_class_begins_with_what_needs_the_instructor(string language, string heading)
    {
        Browser.Open(_folder.File("out/index.html"), "#lang=" + language);
        Browser.Reload();

        Assert.That(Browser.Find("main h2").Text, Is.EqualTo(heading));
        Assert.That(Browser.Get<int>("document.querySelectorAll('table.steps tbody tr').length"), Is.EqualTo(2));
    }

    [TestCase("zh")]
    [TestCase("en")]
    public void Page_of_a_student_with_much_to_mend_prints_on_one_sheet(string language)
    {
        Browser.Open(_folder.File("out/students/210840007_学生一.html"), "#lang=" + language);
        Browser.Reload();
        Browser.Photograph("student-" + language);

        Assert.That(Browser.Get<int>("document.querySelectorAll('tr.finding').length"), Is.AtLeast(3));
        Assert.That(Browser.Sheets(), Is.EqualTo(1));
    }

    [Test]
    public void Page_of_the_class_fits_a_phone()
    {
        Browser.Resize(390, 800, isPhone: true);
        Browser.Open(_folder.File("out/index.html"), "#lang=zh");

        Assert.That(Browser.Get<int>("document.documentElement.scrollWidth"), Is.LessThanOrEqualTo(390));
        Browser.Resize(1200, 900);
    }
}
