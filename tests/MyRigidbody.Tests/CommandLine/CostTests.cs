using System.Globalization;
using NUnit.Framework;
using RigidBodyDynamics.Lab;

namespace RigidBodyDynamics.Tests.CommandLine;

/// <summary><c>cost</c>: accuracy against time.</summary>
public sealed class CostTests
{
    private const string Header =
        "scene,integrator,order,step,steps,angleError,positionError,energyDrift,momentumDrift,nanosecondsPerStep,secondsPerSimulatedSecond";

    [Test]
    public void Quick_finishes_every_row_of_the_catalogue_in_eight_steps_or_more()
    {
        using TemporaryFolder folder = new();

        LabProcess lab = LabProcess.Run(folder.Path, "cost", "--quick");

        Assert.That(lab.ExitCode, Is.Zero, lab.Error);
        string csv = File.ReadAllText(folder.File("out/cost.csv"));
        string[] lines = csv.TrimEnd('\n').Split('\n');
        string[][] cells = [.. lines.Skip(1).Select(line => line.Split(','))];
        Assert.That(lines[0], Is.EqualTo(Header));
        Assert.That(csv, Does.Not.Contain("NaN").And.Not.Contain("\r"));
        Assert.That(cells.Select(row => row[0]).Distinct(), Does.Contain("asym_moderate").And.Contain("lab"));
        foreach (string scene in cells.Select(row => row[0]).Distinct())
        {
            foreach (Rule row in Rules.All)
                Assert.That(cells.Count(cell => cell[0] == scene && cell[1] == row.Name), Is.GreaterThanOrEqualTo(8), scene + " " + row.Name);

            string name = folder.File("out/cost-" + scene);
            Assert.That(File.ReadAllBytes(name + ".png").Take(4), Is.EqualTo(new byte[] { 0x89, (byte)'P', (byte)'N', (byte)'G' }));
            Assert.That(File.ReadAllText(name + ".svg"), Does.Contain("<svg").And.Contain("</svg>"));
        }

        Assert.That(Rules.All.Select(row => row.Name).All(lab.Output.Contains), Is.True);
        Assert.That(Tables(lab.Output).Max(line => line.Length), Is.LessThanOrEqualTo(80));
    }

    [Test]
    public void Errors_are_those_of_a_run_and_costs_are_steps_times_their_time()
    {
        using TemporaryFolder folder = new();

        LabProcess lab = LabProcess.Run(folder.Path, "cost", Scene("fall-with-drag.json"), Scene("fall-with-drag.json"), "--quick", "--out", "结果");

        Assert.That(lab.ExitCode, Is.Zero, lab.Error);
        Assert.That(lab.Output, Does.Contain("our own").And.Contain("uncertainty"));
        Assert.That(
            Directory.GetFiles(folder.File("结果"), "*.png").Select(Path.GetFileName),
            Is.EquivalentTo(new[] { "cost-fall-with-drag.png", "cost-fall-with-drag-2.png" }));
        foreach (string line in File.ReadLines(folder.File("结果/cost.csv")).Skip(1))
        {
            double[] n = [.. line.Split(',').Skip(2).Select(cell => double.Parse(cell, CultureInfo.InvariantCulture))];
            Assert.That(n[8], Is.EqualTo(1e-9 * n[7] / n[1]).Within(1e-12 * n[8])); // measured 0
            Assert.That(n.Skip(3).Take(4), Is.All.GreaterThanOrEqualTo(0));
        }
    }

    [TestCase("needle")]
    [TestCase("lagrange_top")]
    public void Solved_motion_starts_where_its_inputs_say_and_meets_its_samples(string name)
    {
        CostMotion motion = SolvedMotion.Read(name, 10);
        ExactCase exact = ExactCase.Read(name);
        BodyDescription body = motion.Scene.Bodies[0];

        ExactCase.Sample start = exact.Samples[0];
        Assert.That((body.Start.AngularVelocity - start.AngularVelocity).Length, Is.LessThan(2e-15 * start.AngularVelocity.Length)); // measured 2.5e-16 of it
        Assert.That(motion.Truth.Samples.Count, Is.GreaterThanOrEqualTo(10));
        foreach (TruthSample sample in motion.Truth.Samples)
        {
            ExactCase.Sample same = exact.Samples.Single(other => Math.Abs(other.Time - (sample.At * motion.Truth.BaseStep)) < 1e-9);
            Assert.That(sample.Bodies[0].Orientation, Is.EqualTo(same.Orientation));
            Assert.That(sample.Bodies[0].AngularVelocity, Is.EqualTo(same.AngularVelocity));
        }
    }

    [Test]
    public void Every_motion_that_is_measured_can_be_read() => Assert.That(
        SolvedMotion.All.Select(motion => SolvedMotion.Read(motion.Name, motion.Until).Truth.Samples.Count),
        Is.All.GreaterThanOrEqualTo(4));

    private static string Scene(string file) => Path.Combine(Gallery.Folder, file);

    private static IEnumerable<string> Tables(string output) => output.Split('\n').Where(line => line.StartsWith('│'));
}
