using System.Text;
using System.Text.Json;
using NUnit.Framework;
using OpenQA.Selenium;
using RigidBodyDynamics.Tests.CommandLine;
using RigidBodyDynamics.Tests.Repository;

namespace RigidBodyDynamics.BrowserTests;

/// <summary>Scripts that are opened, and what is downloaded.</summary>
public sealed partial class WritePageTests
{
    [TestCase("gbk")]
    [TestCase("utf-16")]
    [TestCase("utf-8")]
    public void Scripts_in_other_encodings_open(string encoding)
    {
        Encoding.RegisterProvider(CodePagesEncodingProvider.Instance);
        Encoding way = Encoding.GetEncoding(encoding == "gbk" ? "GB18030" : encoding);
        string text = Starter.Replace("TODO 更新速度", "还没有写速度", StringComparison.Ordinal);
        File.WriteAllBytes(_folder.File("MyRigidbody.cs"), [.. way.GetPreamble(), .. way.GetBytes(text)]);

        Choose(_folder.File("MyRigidbody.cs"));

        Assert.That(Text(), Is.EqualTo(text));
    }

    [Test]
    public void A_package_opens_with_the_file_that_its_script_needs()
    {
        Choose(Root.File("tests/data/submissions/packages/210841005_学生五.unitypackage"));

        Assert.That(Lamps(), Is.All.EqualTo("right"));
        Assert.That(Browser.Find(".write .beside").Text, Does.Contain(".cs"));
    }

    [Test]
    public void Of_two_scripts_one_is_chosen()
    {
        File.WriteAllText(_folder.File("first.cs"), Starter + "// first");
        File.WriteAllText(_folder.File("second.cs"), Starter + "// second");
        Browser.Find(".write input[type=file]").SendKeys(_folder.File("first.cs") + "\n" + _folder.File("second.cs"));
        Assert.That(Browser.Becomes("document.querySelector('.write .choice').open"), Is.True);

        Browser.Press(Keys.ArrowDown + Keys.Enter);
        if (Browser.Get<bool>("document.querySelector('.write .choice').open"))
            Browser.Find(".write .choice button[value=yes]").Click();

        Assert.That(Browser.Becomes("lab.write.editor.text.endsWith('// second')"), Is.True);
    }

    [TestCase("210841008_学生八.unitypackage")]
    [TestCase("notes.txt")]
    public void What_cannot_be_opened_is_refused_in_one_line_and_the_text_stays(string name)
    {
        string before = Text(), file = Root.File("tests/data/submissions/packages/" + name);
        if (!File.Exists(file))
            File.WriteAllText(file = _folder.File(name), "no script");

        Browser.Find(".write input[type=file]").SendKeys(file);

        Assert.That(Browser.Becomes("document.querySelector('.write .news.refused:not([hidden])') !== null"), Is.True);
        Assert.That(Browser.Find(".write .news").Text, Does.StartWith(name).And.Not.Contain("\n"));
        Assert.That(Text(), Is.EqualTo(before));
    }

    [Test]
    public void What_is_downloaded_is_what_check_and_grade_read()
    {
        Choose(Root.File("tests/data/submissions/class/210840329_学生四七/MyRigidbody.cs"));
        string[] lamps = Lamps();
        string saved = Directory.CreateDirectory(_folder.File("saved")).FullName;
        Browser.SaveTo(saved);

        Browser.Find(".write .download").Click();
        Browser.Find(".write .hand-in").Click();
        Browser.Press("20211130" + Keys.Tab + "张三" + Keys.Enter);
        Assert.That(Browser.Becomes("document.querySelector('.write .refusal').textContent"), Is.True, "a day is no number");
        Browser.Find(".write .pack input").Clear();
        Browser.Find(".write .pack input").SendKeys("210840007" + Keys.Enter);

        string script = Path.Combine(saved, "MyRigidbody.cs"), package = Path.Combine(saved, "210840007_张三.unitypackage");
        Assert.That(() => File.Exists(script) && File.Exists(package), Is.True.After(5000, 50));
        Assert.That(File.ReadAllText(script), Is.EqualTo(Text()));
        using JsonDocument check = JsonDocument.Parse(LabProcess.Run(_folder.Path, "check", script, "--json").Output);
        LabProcess grade = LabProcess.Run(_folder.Path, "grade", package, "--out", "graded");
        string row = File.ReadAllLines(_folder.File("graded/marks.csv"))[1];

        Assert.That(Steps.Select(step => check.RootElement.GetProperty("steps").GetProperty(step).GetString()), Is.EqualTo(lamps));
        Assert.That(grade.ExitCode, Is.Zero, grade.Error);
        Assert.That(row, Does.Contain("210840007").And.Contain("张三"));
    }

    private void Choose(string file)
    {
        Browser.Do("lab.write.opened = false; lab.addEventListener('verdict', () => lab.write.opened = true, { once: true })");
        Browser.Find(".write input[type=file]").SendKeys(file);
        Assert.That(Browser.Becomes("lab.write.opened", 90), Is.True, "was not opened");
        WaitForVerdict();
    }
}
