using System.Diagnostics;
using System.Text.Json;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests.CommandLine;

/// <summary>check, as a student runs it.</summary>
public sealed class CheckTests
{
    private const string Right = "210840007_学生一", Half = "210840364_学生五二", File = "MyRigidbody.cs";

    [Test]
    public void A_right_script_ends_with_0_and_five_lamps()
    {
        (int code, string output) = Check(Right, "--lang", "en");
        Assert.That(code, Is.Zero);
        Assert.That(output.Split("✔ right"), Has.Length.EqualTo(6));
        Assert.That(output, Does.Contain("16 of 16 statements"));
    }

    [TestCase("en", "✘ wrong", "the ½ is missing")]
    [TestCase("zh", "✘ 有误", "漏了 ½")]
    public void A_wrong_one_ends_with_1_and_says_which_step_is_wrong(string language, string lamp, string help)
    {
        (int code, string output) = Check(Half, "--lang", language);
        Assert.That(code, Is.EqualTo(1));
        Assert.That(output, Does.Contain(lamp).And.Contain(help).And.Contain("65").And.Contain("0.04 · [0, ½ω] q"));
    }

    [Test]
    public void As_JSON_it_is_one_submission()
    {
        JsonElement submission = JsonDocument.Parse(Check(Half, "--json").Output).RootElement;
        Assert.That(submission.GetProperty("verdict").GetString(), Is.EqualTo("wrong"));
        Assert.That(submission.GetProperty("steps").EnumerateObject().Select(step => (step.Name, step.Value.GetString())), Is.EqualTo(new[]
        {
            ("velocity", "right"), ("angularVelocity", "right"), ("position", "right"), ("orientation", "wrong"), ("damping", "right"),
        }));
        Assert.That(submission.GetProperty("student").GetProperty("id").GetString(), Is.EqualTo("210840364"));
        JsonElement finding = submission.GetProperty("findings").EnumerateArray().Single();
        Assert.That((finding.GetProperty("step").GetString(), finding.GetProperty("code").GetString(), finding.GetProperty("line").GetInt32()), Is.EqualTo(("orientation", "half-missing", 65)));
        Assert.That(finding.GetProperty("en").GetString(), Is.Not.Empty);
        Assert.That(finding.GetProperty("zh").GetString(), Is.Not.Empty);
    }

    [Test]
    public void The_page_shows_the_findings_and_three_bodies_on_the_cube_and_on_the_box()
    {
        using TemporaryFolder folder = new();
        Check(Half, "--out", folder.Path);
        string page = System.IO.File.ReadAllText(folder.File("report.html"));
        Assert.That(page, Does.Contain("漏了 ½").And.Contain("new Quaternion(w.x * dt, w.y * dt, w.z * dt, 0)"));
        foreach (string body in new[] { "script · cube", "reference · cube", "Unity · cube", "script · box", "reference · box", "Unity · box" })
            Assert.That(page, Does.Contain($"\"name\":\"{body}\""));
        Assert.That(page, Does.Contain("\"zh\":\"脚本 · 立方体\""));
    }

    [Test]
    public void What_is_no_script_ends_with_2()
    {
        using TemporaryFolder folder = new();
        System.IO.File.WriteAllText(folder.File("notes.cs"), "nothing");
        LabProcess missing = LabProcess.Run(folder.Path, "check", "missing.cs"), none = LabProcess.Run(folder.Path, "check", "notes.cs", "--lang", "en");
        Assert.That((missing.ExitCode, none.ExitCode), Is.EqualTo((2, 2)));
        Assert.That(missing.Error, Is.EqualTo("error: missing.cs: there is no such file\n"));
        Assert.That((none.Output, none.Error), Is.EqualTo((string.Empty, "error: notes.cs: There is no class MyRigidbody : MonoBehaviour with Update or FixedUpdate.\n")));
    }

    [Test]
    [Platform("Unix")]
    public void What_cannot_be_read_beside_a_script_is_left_out()
    {
        using TemporaryFolder folder = new();
        System.IO.File.Copy(TestData.Path("submissions", "class", Right, File), folder.File(File));
        System.IO.File.CreateSymbolicLink(folder.File(".#" + File), "somebody@somewhere.1234");
        Process.Start("mkfifo", [folder.File("pipe.cs")]).WaitForExit();

        Assert.That(LabProcess.Run(folder.Path, "check", File).ExitCode, Is.Zero);
    }

    private static (int Code, string Output) Check(string student, params string[] options)
    {
        LabProcess process = LabProcess.Run(TestData.Path("submissions", "class", student), ["check", File, .. options]);
        return (process.ExitCode, process.Output);
    }
}
