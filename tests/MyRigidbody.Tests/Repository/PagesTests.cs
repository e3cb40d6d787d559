using NUnit.Framework;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.Tests.Repository;

/// <summary>The pages in docs/ show what the program reads, prints and computes.</summary>
public sealed class PagesTests
{
    [Test]
    public void Scene_on_the_page_of_the_format_is_read_and_has_what_the_page_says()
    {
        using TemporaryFolder folder = new();
        File.WriteAllLines(folder.File("thrown.json"), PageText.Block("docs/scenes.md", "<!-- scene -->"));
        SceneFile file = SceneReader.ReadWithCrowds(folder.File("thrown.json"));
        SceneDescription scene = file.Scene;

        Assert.That(scene.Steps.Count, Is.EqualTo(250));
        Assert.That(scene.Bodies.Select(body => body.Name), Is.EqualTo(new[] { "box", "ball" }));
        Assert.That(file.Crowds["ball"].Count, Is.EqualTo(1000));
        Assert.That(scene.Bodies[0].Effects.Select(effect => (effect.From, effect.To)), Is.EqualTo(new[] { (0, double.PositiveInfinity), (1, 2) }));
    }

    [Test]
    public void Error_on_the_page_of_the_format_is_what_is_said()
    {
        using TemporaryFolder folder = new();
        string scene = """{ "schema": "rigid-body-scene/1", "name": "n", "step": 1, "steps": 1, "bodies": [{ "name": "b", "mass": -1 }] }""";
        string path = folder.File("my.json");
        File.WriteAllText(path, scene);

        InputException refused = Assert.Throws<InputException>(() => SceneReader.Read(path))!;

        Assert.That(Tree.Text("docs/scenes.md"), Does.Contain("    error: " + refused.Message.Replace(path, "my.json", StringComparison.Ordinal) + "\n"));
    }

    [Test]
    public void Formulas_of_the_lab_on_its_page_are_lines_of_the_code()
    {
        string[] rows = [.. Tree.Text("docs/lab.md").Split("\n\n").First(part => part.StartsWith("| | formula", StringComparison.Ordinal)).Split('\n').Skip(2)];
        string code = Tree.Text("MyRigidbody.Core/Integrators/LabEuler.cs");

        Assert.That(rows, Has.Length.EqualTo(7));
        foreach (string row in rows)
            Assert.That(code, Does.Contain(row.Split('`')[1]));
    }

    [TestCase(7, 0.0024, 1e-4)] // q grows by sqrt(1 + (ω Δt / 2)²) − 1
    public void Quaternion_that_is_not_scaled_grows_as_the_page_says(double spin, double growth, double within)
    {
        BodyDescription cube = new("cube", Solids.Box(1, new Vector3d(1, 1, 1)))
        {
            Rule = Rules.LabEuler,
            Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, new Vector3d(spin, 0, 0)),
            Lab = new LabSettings { Normalise = false },
        };
        Simulation simulation = new(TimeSteps.Every(0.02), cube);
        simulation.Step();

        Assert.That(simulation.Bodies[0].State.Orientation.Length - 1, Is.EqualTo(growth).Within(within));
    }

    [TestCase(7, 0.0016)]
    [TestCase(20, 0.013)]
    public void Turn_of_formula_4_falls_short_as_the_pages_say(double spin, double share)
    {
        BodyDescription cube = new("cube", Solids.Box(1, new Vector3d(1, 1, 1)))
        {
            Rule = Rules.LabEuler,
            Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, new Vector3d(spin, 0, 0)),
        };
        Simulation simulation = new(TimeSteps.Every(0.02), cube);
        simulation.Step();
        double turned = Conserved.AngleBetween(Quaterniond.Identity, simulation.Bodies[0].State.Orientation);

        Assert.That(1 - turned / (0.02 * spin), Is.EqualTo(share).Within(0.05 * share));
    }
}
