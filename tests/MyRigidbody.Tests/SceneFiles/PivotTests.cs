using NUnit.Framework;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.Tests.SceneFiles;

/// <summary>
/// A rod of 1 kg and 1 m on a pin at its end, released 10° from hanging. About the pin it has m l²/3, about its middle m l²/12: with the
/// wrong one its period is halved.
/// </summary>
public sealed class PivotTests
{
    private const string Solid = "\"inertia\": { \"solidBox\": [0.00001, 1, 0.00001] }", Middle = "\"centerOfMass\": [0, -0.5, 0]";
    private const string OfPin = "\"inertia\": { \"principal\": [0.3333333333333333, 1e-7, 0.3333333333333333] }";
    private const string OfMiddle = "\"inertia\": { \"principal\": [0.08333333333333333, 1e-7, 0.08333333333333333] }";

    [TestCase(Solid + ", " + Middle, "")]
    [TestCase(Solid + ", " + Middle, "\"centerOfMass\"")]
    [TestCase(OfMiddle + ", " + Middle, "")]
    [TestCase(OfMiddle + ", " + Middle, "\"centerOfMass\"")]
    [TestCase(OfMiddle + ", \"about\": \"centerOfMass\", " + Middle, "")]
    [TestCase(OfPin, "")]
    [TestCase(OfPin, "\"pivot\"")]
    [TestCase(OfPin + ", " + Middle, "\"pivot\"")]
    [TestCase(OfPin + ", \"about\": \"origin\", " + Middle, "")]
    [TestCase(OfPin + ", \"about\": \"origin\", " + Middle, "\"pivot\"")]
    [TestCase("\"inertia\": { \"compound\": [{ \"inertia\": { \"solidBox\": [0.00001, 1, 0.00001] }, \"position\": [0, -0.5, 0] }] }", "")]
    public void However_it_is_given_the_rod_swings_in_its_own_time(string rod, string point)
    {
        SceneFile file = SceneText.Read(Pendulum(rod, point));
        Simulation simulation = new(file.Scene);
        Body body = simulation.Bodies[0];

        // from the first to the third time that it hangs straight down
        double[] down = new double[3];
        int found = 0;
        for (double before = Sine(body); found < 3;)
        {
            simulation.Step();
            double now = Sine(body);
            if (before * now < 0)
                down[found++] = 0.002 * (simulation.StepsDone - 1 + before / (before - now));
            before = now;
        }

        // T = 2π √(I / m g l) / AGM(1, cos(θ₀ / 2)), Gauss's form of the elliptic integral
        double a = 1, b = Math.Cos(Math.PI / 36);
        for (int i = 0; i < 6; i++)
            (a, b) = ((a + b) / 2, Math.Sqrt(a * b));
        double period = 2 * Math.PI * Math.Sqrt(1.0 / 3 / 4.905) / a;
        Assert.That(period, Is.EqualTo(1.64107046).Within(5e-9)); // measured 1.8e-9
        Assert.That(down[2] - down[0], Is.EqualTo(period).Within(1e-7)); // measured 3.2e-9, the straight line between two steps
        Assert.That(body.State.Position.Length, Is.Zero);

        static double Sine(Body body) => body.State.Orientation.Z * body.State.Orientation.W;
    }

    [TestCase(Solid, "", "heavyTop: solidBox is about its centre of mass, and nothing says how far that is from the pivot")]
    [TestCase(Solid, "\"centerOfMass\"", "heavyTop: solidBox is about its centre of mass, and nothing says how far that is from the pivot")]
    [TestCase(OfPin, "\"centerOfMass\"", "heavyTop: principal is about its centre of mass, and nothing says how far that is from the pivot")]
    [TestCase(OfMiddle + ", \"about\": \"centerOfMass\"", "", "heavyTop: principal is about its centre of mass, and nothing says how far that is from the pivot")]
    [TestCase(Solid + ", " + Middle, "\"pivot\"", "heavyTop.inertiaAbout: must not be the pivot: solidBox is about its centre of mass, which centerOfMass puts elsewhere, at (0, -0.5, 0)")]
    [TestCase(OfPin + ", \"about\": \"origin\", " + Middle, "\"centerOfMass\"", "heavyTop.inertiaAbout: must be \"pivot\", since about is \"origin\"")]
    [TestCase(Solid + ", \"centerOfMass\": [0, 0.5, 0]", "", "heavyTop.axis: must be along centerOfMass (0, 0.5, 0), from the pivot, which is the body's origin, found [0, -1, 0]")]
    [TestCase(Solid + ", \"centerOfMass\": [0.1, -0.5, 0]", "", "heavyTop.axis: must be along centerOfMass (0.1, -0.5, 0)")]
    [TestCase(Solid, "\"origin\"", "heavyTop.inertiaAbout: must be one of \"pivot\", \"centerOfMass\", found \"origin\"")]
    public void What_does_not_say_its_point_is_refused(string rod, string point, string expected) =>
        Assert.That(SceneText.Error(Pendulum(rod, point)), Does.StartWith("scene.json: bodies[0].effects[0]." + expected));

