using System.Globalization;
using NUnit.Framework;
using RigidBodyDynamics.Lab;

namespace RigidBodyDynamics.Tests.CommandLine;

/// <summary><c>run</c> writes the trajectory of a scene.</summary>
public sealed class RunTests
{
    private const string Header = "body,step,t,px,py,pz,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz,Lx,Ly,Lz,kineticEnergy,asleep";

    [Test]
    public void Every_step_of_every_body_is_a_row_after_its_start()
    {
        using TemporaryFolder folder = new();

        LabProcess lab = LabProcess.Run(folder.Path, "run", Gallery.Lab);

        string[] lines = lab.Output.Split('\n');
        Assert.That(lab.ExitCode, Is.Zero);
        Assert.That(lab.Error, Is.Empty);
        Assert.That(lab.Output, Does.Not.Contain("\r"));
        Assert.That(lines[0], Is.EqualTo(Header));
        Assert.That(lines[1], Is.EqualTo("MyRigidbody,0,0,0,0,0,1,0,0,0,0,0,0,0,0,0,0,0,0,0,0"));
        Assert.That(lines.Length, Is.EqualTo(1 + (2 * 501) + 1));
        Assert.That(lines[^1], Is.Empty);
        Assert.That(Directory.EnumerateFileSystemEntries(folder.Path), Is.Empty);
    }

    [Test]
    public void Numbers_read_back_to_the_bits_of_the_library()
    {
        using TemporaryFolder folder = new();
        string file = folder.File("轨迹 1.csv");

        LabProcess lab = LabProcess.Run(folder.Path, "run", Gallery.Lab, "--every", "100", "--out", file);

        Simulation simulation = new(SceneReader.Read(Gallery.Lab).Scene);
        string[] lines = File.ReadAllLines(file);
        int line = 1;
        for (int step = 0; step <= 500; step += 100)
        {
            foreach (Body body in simulation.Bodies)
            {
                string[] cells = lines[line++].Split(',');
                double[] read = [.. cells.Skip(3).Select(cell => double.Parse(cell, CultureInfo.InvariantCulture))];
                BodyState s = body.State;
                double[] expected =
                [
                    s.Position.X, s.Position.Y, s.Position.Z,
                    s.Orientation.W, s.Orientation.X, s.Orientation.Y, s.Orientation.Z,
                    s.Velocity.X, s.Velocity.Y, s.Velocity.Z,
                    s.AngularVelocity.X, s.AngularVelocity.Y, s.AngularVelocity.Z,
                    body.AngularMomentum.X, body.AngularMomentum.Y, body.AngularMomentum.Z,
                    body.KineticEnergy, body.IsAsleep ? 1 : 0,
                ];
                Assert.That(cells[0], Is.EqualTo(body.Name));
                Assert.That(int.Parse(cells[1], CultureInfo.InvariantCulture), Is.EqualTo(step));
                Assert.That(read, Is.EqualTo(expected));
            }

            simulation.Step(step < 500 ? 100 : 0);
        }

        Assert.That(lab.ExitCode, Is.Zero);
        Assert.That(lab.Output, Is.Empty);
        Assert.That(line, Is.EqualTo(lines.Length));
    }

    [TestCase("0", new[] { 500 })]
    [TestCase("200", new[] { 0, 200, 400, 500 })]
    [TestCase("500", new[] { 0, 500 })]
    [TestCase("501", new[] { 0, 500 })]
    [TestCase("9223372036854775807", new[] { 0, 500 })]
    public void Every_chooses_the_rows_and_never_loses_the_last(string every, int[] steps)
    {
        using TemporaryFolder folder = new();

        LabProcess lab = LabProcess.Run(folder.Path, "run", Gallery.Lab, "--every", every);

        int[] found = [.. lab.Output.Split('\n').Where(line => line.StartsWith("MyRigidbody,", StringComparison.Ordinal))
            .Select(line => int.Parse(line.Split(',')[1], CultureInfo.InvariantCulture))];
        Assert.That(found, Is.EqualTo(steps));
    }

    [Test]
    public void Integrator_and_step_of_the_command_line_win_over_the_files()
    {
        using TemporaryFolder folder = new();

        LabProcess lab = LabProcess.Run(folder.Path, "run", Gallery.Lab, "--integrator", "ExplicitEuler", "--step", "0.01", "--every", "0");

        string[] mine = lab.Output.Split('\n')[1].Split(',');
        Assert.That(mine[1], Is.EqualTo("1000"));
        Assert.That(double.Parse(mine[2], CultureInfo.InvariantCulture), Is.EqualTo(10).Within(1e-14)); // measured 0
        // both bodies now move by the same integrator and differ only in inertia and damping; neither sleeps
        Assert.That(lab.Output.Split('\n')[2], Does.EndWith(",0"));
    }

    [Test]
    public void Language_and_time_zone_of_the_machine_change_no_byte()
    {
        using TemporaryFolder folder = new();
        Dictionary<string, string> turkish = new() { ["LANG"] = "tr_TR.UTF-8", ["LC_ALL"] = "tr_TR.UTF-8", ["TZ"] = "Asia/Shanghai" };

        LabProcess here = LabProcess.Run(folder.Path, "run", Gallery.Lab, "--every", "50");
        LabProcess there = LabProcess.Run(folder.Path, turkish, ["run", Gallery.Lab, "--every", "50"]);

        Assert.That(there.Output, Is.EqualTo(here.Output));
    }

    [Test]
    public void An_integrator_that_diverges_is_reported_and_leaves_no_file()
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("stiff.json"), """
            { "schema": "rigid-body-scene/1", "name": "stiff", "about": "a spring far beyond the stable step", "step": 0.1, "steps": 2000,
              "bodies": [ { "name": "a", "integrator": "LabEuler", "position": [1, 0, 0],
                "effects": [ { "spring": { "anchor": [0, 0, 0], "at": [0, 0, 0], "stiffness": 1e6 } } ] } ] }
            """);

        LabProcess lab = LabProcess.Run(folder.Path, "run", "stiff.json", "--out", "stiff.csv");

        Assert.That(lab.ExitCode, Is.EqualTo(1));
        Assert.That(lab.Error, Does.StartWith("error: stiff.json: body a: LabEuler has diverged"));
        Assert.That(Directory.GetFiles(folder.Path), Is.EqualTo(new[] { folder.File("stiff.json") }));
    }

    [Test]
    public void A_recording_runs_as_a_scene()
    {
        using TemporaryFolder folder = new();

        LabProcess lab = LabProcess.Run(folder.Path, "run", TestData.Physx("b_torque_r.json"), "--every", "0");

        Assert.That(lab.ExitCode, Is.Zero);
        Assert.That(lab.Output.Split('\n')[1], Does.StartWith("b_torque_r,500,"));
    }
}
