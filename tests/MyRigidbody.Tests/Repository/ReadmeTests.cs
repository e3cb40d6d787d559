using System.Globalization;
using NUnit.Framework;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Comparison;
using RigidBodyDynamics.Lab.Languages;

namespace RigidBodyDynamics.Tests.Repository;

/// <summary>The README agrees with the program.</summary>
public sealed class ReadmeTests
{
    [Test]
    public void Table_of_rules_is_what_compare_finds()
    {
        SceneFile lab = SceneReader.Read(Gallery.Lab);
        RuleShares found = RuleShares.Of(Pair.Of(lab)[0], lab.Scene.Steps);
        List<string> expected = [.. found.Shares.Select(share => string.Create(
            CultureInfo.InvariantCulture,
            $"{share.Difference.Name}|{Percent(share.Distance / found.Whole.MeanDistance)}|{Percent(share.Turn / found.Whole.MeanTurn)}"))];
        expected.Add(string.Create(
            CultureInfo.InvariantCulture,
            $"all|{found.Whole.MeanDistance:F3} m|{found.Whole.MeanTurn * 180 / Math.PI:F0}°"));

        string[] rows = [.. Between("<!-- compare lab.json -->", "<!-- end -->")
            .Skip(2)
            .Select(line => line.Split('|', StringSplitOptions.TrimEntries))
            .Select(cells => $"{cells[1]}|{cells[4]}|{cells[5]}")];

        Assert.That(rows, Is.EqualTo(expected));
    }

    // the times beside them are checked by tests/MyRigidbody.Figures: no test measures time
    [TestCase("README.md")]
    [TestCase("README.zh.md")]
    public void Table_of_integrators_is_the_catalogue_and_its_errors_are_measured(string page)
    {
        ExactCase solved = ExactCase.Read("asym_moderate");
        List<string> expected = [.. Rules.All.Select(rule =>
        {
            // as run runs it: a body that coasts is not stepped
            double error = 0;
            SolvedScene.Run(
                solved,
                rule.Name,
                0.02,
                (state, sample, _) => error = sample.Time <= 100 && sample.Time % 1 == 0 ? Math.Max(error, Conserved.AngleBetween(state.Orientation, sample.Orientation)) : error,
                Omissions.All);
            return string.Create(CultureInfo.InvariantCulture, $"`{rule.Name}` | {rule.Order} | {Short(error)}");
        })];

        TestContext.Out.WriteLine(string.Join("\n", expected));
        IEnumerable<string> shown = Between(page, "<!-- figures: integrators -->", "<!-- end -->").Skip(2)
            .Select(line => line.Split('|', StringSplitOptions.TrimEntries))
            .Select(cells => $"{cells[1]} | {cells[2]} | {cells[3]}");
        Assert.That(shown, Is.EqualTo(expected));

        static string Short(double error) => error >= 0.1
            ? error.ToString("0.0", CultureInfo.InvariantCulture)
            : error.ToString("0e-0", CultureInfo.InvariantCulture);
    }

    [Test]
    public void Example_of_the_library_compiles_and_moves_the_cube()
    {
        // begin
        BodyDescription cube = new BodyDescription("cube", Solids.Box(1, new Vector3d(1, 2, 3)))
            .With(new Gravity(new Vector3d(0, -9.81, 0)))
            .With(new Torque(Vector3d.Zero, new Vector3d(1, 1, 1), Vector3d.Zero, 1, inBody: false), from: 0, to: 3);
        Simulation simulation = new Simulation(TimeSteps.Every(0.02));
        Body body = simulation.Add(cube);
        for (int step = 0; step < 500; step++)
        {
            if (step < 50)
                body.ApplyForce(new Vector3d(5, 0, 0));

            simulation.Step();
        }

        Console.WriteLine(body.State.Position);
        // end
        string own = File.ReadAllText(Root.File("tests/MyRigidbody.Tests/Repository/ReadmeTests.cs"));
        string example = own[(own.IndexOf("// begin\n", StringComparison.Ordinal) + 9)..own.IndexOf("        // end\n", StringComparison.Ordinal)];
        string[] lines = [.. example.TrimEnd().Split('\n').Select(line => line.Length > 8 ? line[8..] : line)];

        Assert.That(Between("```csharp", "```"), Is.EqualTo(lines));
        // x: 5 m/s² for the first second, then 5 m/s for nine; y: −9.81 · 10² / 2 m
        Assert.That(body.State.Position.X, Is.EqualTo(2.5 + 9 * 5).Within(2e-12)); // measured 4.0e-13
        Assert.That(body.State.Position.Y, Is.EqualTo(-490.5).Within(2e-12)); // measured 2.8e-13
    }

