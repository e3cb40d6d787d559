using NUnit.Framework;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>The pages of a class: in both languages, on a phone, and a student's on one sheet of paper.</summary>
public sealed class GradePageTests
{
    private const string Script = """
        using UnityEngine;
        public class MyRigidbody : MonoBehaviour
        {
            Vector3 v, w; float dt = 0.02f;
            void Update() { v = v + new Vector3(5, 0, 0); transform.Translate(v * dt); w = w * dt; transform.Rotate(w); }
        }
        """;

    private Browser _browser = null!;
    private TemporaryFolder _folder = null!;

    [OneTimeSetUp]
    public void Grade()
    {
        _browser = new Browser();
        _folder = new TemporaryFolder();
        foreach (string student in new[] { "210840007_学生一", "210840014_学生二" })
        {
            Directory.CreateDirectory(_folder.File("class/" + student));
            File.WriteAllText(_folder.File($"class/{student}/MyRigidbody.cs"), Script);
        }

        LabProcess run = LabProcess.Run(_folder.Path, "grade", "class", "--out", "out");
        Assert.That(run.ExitCode, Is.EqualTo(0), run.Error);
    }

    [TearDown]
    public void Nothing_complains() => Assert.That(_browser.Complaints(), Is.Empty);

    [OneTimeTearDown]
    public void Stop()
    {
        _browser?.Dispose();
        _folder?.Dispose();
    }

    [TestCase("zh", "需要您判断")]
    [TestCase("en", "Needs you")]
    public void Page_of_the_class_begins_with_what_needs_the_instructor(string language, string heading)
    {
        _browser.Open(_folder.File("out/index.html"), "#lang=" + language);
        _browser.Reload();

        Assert.That(_browser.Find("main h2").Text, Is.EqualTo(heading));
        Assert.That(_browser.Get<int>("document.querySelectorAll('table.steps tbody tr').length"), Is.EqualTo(2));
    }

    [TestCase("zh")]
    [TestCase("en")]
    public void Page_of_a_student_with_much_to_mend_prints_on_one_sheet(string language)
    {
        _browser.Open(_folder.File("out/students/210840007_学生一.html"), "#lang=" + language);
        _browser.Reload();
        _browser.Photograph("student-" + language);

        Assert.That(_browser.Get<int>("document.querySelectorAll('tr.finding').length"), Is.AtLeast(3));
        Assert.That(_browser.Sheets(), Is.EqualTo(1));
    }

    [Test]
    public void Page_of_the_class_fits_a_phone()
    {
        _browser.Resize(390, 800, isPhone: true);
        _browser.Open(_folder.File("out/index.html"), "#lang=zh");

        Assert.That(_browser.Get<int>("document.documentElement.scrollWidth"), Is.LessThanOrEqualTo(390));
        _browser.Resize(1200, 900);
    }
}
