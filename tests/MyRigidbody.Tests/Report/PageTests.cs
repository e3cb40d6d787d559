using System.Text.RegularExpressions;
using AngleSharp.Dom;
using NUnit.Framework;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Report;

namespace RigidBodyDynamics.Tests.Report;

/// <summary>The contents of a page, and that it is safe.</summary>
public sealed partial class PageTests
{
    private const string Hostile = "</script><script>broken()</script><img src=x onerror='broken()'>\"' {{ page.file }} <!-- &lt; 刚体";

    private static readonly Lazy<Parsed> Lab = new(() => Parsed.Compared("lab.json"));

    [TestCase("lab.json")]
    [TestCase("heavy-top.json")]
    public void Page_is_HTML_that_no_browser_has_to_mend(string scene)
    {
        Parsed page = Parsed.Compared(scene);
        string[] ids = [.. page.Document.QuerySelectorAll("[id]").Select(element => element.Id!)];

        Assert.That(ids, Is.Unique);
        Assert.That(page.Document.QuerySelectorAll("main > section").Select(section => section.Id), Is.EqualTo(new[] { "replay", "plots", "rules", "plan", "facts" }));
        Assert.That(References(page.Document, "aria-labelledby").Concat(References(page.Document, "aria-describedby")).Except(ids), Is.Empty);
    }

    [Test]
    public void A_tag_that_is_not_closed_is_noticed() =>
        Assert.That(() => new Parsed(Lab.Value.Html.Replace("</main>", "</table></main>")), Throws.Exception);

    [Test]
    public void Tables_can_be_read_aloud()
    {
        IElement[] tables = [.. Lab.Value.Document.QuerySelectorAll("table")];

        Assert.That(tables, Has.Length.EqualTo(5));
        Assert.That(tables.Where(table => string.IsNullOrWhiteSpace(table.QuerySelector("caption")?.TextContent)), Is.Empty);
        Assert.That(Lab.Value.Document.QuerySelectorAll("th:not([scope])"), Is.Empty);
        Assert.That(Lab.Value.Document.QuerySelectorAll("input:not(label input)").Select(input => input.Id), Is.EqualTo(new[] { "time" }));
    }

    [Test]
    public void Table_of_rules_says_what_the_readme_says()
    {
        string[] rows = [.. Lab.Value.Document.QuerySelectorAll("table.rules tbody tr").Select(row => string.Join('|', English(row).Split('\n', StringSplitOptions.TrimEntries | StringSplitOptions.RemoveEmptyEntries)))];

        Assert.That(rows, Has.Length.EqualTo(6));
        Assert.That(rows[0], Is.EqualTo("inertia|0.0 % 0.000 m|45.3 % 587.66°|0.5 kg m²|0.1667 kg m², mine / 3"));
        Assert.That(rows[2], Is.EqualTo("limit of spin|0.0 % 0.000 m|-160.2 % -2080°|none|7 rad/s"));
        Assert.That(Lab.Value.Document.QuerySelectorAll(".bar.less"), Has.Length.EqualTo(1));
    }

    [Test]
    public void Plans_are_those_that_explain_prints()
    {
        foreach (Body body in new Simulation(SceneReader.Read(Gallery.Lab).Scene).Bodies)
        {
            Explanation explanation = new(body.Plan);
            IElement table = Lab.Value.Document.QuerySelectorAll("table.plan").Single(table => English(table).Contains(body.Name + ", by"));
            string[] expected = [.. body.Plan.Stretches.Select(stretch => explanation.Time(stretch) + ": " + string.Join(", ", explanation.Parts(stretch)))];
            string[] rows = [.. table.QuerySelectorAll("tr:has(li)").Select(row =>
                English(row.QuerySelector("th")!) + ": " + string.Join(", ", row.QuerySelectorAll("li").Select(English)))];

            Assert.That(rows, Is.EqualTo(expected));
            Assert.That(table.QuerySelectorAll("tr.left"), Has.Length.EqualTo(explanation.Omitted.Count));
        }
    }

    [Test]
    public void Names_are_text_and_nothing_else()
    {
        Parsed page = Parsed.Ran(Hostile, 0.01, 20, Hostile, "other"), plain = Parsed.Ran("plain", 0.01, 20, "plain", "other");

        Assert.That(page.Document.QuerySelector("h1")!.TextContent, Is.EqualTo(Hostile));
        Assert.That(page.Document.Title, Is.EqualTo(Hostile));
        Assert.That(page.Data.GetProperty("bodies")[0].GetProperty("name").GetString(), Is.EqualTo(Hostile));
        Assert.That(page.Document.All.Length, Is.EqualTo(plain.Document.All.Length));
        Assert.That(page.Document.QuerySelectorAll("img"), Is.Empty);
    }

    [Test]
    public void Nothing_is_fetched()
    {
        // the plotting library knows addresses of maps; the policy keeps it, too, from asking for them
        string own = Lab.Value.Html.Replace(PageWriter.Library(), string.Empty);
        IEnumerable<string> references = Lab.Value.Document.QuerySelectorAll("[src], [href]")
            .Select(element => element.GetAttribute("src") ?? element.GetAttribute("href")!);

        Assert.That(own, Has.Length.LessThan(300_000));
        Assert.That(Address().Matches(own).Select(match => match.Value), Is.Empty);
        Assert.That(references, Is.EquivalentTo(new[] { "#replay", "data:," }));
        Assert.That(Lab.Value.Document.QuerySelector("meta[http-equiv='Content-Security-Policy']")!.GetAttribute("content"), Does.StartWith("default-src 'none';").And.Not.Contain("*"));
    }

    [Test]
    public void No_folder_of_the_machine_is_named()
    {
        Parsed page = Parsed.Ran("scene", 0.01, 10, "body");

        Assert.That(page.Html, Does.Not.Contain(Path.GetTempPath()).And.Not.Contain("刚体 lab"));
        Assert.That(page.Document.QuerySelector("code")!.TextContent, Is.EqualTo("dotnet run -c Release --project MyRigidbody.Lab -- run scene.json"));
        Assert.That(Lab.Value.Document.QuerySelector("code")!.TextContent, Is.EqualTo("dotnet run -c Release --project MyRigidbody.Lab"));
    }

    [Test]
    public void Facts_are_scene_file_steps_machine_and_version()
    {
        string facts = English(Lab.Value.Document.QuerySelector("table.facts")!);

        Assert.That(facts, Does.Contain("lab.json").And.Contain("500 of 0.02 s, 10 s in all").And.Contain(Page.Version));
        Assert.That(facts, Does.Contain($"{Environment.ProcessorCount} processors").And.Contain(".NET 10"));
    }

    /// <summary>The text of an element in one language, with a line for each cell.</summary>
    private static string English(IElement element)
    {
        IElement copy = (IElement)element.Clone();
        foreach (IElement other in copy.QuerySelectorAll("[lang=zh]").ToArray())
            other.Remove();

        return copy.TextContent.Trim();
    }

    private static IEnumerable<string> References(IDocument document, string attribute) =>
        document.QuerySelectorAll($"[{attribute}]").SelectMany(element => element.GetAttribute(attribute)!.Split(' '));

    [GeneratedRegex(@"https?://(?!www\.w3\.org/2000/svg)[^\s""']*|@import|url\(")]
    private static partial Regex Address();
}