    [TestCase("README.md", ", ")]
    [TestCase("README.zh.md", "，")]
    public void Table_of_what_is_simulated_is_what_explain_says(string page, string comma)
    {
        Func<Word, string> language = word => page == "README.md" ? word.En : word.Zh;
        IEnumerable<string> rows = new[] { "lab.json", "tumbling-slab.json", "fall-with-drag.json" }
            .SelectMany(scene => new Simulation(SceneReader.Read(Path.Combine(Gallery.Folder, scene)).Scene).Bodies.Select(body =>
            {
                Explanation explained = new(body.Plan);
                StretchPlan first = body.Plan.Stretches[0];
                string parts = string.Join(comma, explained.Parts(first).Select(Words.Phrase).Select(language));
                string left = string.Join(comma, explained.Omitted.Select(omission => omission.What).Distinct().Select(Words.Phrase).Select(language));
                return $"| {scene} | {body.Name} | {parts} | {left} |";
            }));

        TestContext.Out.WriteLine(string.Join("\n", rows));
        Assert.That(Between(page, "<!-- explain -->", "<!-- end -->").Skip(2), Is.EqualTo(rows));
    }

    [Test]
    public void Chinese_page_has_the_numbers_the_pictures_and_the_commands_of_the_English_one()
    {
        Assert.That(Shares("README.zh.md"), Is.EqualTo(Shares("README.md")));
        foreach (string table in new[] { "<!-- figures: engines -->", "<!-- figures: runtimes -->", "```csharp" })
            Assert.That(Between("README.zh.md", table, End(table)).Skip(2), Is.EqualTo(Between("README.md", table, End(table)).Skip(2).Select(Figures.Tables.InChinese)).And.Not.Empty);

        Assert.That(Named("README.zh.md"), Is.EqualTo(Named("README.md")));
        Assert.That(Starting("README.md", "    dotnet"), Is.SupersetOf(Starting("README.zh.md", "    dotnet")));
        // of the scene with the panel there is one in each language
        Assert.That(Pictures("README.md"), Is.SupersetOf(Pictures("README.zh.md").Select(picture => picture.Replace(".zh.png", ".png", StringComparison.Ordinal))));

        static string End(string table) => table[0] == '<' ? "<!-- end -->" : "```";
        static string[] Shares(string page) => [.. Between(page, "<!-- compare lab.json -->", "<!-- end -->").Skip(2)
            .Select(line => line.Split('|', StringSplitOptions.TrimEntries))
            .Select(cells => cells[4] + cells[5])];
        // integrators and commands
        static string[] Named(string page) => [.. Starting(page, "| `").Select(line => line.Split(" | ")[0])];
        static string[] Starting(string page, string with) => [.. Tree.Text(page).Split('\n').Where(line => line.StartsWith(with, StringComparison.Ordinal))];
        static string[] Pictures(string page) => [.. Starting(page, "![").Select(line => line[line.IndexOf('(')..])];
    }

    private static string Percent(double share)
    {
        string percent = (100 * share).ToString("F1", CultureInfo.InvariantCulture).Replace('-', '−');
        return (percent == "−0.0" ? "0.0" : percent) + " %";
    }

    private static string[] Between(string begin, string end) => Between("README.md", begin, end);

    private static string[] Between(string page, string begin, string end) =>
        [.. File.ReadAllLines(Root.File(page)).SkipWhile(line => line != begin).Skip(1).TakeWhile(line => line != end)];
}
