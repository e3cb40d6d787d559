using System.IO.Compression;
using System.Text;
using System.Text.Json;
using System.Xml.Linq;
using AngleSharp.Dom;
using AngleSharp.Html.Parser;
using NUnit.Framework;
using RigidBodyDynamics.Lab.Grading;
using RigidBodyDynamics.Lab.Grading.Marks;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.Tests.Grading;

/// <summary>Names, code and comments of students are text: no HTML in a page, no formula in a table, no path in a file's name.</summary>
public sealed class HostileTextTests
{
    private const string Script = "</script><script>document.title='x'</script><img src=x onerror=alert(1)>{{ page }}";

    private static readonly string[] Names =
        ["<img src=x onerror=alert(1)>", "=HYPERLINK(\"http://x\",\"y\")", "@SUM(A1)", "+1+1", "-2-3", "\"quoted\", 'too'", "\u202egnp.exe", "{{ 1 | plus: 1 }}", "CON", "学生.", "a\tb"];

    [Test]
    public void Names_and_code_are_shown_as_text()
    {
        using TemporaryFolder folder = new();
        Class all = Write(folder);
        foreach (string file in Directory.EnumerateFiles(folder.File("out"), "*.html", SearchOption.AllDirectories))
        {
            IDocument page = new HtmlParser().ParseDocument(File.ReadAllText(file));
            Assert.That(page.QuerySelectorAll("img, iframe, object, base, form, [onerror], [onload]"), Is.Empty, file);
            Assert.That(page.QuerySelectorAll("script").Select(script => script.GetAttribute("src")), Is.All.Null, file);
            Assert.That(page.QuerySelectorAll("a[href]").Select(link => link.GetAttribute("href")), Is.All.StartsWith("students/"), file);
            Assert.That(page.Body!.TextContent, Has.None.EqualTo('\u202e'), file);
        }

        IDocument index = new HtmlParser().ParseDocument(File.ReadAllText(folder.File("out/index.html")));
        string text = index.Body!.TextContent;
        Assert.That(text, Does.Contain("<img src=x onerror=alert(1)>").And.Contain("{{ 1 | plus: 1 }}").And.Contain("\\u202egnp.exe"));
        Assert.That(index.QuerySelectorAll("pre .row").Select(row => row.TextContent).Any(row => row.Contains(Script)), Is.True, "code side by side");
        Assert.That(all.Submissions, Has.Count.EqualTo(Names.Length));
    }

    [Test]
    public void No_cell_is_a_formula()
    {
        using TemporaryFolder folder = new();
        Write(folder);
        byte[] csv = File.ReadAllBytes(folder.File("out/marks.csv"));
        using ZipArchive book = ZipFile.OpenRead(folder.File("out/marks.xlsx"));
        XNamespace main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
        XElement[] sheets = [.. book.Entries.Where(entry => entry.FullName.StartsWith("xl/worksheets/", StringComparison.Ordinal)).Select(entry =>
        {
            using Stream sheet = entry.Open();
            return XElement.Load(sheet);
        })];

        Assert.That(csv.AsSpan().StartsWith(Encoding.UTF8.Preamble), Is.True);
        // a cell after a comma or at the beginning of a line, in quotes or not
        Assert.That(Encoding.UTF8.GetString(csv[3..]), Does.Not.Match("(^|[,\\n])\"?[=+@\\-]"));
        Assert.That(sheets, Has.Length.EqualTo(2));
        Assert.That(sheets.SelectMany(sheet => sheet.Descendants(main + "f")), Is.Empty);
        Assert.That(sheets.SelectMany(sheet => sheet.Descendants(main + "c")).Select(cell => cell.Value), Does.Contain("=HYPERLINK(\"http://x\",\"y\")"));
    }

    [Test]
    public void Names_of_pages_are_unlike_and_taken_by_every_system()
    {
        using TemporaryFolder folder = new();
        string[] pages = [.. Write(folder).Submissions.Select(one => one.Page)];

        Assert.That(pages.Select(page => page.ToUpperInvariant()).Distinct().Count(), Is.EqualTo(pages.Length));
        Assert.That(pages, Has.All.Match(@"^[\p{L}\p{N}_\-]+\.html$"));
        Assert.That(PageNames.Safe("con"), Is.EqualTo("_con"));
        Assert.That(PageNames.Safe("../../etc/passwd"), Is.EqualTo("etc_passwd"));
        Assert.That(PageNames.Safe(new string('x', 500)), Has.Length.EqualTo(60));
        Assert.That(PageNames.Safe("..."), Is.EqualTo("student"));
    }

    [Test]
    public void Json_says_exactly_what_the_names_are()
    {
        using TemporaryFolder folder = new();
        Write(folder);
        using JsonDocument json = JsonDocument.Parse(File.ReadAllBytes(folder.File("out/grade.json")));

        Assert.That(json.RootElement.GetProperty("schema").GetString(), Is.EqualTo("rigid-body-grade/1"));
        Assert.That(json.RootElement.GetProperty("submissions").EnumerateArray().Select(one => one.GetProperty("student").GetProperty("name").GetString()), Is.EquivalentTo(Names));
    }

    private static Class Write(TemporaryFolder folder)
    {
        string[] lines = [.. Names.Select((name, i) => $"{{ \"file\": \"class/{i}/MyRigidbody.cs\", \"student\": {{ \"id\": \"21084000{i:00}\", \"name\": {JsonSerializer.Serialize(name)} }} }}")];
        string body = string.Concat(Enumerable.Range(0, 40).Select(i => $"int a{i} = {i} * {i + 1} + {i % 7};\n"));
        for (int i = 0; i < Names.Length; i++)
        {
            Directory.CreateDirectory(folder.File($"class/{i}"));
            // two of them share much, so that code is shown
            File.WriteAllText(folder.File($"class/{i}/MyRigidbody.cs"), $"{Archives.Source} // {Script}\n// wrong: orientation <b>half</b>\n{(i < 2 ? body : string.Empty)}");
        }

        File.WriteAllText(folder.File("marks.json"), $"{{ \"schema\": \"{MarksFile.Schema}\", \"decisions\": [{string.Join(',', lines)}] }}");
        Class all = new Grader(new StandInBench()).Judge([folder.File("class")], folder.File("out"), null, MarksFile.Read(folder.File("marks.json")), _ => { });
        using ClassFiles files = new(folder.File("out"), []);
        files.Write(all);
        return all;
    }
}
