using NUnit.Framework;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Bench;

namespace RigidBodyDynamics.Tests.CommandLine;

/// <summary>The measurements that bench compares exist. That it runs is a check of .ci/run: no test measures time.</summary>
public sealed class BenchTests
{
    [Test]
    public void Step_written_by_hand_comes_to_the_bits_of_the_library_s()
    {
        Vector3d gravity = new(0, -9.81, 0), force = new(5, 0, 0);
        BodyDescription cube = new BodyDescription("cube", MassProperties.FromPrincipal(1, new Vector3d(0.5, 0.5, 0.5)))
        {
            Rule = Rules.LabEuler,
            Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(1, 2, 3), new Vector3d(1, 1.1, 0.9)),
        }.With(new Gravity(gravity)).With(new DecayPerStep(0.98, 0.98)).With(new Force(force)).With(new KeyPush(LabKey.R));
        HandWritten byHand = new(cube.Start, cube.Mass, force, gravity, 0.98, 0.02);
        byHand.Step(0, 500);
        Assert.That(byHand.State, Is.EqualTo(Scenery.Run(TimeSteps.Every(0.02), cube, 500)));
    }

    [Test]
    public void Every_ratio_is_of_things_that_are_measured()
    {
        // an unknown name would silently leave out a ratio
        string[] measured = [.. new[] { Suite.ByRule(), Suite.ByHand(), Suite.Torques(), Suite.Effects(), Suite.Shapes(), Suite.Denormals(), Suite.Many(1000), LivingSuite.Calls() }
            .SelectMany(group => group).Select(measurement => measurement.What)];
        Assert.That(Ratios.Names.Where(name => !measured.Contains(name)), Is.Empty);
        Assert.That(Ratios.Names.Count(), Is.GreaterThan(20));
    }

    [Test]
    public void Run_is_quiet_while_no_more_than_one_measurement_in_twenty_differs_from_itself()
    {
        (string, double)[] steady = [.. Enumerable.Range(0, 38).Select(i => ("steady " + i, 1.019))];

        Assert.That(
            Ratios.Quiet([.. steady, ("fast", 0.9), ("slow", 1.3)]),
            Is.EqualTo("measurements to themselves: 38 of 40 within 2 %, the worst 30.0 % apart, slow; the machine was quiet"));
        Assert.That(Ratios.Quiet([.. steady, ("fast", 0.9), ("slow", 1.3), ("slower", 1.021)]), Does.Contain("38 of 41 within 2 %").And.Contain("THE RUN IS NOISY"));
    }

    [Test]
    public void Every_second_repeat_is_held_against_those_between()
    {
        int calls = 0;
        Measurement uneven = new("uneven", 1, 1, () => _ => Thread.SpinWait(calls++ % 2 == 0 ? 1000 : 100_000));
        Measurement.Take([uneven], 6, 1e-4, _ => { });

        Assert.That(uneven.RatioToItself, Is.GreaterThan(5).Or.LessThan(0.2));
    }

    [Test]
    public void One_of_many_is_read_pushed_set_removed_and_brought_back_again_and_again()
    {
        foreach (Measurement one in LivingSuite.OneOf(100))
            Assert.That(() => one.Make()(1000), Throws.Nothing, one.What);
    }

    [Test]
    public void Measurement_gives_median_spread_and_allocation()
    {
        Measurement quiet = new("quiet", 10, 1, () => count => Thread.SpinWait((int)Math.Min(count, 100)));
        Measurement loud = new("loud", 10, 1, () => count => GC.KeepAlive(new byte[1000 * Math.Min(count, 100)]));
        Measurement.Take([quiet, loud], 3, 1e-4, _ => { });
        Assert.That(quiet.Median, Is.GreaterThan(0));
        Assert.That(quiet.Spread.Low, Is.LessThanOrEqualTo(quiet.Median));
        Assert.That(quiet.Spread.High, Is.GreaterThanOrEqualTo(quiet.Median));
        Assert.That(loud.BytesAllocated, Is.GreaterThan(0));
        Assert.That(quiet.RatioTo(quiet), Is.EqualTo(1));
    }

    [Test]
    public void Times_of_both_runtimes_are_read_by_name_and_what_is_no_time_is_passed_over()
    {
        const string coreClr = "free body by Exact,50\nlab's step, by the library,80.5\nfree body by LabEuler,20\n";
        const string mono = "a warning, of the runtime\r\nlab's step, by the library,805\r\nfree body by Exact,1.5E+02\r\nfree body by LabEuler,NaN\r\n";

        OnMono found = OnMono.Of(coreClr, mono);

        Assert.That(found.Problem, Is.Empty);
        Assert.That(found.Times, Is.EqualTo(new[] { new OnMono.Row("free body by Exact", 50, 150), new OnMono.Row("lab's step, by the library", 80.5, 805) }));
        Assert.That(found.Csv(), Is.EqualTo("\"free body by Exact, on Mono\",1,1,150,\n\"lab's step, by the library, on Mono\",1,1,805,\n"));
        Assert.That(OnMono.Of(coreClr, "no line of these").Problem, Does.Contain("no time"));
    }

    [Test]
    public void Other_engines_stand_behind_ours_by_time_and_error()
    {
        OtherEngines.Row ours = new("Exact, one by one", 50, 4e-15);

        OtherEngines found = OtherEngines.Of([ours], "PhysX 5.6.1,1.05E+2,3.01\r\na warning, of an engine\nHavok 1,NaN,2\nbroken,-1,2\nrun away,5,NaN\n");

        Assert.That(found.Rows, Is.EqualTo(new[] { ours, new OtherEngines.Row("PhysX 5.6.1", 105, 3.01) }));
        Assert.That(found.Csv(), Is.EqualTo("engine,nanosecondsPerBodyStep,angleError\n\"Exact, one by one\",50,4E-15\n\"PhysX 5.6.1\",105,3.01\n"));
        Assert.That(OtherEngines.Of([ours], "nothing").Problem, Does.Contain("no times"));
    }

    [Test]
    public void Program_that_cannot_be_run_fails_or_does_not_end_is_a_problem_in_one_line()
    {
        string dotnet = OtherProgram.OnPath("dotnet")!, lab = Path.Combine(AppContext.BaseDirectory, "MyRigidbody.Lab.dll");
        using TemporaryFolder folder = new();
        File.Copy(Path.Combine(Gallery.Folder, "heavy-top.json"), folder.File("heavy top.json"));

        OtherProgram runs = Run(dotnet, 60, lab, "run", folder.File("heavy top.json"), "--every", "0");
        OtherProgram missing = Run(folder.File("no such program"), 60);
        OtherProgram fails = Run(dotnet, 60, lab, "run", "missing.json");
        OtherProgram goesOn = Run(dotnet, 0.2, lab, "bench", "--out", folder.File("bench.csv"));

        Assert.That(runs, Has.Property("Problem").Empty.And.Property("Output").Contain("top,1000,"));
        Assert.That(missing.Problem, Does.StartWith("no such program cannot be run: "));
        Assert.That(fails.Problem, Does.StartWith("dotnet ended with exit code 2: error: missing.json"));
        Assert.That(goesOn.Problem, Is.EqualTo("dotnet did not end within 0.2 s"));
        Assert.That(new[] { missing, fails, goesOn }.Select(program => program.Output + program.Problem), Has.None.Contains("\n"));

        static OtherProgram Run(string program, double seconds, params string[] arguments) =>
            OtherProgram.Run(program, arguments, new Dictionary<string, string>(), TimeSpan.FromSeconds(seconds));
    }
}
