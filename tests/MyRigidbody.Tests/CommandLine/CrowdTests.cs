using System.Globalization;
using NUnit.Framework;
using RigidBodyDynamics.Lab;

namespace RigidBodyDynamics.Tests.CommandLine;

/// <summary>Bodies with a count, from the scene file to the trajectory.</summary>
public sealed class CrowdTests
{
    private const string Dust = """
        { "schema": "rigid-body-scene/1", "name": "dust", "step": 0.02, "steps": 50, "bodies": [
          { "name": "stone" },
          { "name": "dust", "count": 5, "seed": 3, "inertia": { "principal": [1, 2, 2.5] }, "velocity": [1, 0, 0], "angularVelocity": [0, 1, 0],
            "spread": { "position": [10, 0, 10], "velocity": [0.5, 0.5, 0.5], "angularVelocity": [1, 1, 1], "orientation": 3 },
            "effects": [ { "gravity": [0, -9.81, 0] }, { "key": "R", "from": 0.2, "to": 0.4 } ] } ] }
        """;

    [Test]
    public void Each_of_many_moves_as_it_would_alone()
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("dust.json"), Dust);
        LabProcess run = LabProcess.Run(folder.Path, "run", "dust.json", "--every", "0");
        Assert.That(run.ExitCode, Is.Zero, run.Error);
        string[][] rows = [.. run.Output.Split('\n', StringSplitOptions.RemoveEmptyEntries).Skip(1).Select(line => line.Split(','))];
        Assert.That(rows.Select(row => row[0]), Is.EqualTo(new[] { "stone", "dust 0", "dust 1", "dust 2", "dust 3", "dust 4" }));

        Spread spread = new()
        {
            Seed = 3,
            Position = new Vector3d(10, 0, 10),
            Velocity = new Vector3d(0.5, 0.5, 0.5),
            AngularVelocity = new Vector3d(1, 1, 1),
            Orientation = 3,
        };
        for (int i = 0; i < 5; i++)
        {
            BodyDescription alone = new BodyDescription("alone", MassProperties.FromPrincipal(1, new Vector3d(1, 2, 2.5)))
                .With(new Gravity(new Vector3d(0, -9.81, 0))).With(new KeyPush(LabKey.R), 0.2, 0.4);
            BodyState middle = new(Vector3d.Zero, Quaterniond.Identity, new Vector3d(1, 0, 0), new Vector3d(0, 1, 0));
            alone.Start = spread.Of(middle, i);
            BodyState end = Scenery.Run(TimeSteps.Every(0.02, 50), alone, 50);
            double[] found = [.. rows[i + 1].Skip(3).Take(13).Select(cell => double.Parse(cell, CultureInfo.InvariantCulture))];
            Assert.That(found, Is.EqualTo(new[]
            {
                end.Position.X, end.Position.Y, end.Position.Z, end.Orientation.W, end.Orientation.X, end.Orientation.Y, end.Orientation.Z,
                end.Velocity.X, end.Velocity.Y, end.Velocity.Z, end.AngularVelocity.X, end.AngularVelocity.Y, end.AngularVelocity.Z,
            }));
        }
    }

    [Test]
    public void Explanation_says_how_many_there_are()
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("dust.json"), Dust);
        LabProcess run = LabProcess.Run(folder.Path, "explain", "dust.json");
        Assert.That(run.ExitCode, Is.Zero, run.Error);
        Assert.That(run.Output, Does.Contain("dust (5 bodies, together), by Exact\n"));
    }

    [TestCase("compare")]
    [TestCase("choose --error 1e-3")]
    [TestCase("cost --quick")]
    public void Commands_that_take_bodies_one_by_one_say_so(string command)
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("dust.json"), Dust);
        string[] words = command.Split(' ');
        LabProcess run = LabProcess.Run(folder.Path, [words[0], "dust.json", .. words.Skip(1)]);
        Assert.That(run.ExitCode, Is.EqualTo(2));
        Assert.That(run.Error, Is.EqualTo("error: dust.json: bodies: only run and explain take a count, and \"dust\" has one\n"));
    }

    [Test]
    public void Starts_are_spread_evenly_and_the_same_for_the_same_seed()
    {
        Spread spread = new() { Position = new Vector3d(2, 0, 0), Velocity = new Vector3d(0, 1, 0), Orientation = 0.5, Seed = 11 };
        BodyState[] starts = [.. Enumerable.Range(0, 10_000).Select(i => spread.Of(BodyState.AtRest, i))];
        double[] x = [.. starts.Select(start => start.Position.X)], v = [.. starts.Select(start => start.Velocity.Y)];
        // of evenly spread numbers from −a to a the mean is 0 ± a/√3N, the mean square a²/3
        Assert.That(x.Average(), Is.EqualTo(0).Within(4 * 2 / Math.Sqrt(3e4)));
        Assert.That(x.Average(a => a * a), Is.EqualTo(4.0 / 3).Within(0.05));
        Assert.That(x.Zip(v, (a, b) => a * b).Average(), Is.EqualTo(0).Within(0.05));
        Assert.That(x.Max(), Is.LessThanOrEqualTo(2).And.GreaterThan(1.99));
        Assert.That(starts.Max(start => Conserved.AngleBetween(start.Orientation, Quaterniond.Identity)), Is.LessThanOrEqualTo(0.5).And.GreaterThan(0.49));
        Assert.That(starts[7], Is.EqualTo(spread.Of(BodyState.AtRest, 7)));
        Assert.That(starts.Distinct().Count(), Is.EqualTo(starts.Length));
        spread.Seed = 12;
        Assert.That(spread.Of(BodyState.AtRest, 7), Is.Not.EqualTo(starts[7]));
    }
}
