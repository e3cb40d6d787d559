using System.Text.Json;
using NUnit.Framework;
using RigidBodyDynamics.Lab;
using static RigidBodyDynamics.Lab.EffectReader;

namespace RigidBodyDynamics.Tests.Repository;

/// <summary>What docs/effects.md shows is what is compiled here, and what it says is what comes out.</summary>
public sealed class EffectsPageTests
{
    private const string Page = "docs/effects.md", Own = "tests/MyRigidbody.Tests/Repository/EffectsPageTests.cs";
    private static readonly Wind Blowing = new(0.2, new Vector3d(6, 0, 0), new Vector3d(3, 0, 1));

    private static readonly Dictionary<string, Func<Form, Func<Window, BodyDescription>>> Table = new()
    {
        // line
        ["wind"] = Push(form => form.Object("Drag against air that blows in gusts", of => new Wind(
            of["k"].Number("kg/m", least: 0),
            of["mean"].Vector("Velocity of the air, m/s, world axes"),
            of.OptionalVector("gust", "What is added to it times sin t, m/s; none if absent")))),
        // end
    };

    [Test]
    public void Wind_on_the_page_is_the_one_that_is_compiled() => Assert.That(
        Block("<!-- Wind.cs -->"), Is.EqualTo(File.ReadLines(Root.File("tests/MyRigidbody.Tests/Motions/Wind.cs")).Skip(2)));

    [Test]
    public void Wind_blows_as_the_page_says()
    {
        // in the place of the console, which other tests write to as well
        using StringWriter Console = new();
        // used
        Wind wind = new Wind(0.2, mean: new Vector3d(6, 0, 0), gust: new Vector3d(3, 0, 1));
        BodyDescription ball = new BodyDescription("ball", Solids.Sphere(0.5, 0.1))
            .With(new Gravity(new Vector3d(0, -9.81, 0)))
            .With(wind, from: 1, to: 3);
        Simulation simulation = new Simulation(TimeSteps.Every(0.02, 200), ball);
        Console.Write(new Explanation(simulation.Bodies[0]));
        foreach (string finding in EffectCheck.Findings(wind))
            Console.WriteLine(finding);
        // end
        TestContext.Out.Write(Console);

        Assert.That(Block("<!-- used -->"), Is.EqualTo(Lines("used")));
        Assert.That(Block("<!-- said -->"), Is.EqualTo(Console.ToString().TrimEnd().ReplaceLineEndings("\n").Split('\n')));
    }

    [Test]
    public void Wind_needs_nothing_but_what_is_public() => Assert.That(
        () => Outside.Program("using System;\nusing RigidBodyDynamics;\n" + string.Join('\n', Block("<!-- used -->")), "using RigidBodyDynamics;\n" + string.Join('\n', Block("<!-- Wind.cs -->"))),
        Throws.Nothing);

    [Test]
    public void Wind_is_read_from_a_scene_file_as_the_page_says()
    {
        using JsonDocument json = JsonDocument.Parse("""{ "k": 0.2, "mean": [6, 0, 0], "gust": [3, 0, 1] }""");
        Place place = new("scene", null, string.Empty, json.RootElement);
        Effect read = Table["wind"](new FilledForm(place))(new Window(new BodyDescription("ball", Solids.Sphere(0.5, 0.1)), 1, 3)).Effects[0];

        Assert.That((read.From, read.To, read.Motion.ToString()), Is.EqualTo((1.0, 3.0, Blowing.ToString())));
        Assert.That(Block("<!-- line -->"), Is.EqualTo(Lines("line")));
    }

    [Test]
    public void Body_moves_by_the_same_bits_until_the_wind_begins_and_differently_after()
    {
        Simulation calm = new(TimeSteps.Every(0.02, 200), Ball()), windy = new(TimeSteps.Every(0.02, 200), Ball().With(Blowing, 1, 3));
        for (int step = 1; step <= 60; step++)
        {
            calm.Step();
            windy.Step();
            Assert.That(windy.Bodies[0].State.Equals(calm.Bodies[0].State), Is.EqualTo(step <= 50));
        }
    }

    // the error at the end of the wind, where the step is halved
    [TestCase("Exact", 4)] // measured 4.0
    [TestCase("RungeKutta4", 16)] // measured 16
    public void Wind_keeps_the_order_of_the_integrator(string rule, double ratio)
    {
        Vector3d fine = At(rule, 0.001);
        double whole = (At(rule, 0.05) - fine).Length, half = (At(rule, 0.025) - fine).Length;
        Assert.That(whole / half, Is.EqualTo(ratio).Within(0.1 * ratio));
    }

