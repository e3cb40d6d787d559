using System.Text.RegularExpressions;
using AngleSharp.Dom;
using NUnit.Framework;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Comparison;
using RigidBodyDynamics.Lab.Languages;
using RigidBodyDynamics.Tests.Repository;

namespace RigidBodyDynamics.Tests.Report;

/// <summary>Every text of a page exists in both languages.</summary>
public sealed partial class WordsTests
{
    // formulas, numbers with their units, and names of Unity's settings are the same in all languages
    private static readonly Regex Everywhere = new(
        @"^(q \+ \[0, ½Δt ω\] q|[\d.]+ (kg m²|rad/s)|\([\d., ]+\) kg m²|drag \S+, angularDrag \S+|[A-Z]\w+)$", RegexOptions.CultureInvariant);

    private static string[] Scripts => Tree.Files("MyRigidbody.Lab/Report/Page", "*.js");

    private static string Template => Tree.Text("MyRigidbody.Lab/Report/Page/report.liquid");

    private static IEnumerable<string> Scenes => Directory.GetFiles(Gallery.Folder, "*.json").Where(path => !path.Contains("schema"));

    [Test]
    public void Every_text_is_there_in_both_languages()
    {
        foreach ((string name, Word word) in Words.All.Concat(Words.OfScripts).Where(pair => pair.Key != "language"))
        {
            Assert.That(word.En, Does.Not.Match(Chinese()), name);
            Assert.That(word.Zh, Does.Match(Chinese()), name);
            Assert.That(Places().Matches(word.Zh).Select(match => match.Value).Order(), Is.EqualTo(Places().Matches(word.En).Select(match => match.Value).Order()), name);
        }
    }

    [Test]
    public void Every_text_that_is_asked_for_is_there_and_no_other()
    {
        string[] inScripts = [.. Scripts.SelectMany(path => ScriptWord().Matches(Tree.Text(path))).Concat(DataWord().Matches(Template)).Select(match => match.Groups[1].Value)];
        string sources = string.Concat(Tree.Files("MyRigidbody.Lab/Report", "*.cs").Select(Tree.Text)) + Tree.Text("MyRigidbody.Lab/Commands/RecordingComparison.cs");
        string[] inTemplate = [.. TemplateWord().Matches(Template).Concat(SourceWord().Matches(sources)).Select(match => match.Groups[1].Value)];
        string[] sections = ["replay", "plots", "rules", "recording", "plan", "cost", "facts", "check"];

        // keys are asked for by their own names
        Assert.That(inScripts.Where(name => name != "key.").Distinct(), Is.EquivalentTo(Words.OfScripts.Keys.Where(name => !name.StartsWith("key.", StringComparison.Ordinal))));
        Assert.That(Words.OfScripts.Keys.Where(name => name.StartsWith("key.", StringComparison.Ordinal)), Is.EquivalentTo(Enum.GetNames<LabKey>().Select(key => "key." + key)));
        Assert.That(inTemplate.Concat(sections).Distinct(), Is.EquivalentTo(Words.All.Keys));
    }

    [Test]
    public void What_plans_say_is_there_in_Chinese()
    {
        List<string> left = [];
        IEnumerable<SceneDescription> gallery = Scenes.Select(path => SceneReader.Read(path).Scene);
        IEnumerable<SceneDescription> others = Scenery.Integrators.Select(name => new SceneDescription(name, string.Empty, TimeSteps.Every(0.02, 100), [Scenery.Body(name), Scenery.Busy(name, "busy").With(new QuadraticDrag(0.1)).With(new HeldKeys(new LabKeyboard())).With(new Force(Vector3d.Zero, at: Vector3d.Zero, inBody: true)).With(new Force(Vector3d.Zero, Vector3d.Zero, new Vector3d(1, 0, 0), 2, at: Vector3d.Zero))]));
        foreach (BodyPlan plan in gallery.Concat(others).SelectMany(scene => new Simulation(scene).Bodies).Select(body => body.Plan))
        {
            Explanation explanation = new(plan);
            left.AddRange(plan.Stretches.SelectMany(explanation.Parts));
            left.AddRange(plan.Stretches.Select(explanation.Time));
            left.AddRange(explanation.Omitted.SelectMany(omission => new[] { omission.What, omission.Why }));
            left.AddRange(explanation.Notes);
        }

        Assert.That(left, Has.Count.GreaterThan(100));
        Assert.That(left.Distinct().Where(IsOnlyEnglish), Is.Empty);
    }

    [Test]
    public void Every_push_of_the_library_is_called_something_in_Chinese()
    {
        string[] pushes = [.. Pushes.All().Select(test => test.Arguments[0]!).Where(push => push.GetType().IsPublic).Select(push => push.ToString()!).Distinct()];

        Assert.That(pushes, Has.Length.GreaterThan(10)); // measured 17
        Assert.That(pushes.Where(IsOnlyEnglish), Is.Empty);
    }

    [Test]
    public void Descriptions_of_integrators_are_there_in_Chinese()
    {
        string[] said = [.. Scenes.SelectMany(path => Pair.Of(SceneReader.Read(path))).SelectMany(Difference.Between).SelectMany(rule => new[] { rule.Name, rule.Mine, rule.Unitys })];

        Assert.That(said, Has.Length.GreaterThan(50));
        Assert.That(said.Distinct().Where(IsOnlyEnglish), Is.Empty);
    }

    [Test]
    public void In_a_page_each_text_stands_beside_its_translation()
    {
        IElement[] english = [.. Parsed.Compared("lab.json").Document.QuerySelectorAll("span[lang=en]")];

        Assert.That(english, Has.Length.GreaterThan(80));
        Assert.That(english.Where(span => span.NextElementSibling?.GetAttribute("lang") != "zh"), Is.Empty);
    }

    [Test]
    public void What_is_not_known_stays_as_it_is() =>
        Assert.That(Words.Phrase("wind (1, 2, 3) N"), Is.EqualTo(Word.Name("wind (1, 2, 3) N")));

    private static bool IsOnlyEnglish(string text) => !Chinese().IsMatch(Words.Phrase(text).Zh) && !Everywhere.IsMatch(text);

    [GeneratedRegex(@"\p{IsCJKUnifiedIdeographs}")]
    private static partial Regex Chinese();

    [GeneratedRegex(@"\{\d\}")]
    private static partial Regex Places();

    [GeneratedRegex(@"\bword\('([\w.]+)'")]
    private static partial Regex ScriptWord();

    [GeneratedRegex("data-word=\"([\\w.]+)\"")]
    private static partial Regex DataWord();

    [GeneratedRegex("\"([\\w.]+)\" \\| word")]
    private static partial Regex TemplateWord();

    [GeneratedRegex(@"Words\.All\[""([\w.]+)""\]")]
    private static partial Regex SourceWord();
}
