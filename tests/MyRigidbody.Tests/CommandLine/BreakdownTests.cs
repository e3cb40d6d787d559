using NUnit.Framework;

namespace RigidBodyDynamics.Tests.CommandLine;

/// <summary>Failures while a scene runs: one line that names file and place, one exit code, no infinity in a table.</summary>
public sealed class BreakdownTests
{
    private static readonly string[][] Ways = [["run"], ["run", "--every", "0"], ["run", "--every", "7"], ["run", "--every", "1000"], ["compare"]];

    [TestCaseSource(nameof(Ways))]
    public void Effect_that_breaks_is_named_by_its_place_in_the_file(string[] command)
    {
        // the drag of the second body overflows as soon as it is asked
        Refused(command, """
            { "schema": "rigid-body-scene/1", "name": "n", "step": 0.02, "steps": 100, "bodies": [ { "name": "a" },
              { "name": "b", "integrator": "LabEuler", "velocity": [1e30, 0, 0], "effects": [ { "gravity": [0, -9.81, 0] }, { "quadraticDrag": 1e300, "from": 1 } ] } ] }
            """, 2, "error: s.json: bodies[1].effects[1]: must push with a finite force and torque, and did not at t = 1 s, in step 50");
    }

    [TestCaseSource(nameof(Ways))]
    public void Integrator_that_diverges_falls_short_whatever_is_written(string[] command)
    {
        Refused(command, """
            { "schema": "rigid-body-scene/1", "name": "n", "step": 0.1, "steps": 2000, "bodies": [ { "name": "a" },
              { "name": "b", "integrator": "LabEuler", "position": [1, 0, 0], "effects": [ { "spring": { "anchor": [0, 0, 0], "at": [0, 0, 0], "stiffness": 1e6 } } ] } ] }
            """, 1, "error: s.json: body b");
    }

    [TestCaseSource(nameof(Ways))]
    public void Torque_that_begins_in_a_dormant_body_and_overflows_ends(string[] command)
    {
        Refused(command, """
            { "schema": "rigid-body-scene/1", "name": "n", "step": 1, "steps": 6, "bodies": [ { "name": "b",
              "effects": [ { "torque": { "frame": "body", "constant": [0, 0, 1e300] }, "from": 1 } ] } ] }
            """, 1, command[0] == "run" ? "error: s.json: body b: Exact has diverged: no finite state at t = 2 s, after step 1, under effects[0] (torque " : "error: s.json: body ");
    }

    [TestCase("[1e200, 0, 0]", "error: s.json: bodies[0].velocity: must leave a finite kinetic energy, found ")]
    [TestCase("[1e160, 0, 0]", "error: s.json: bodies[0].velocity: must leave a finite kinetic energy, found ")]
    public void Start_without_a_finite_energy_is_refused(string velocity, string expected)
    {
        foreach (string count in new[] { "\"count\": 1,", "\"count\": 3,", string.Empty })
        {
            foreach (string[] command in Ways.Where(way => way[0] == "run" || count.Length == 0))
            {
                Refused(command, $$"""
                    { "schema": "rigid-body-scene/1", "name": "n", "step": 0.02, "steps": 10, "bodies": [ { "name": "b", {{count}} "velocity": {{velocity}} } ] }
                    """, 2, expected);
            }
        }
    }

    [Test]
    public void Spread_without_a_finite_energy_is_refused() => Refused(["run"], """
        { "schema": "rigid-body-scene/1", "name": "n", "step": 0.02, "steps": 10, "bodies": [ { "name": "b", "count": 3, "spread": { "velocity": [1e200, 0, 0] } } ] }
        """, 2, "error: s.json: velocity: must leave a finite kinetic energy");

    [TestCase("--every", "1")]
    [TestCase("--every", "0")]
    public void Body_of_a_crowd_that_diverges_is_named_by_its_number(string option, string value) => Refused(["run", option, value], """
        { "schema": "rigid-body-scene/1", "name": "n", "step": 0.1, "steps": 2000, "bodies": [
          { "name": "b", "count": 3, "integrator": "LabEuler", "position": [1, 0, 0], "effects": [ { "spring": { "anchor": [0, 0, 0], "at": [0, 0, 0], "stiffness": 1e6 } } ] } ] }
        """, 1, "error: s.json: body b 0: LabEuler has diverged: no finite state at t = ");

    [Test]
    public void Distance_beyond_all_numbers_is_no_cell_of_a_table() => Refused(["compare"], """
        { "schema": "rigid-body-scene/1", "name": "n", "step": 1e9, "steps": 1000, "bodies": [
          { "name": "b", "velocity": [1e150, 0, 0], "effects": [ { "linearDamping": 1 } ] } ] }
        """, 2, "error: s.json: ");

    [Test]
    public void Name_that_a_body_of_a_crowd_has_is_refused()
    {
        const string Scene = """
            { "schema": "rigid-body-scene/1", "name": "n", "step": 0.02, "steps": 1, "bodies": [ { "name": "b 0" }, { "name": "b", "count": COUNT }, { "name": "b 00" }, { "name": "b 1 " } ] }
            """;
        Refused(["run"], Scene.Replace("COUNT", "2"), 2, "error: s.json: bodies: name: must be unique in the scene, found \"b 0\" again among those of \"b\"");
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("s.json"), Scene.Replace("b 0\"", "b 2\"").Replace("COUNT", "2"));
        LabProcess run = LabProcess.Run(folder.Path, "run", "s.json", "--every", "0");
        Assert.That(run.ExitCode, Is.Zero, run.Error);
    }

    [TestCase("9223372036854775807")]
    [TestCase("1000000000000000000")]
    public void As_many_steps_as_there_are_may_be_coasted(string steps)
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("s.json"), $$"""
            { "schema": "rigid-body-scene/1", "name": "n", "step": 0.02, "steps": {{steps}}, "bodies": [ { "name": "a", "velocity": [1, 0, 0] }, { "name": "b", "count": 2 } ] }
            """);
        LabProcess run = LabProcess.Run(folder.Path, "run", "s.json", "--every", "0");
        Assert.That(run.ExitCode, Is.Zero, run.Error);
        Assert.That(run.Output.Split('\n')[1], Does.StartWith($"a,{steps},"));
    }

    [Test]
    public void Steps_that_would_take_years_are_refused_and_nothing_is_written()
    {
        using TemporaryFolder folder = new();
        LabProcess run = LabProcess.Run(folder.Path, "run", Repository.Root.File("scenes/lab.json"), "--step", "1e-17", "--every", "0", "--out", "a.csv");
        Assert.That(run.ExitCode, Is.EqualTo(2));
        Assert.That(run.Error, Does.Match("^error: .*lab\\.json: steps: [0-9]+ of them would take [0-9.e+]+ years here\n$"));
        Assert.That(Directory.GetFiles(folder.Path), Is.Empty);
    }

    private static void Refused(string[] command, string scene, int exitCode, string error)
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("s.json"), scene);
        LabProcess lab = LabProcess.Run(folder.Path, [command[0], "s.json", .. command[1..]]);
        Assert.That(lab.Error, Does.StartWith(error));
        Assert.That(lab.Error.TrimEnd().Split('\n'), Has.Length.EqualTo(1));
        Assert.That(lab.ExitCode, Is.EqualTo(exitCode));
        Assert.That(lab.Output, Does.Not.Contain("Infinity").And.Not.Contain("NaN").And.Not.Contain("∞"));
    }
}