    [Test]
    public void Table_has_every_effect_of_the_library_and_what_it_reads()
    {
        string[][] rows = [.. Between("<!-- effects -->", "<!-- end -->").Skip(2).Select(row => row.Split('|', StringSplitOptions.TrimEntries))];
        IEnumerable<string> structs = typeof(IPush).Assembly.GetTypes()
            .Where(type => type.IsValueType && typeof(IEffect).IsAssignableFrom(type))
            .Except([typeof(Nothing), typeof(Leap), typeof(Both<,>), typeof(Many), typeof(Loaded)])
            .Select(type => $"`{type.Name}`");
        string[] closed = [.. typeof(ICoast).Assembly.GetTypes().Where(type => type.IsValueType && typeof(ICoast).IsAssignableFrom(type)).Select(type => $"`{type.Name}`")];
        string[] pushes = [.. typeof(IPush).Assembly.GetTypes().Where(type => type.IsValueType && typeof(IPush).IsAssignableFrom(type)).Select(type => $"`{type.Name}`")];
        Dictionary<string, EffectTraits> traits = Pushes.All().Select(test => (IPush)test.Arguments[0]!)
            .GroupBy(push => $"`{push.GetType().Name}`")
            .ToDictionary(group => group.Key, group => group.Select(push => push.Traits).Aggregate((a, b) => a | b));

        Assert.That(rows.Select(cells => cells[1].Trim('`')).Where(name => name.Length > 0), Is.EquivalentTo(Names));
        Assert.That(rows.Select(cells => cells[2]), Is.EquivalentTo(structs));
        Assert.That(rows.Select(cells => cells[5]), Is.EqualTo(rows.Select(cells => closed.Contains(cells[2]) ? pushes.Contains(cells[2]) ? "closed form; push" : "closed form" : pushes.Contains(cells[2]) ? "push" : cells[2] == "`Impulse`" ? "at once" : "all else by the mass of its time")));
        Assert.That(rows.Select(cells => cells[6]), Is.EqualTo(rows.Select(cells => Reads(traits.GetValueOrDefault(cells[2])))));

        static string Reads(EffectTraits traits) => string.Join(", ", Enum.GetValues<EffectTraits>()
            .Where(trait => trait != 0 && traits.HasFlag(trait) && $"{trait}".StartsWith("Reads", StringComparison.Ordinal))
            .Select(trait => $"{trait}"["Reads".Length..].ToLowerInvariant()));
    }

    [Test]
    public void Page_of_scene_files_has_every_effect()
    {
        string[] rows = [.. File.ReadLines(Root.File("docs/scenes.md")).Where(line => line.StartsWith("| `\"", StringComparison.Ordinal))];
        Assert.That(Names.Where(name => !rows.Any(row => row.Contains($"`\"{name}\":", StringComparison.Ordinal))), Is.Empty);
    }

    private static BodyDescription Ball() => new BodyDescription("ball", Solids.Sphere(0.5, 0.1)).With(new Gravity(new Vector3d(0, -9.81, 0)));

    private static Vector3d At(string rule, double step)
    {
        BodyDescription ball = Ball().With(Blowing);
        ball.Rule = Rules.Named(rule);
        Simulation simulation = new(TimeSteps.Every(step), ball);
        simulation.Step((long)Math.Round(3 / step));
        return simulation.Bodies[0].State.Position;
    }

    private static string[] Block(string after) => PageText.Block(Page, after);

    /// <summary>What stands here after a comment of one word, without its indent.</summary>
    private static string[] Lines(string after)
    {
        string[] lines = [.. File.ReadLines(Root.File(Own)).SkipWhile(line => line.Trim() != "// " + after).Skip(1).TakeWhile(line => line.Trim() != "// end")];
        int indent = lines[0].Length - lines[0].TrimStart().Length;
        return [.. string.Join('\n', lines.Select(line => line.Length > indent ? line[indent..] : string.Empty)).TrimEnd().Split('\n')];
    }

    private static string[] Between(string begin, string end) =>
        [.. File.ReadLines(Root.File(Page)).SkipWhile(line => line != begin).Skip(1).TakeWhile(line => line != end)];
}