    [TestCase(OfPin, "", "takes principal (0.3333333333333333, 1E-07, 0.3333333333333333) kg m² as about the pivot")]
    [TestCase(Solid + ", " + Middle, "", "takes the inertia about the centre of mass (0, -0.5, 0) to the pivot")]
    [TestCase(OfPin, "\"pivot\"", null)]
    [TestCase(Solid + ", " + Middle, "\"centerOfMass\"", null)]
    public void What_is_taken_for_granted_is_said(string rod, string point, string? note)
    {
        SceneFile file = SceneText.Read(Pendulum(rod, point));

        Assert.That(file.Notes.GetValueOrDefault("rod", []), note == null ? NUnit.Framework.Is.Empty : Has.One.Contains(note));
    }

    [TestCase("", "")]
    [TestCase(", \"inertiaAbout\": \"pivot\"", "")]
    [TestCase(", \"inertiaAbout\": \"centerOfMass\"", "scene.json: bodies[0].effects[1].heavyTop.inertiaAbout: must be \"pivot\" as in the body's other heavy top, found \"centerOfMass\"")]
    public void Tops_of_one_body_have_one_point(string second, string expected)
    {
        string more = """{ "heavyTop": { "axis": [0, -1, 0], "moment": 1, "up": [0, 1, 0]""" + second + " } }";

        string text = Pendulum(OfPin, "\"pivot\"");
        string error = SceneText.Error(text.Replace(" ] } ] }", ", " + more + " ] } ] }", StringComparison.Ordinal));

        Assert.That(error, expected.Length == 0 ? NUnit.Framework.Is.Empty : Does.StartWith(expected));
    }

    [Test]
    public void Box_of_vertices_takes_its_solid_box_to_the_pivot_too()
    {
        SceneFile file = SceneText.Read(Pendulum("\"inertia\": { \"boxVertices\": [0.1, 1, 0.1] }, " + Middle, ""));

        // 1/4 (1 + 0.01) and 1/12 (1 + 0.01), each and 1/4 more
        Assert.That(file.Scene.Bodies[0].Mass.PrincipalMoments.X, Is.EqualTo(1.01 / 4 + 0.25).Within(1e-16)); // measured 0
        Assert.That(file.SolidBoxes["rod"].PrincipalMoments.X, Is.EqualTo(1.01 / 12 + 0.25).Within(1e-16)); // measured 0
    }

    [Test]
    public void Held_at_the_origin_a_body_weighs_as_its_points_do_about_it()
    {
        Vector3d[] points = [new(1, 0, 0.2), new(-0.5, 1, 0), new(0, -0.7, 1.5), new(0.3, 0.3, -1)];
        MassProperties held = PointMasses.Equal(4, points).HeldAtOrigin();
        double[,] expected = new double[3, 3];
        foreach (Vector3d p in points)
        {
            double[] r = [p.X, p.Y, p.Z];
            for (int i = 0; i < 9; i++)
                expected[i / 3, i % 3] += (i % 4 == 0 ? p.LengthSquared : 0) - r[i / 3] * r[i % 3];
        }

        Assert.That(held.CenterOfMass, Is.EqualTo(Vector3d.Zero));
        Assert.That(FullMatrix.Apart(FullMatrix.Of(held.Inertia), expected), Is.LessThan(1e-14)); // measured 8.9e-16
        Assert.That(FullMatrix.Apart(FullMatrix.Tensor(held.PrincipalMoments, held.PrincipalFrame), expected), Is.LessThan(1e-14)); // measured 1.8e-15
    }

    [Test]
    public void Command_line_refuses_the_rod_without_a_point_in_one_line()
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("rod.json"), Pendulum(Solid, ""));

        LabProcess run = LabProcess.Run(folder.Path, "run", "rod.json");

        Assert.That(run.ExitCode, Is.EqualTo(2));
        Assert.That(run.Error, Does.StartWith("error: rod.json: bodies[0].effects[0].heavyTop: solidBox is about its centre of mass").And.Contain("give centerOfMass").And.Contain("\"inertiaAbout\": \"pivot\""));
    }

    private static string Pendulum(string rod, string point) => $$"""
        { "schema": "rigid-body-scene/1", "name": "pendulum", "step": 0.002, "duration": 4, "bodies": [
          { "name": "rod", "integrator": "Exact6", "mass": 1, {{rod}}, "orientation": [0.9961946980917455, 0, 0, 0.08715574274765817],
            "effects": [ { "heavyTop": { "axis": [0, -1, 0], "moment": 4.905, "up": [0, 1, 0]{{(point.Length > 0 ? ", \"inertiaAbout\": " + point : string.Empty)}} } } ] } ] }
        """.Replace("\"mass\": 1, \"inertia\": { \"compound\"", "\"inertia\": { \"compound\"", StringComparison.Ordinal);
}
