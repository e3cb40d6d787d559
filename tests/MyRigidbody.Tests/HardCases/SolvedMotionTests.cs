using System.Globalization;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Every reference solution by every integrator that can follow it, with every step: the bounds are in a table of their own.</summary>
public sealed class SolvedMotionTests
{
    private static readonly string[] Rules = ["Exact", "Exact, coasting", "Exact4", "Exact6", "Splitting", "RungeKutta4"];

    private static IEnumerable<object[]> Cases =>
        from motion in SolvedRun.Motions
        from rule in RulesFor(motion)
        select new object[] { motion, rule };

    // without pushes, Exact4 and Exact6 are Exact
    private static IEnumerable<string> RulesFor(string motion) =>
        Rules.Where(rule => !SolvedRun.IsFree(motion) || rule is not ("Exact4" or "Exact6"));

    /// <summary>
    /// tests/data/hard-cases/solved-motions.csv: what each integrator promises, beside what was measured when the promise was made.
    /// </summary>
    [TestCaseSource(nameof(Cases))]
    public void Solved_motion_stays_within_what_its_integrator_promises(string motion, string rule)
    {
        foreach (string division in SolvedRun.Divisions)
        {
            string row = Promises.Single(line => line.StartsWith($"{motion};{division};{rule};", StringComparison.Ordinal));
            double[] promised = [.. row.Split(';').Skip(3).Select(number => double.Parse(number, CultureInfo.InvariantCulture))];
            SolvedRun found = Run(motion, rule, division);
            Assert.That(found.Error, Is.LessThanOrEqualTo(promised[1]), division);
            Assert.That(found.Energy, Is.LessThanOrEqualTo(promised[3]), division);
            Assert.That(found.Momentum, Is.LessThanOrEqualTo(promised[5]), division);
        }
    }

    private static IEnumerable<string> Free => SolvedRun.Motions.Where(SolvedRun.IsFree);

    // measured at most 3.5 in steps and as run runs it (1/60 on the plate, 1/10 on the separatrix)
    [TestCaseSource(nameof(Free))]
    public void Free_motion_is_exact_at_any_step_but_for_a_few_last_bits(string motion)
    {
        foreach (string division in SolvedRun.Divisions)
        {
            Assert.That(Run(motion, "Exact", division).Floors, Is.LessThan(5), division);
            SolvedRun coasting = Run(motion, "Exact, coasting", division);
            Assert.That(coasting.Floors, Is.LessThan(5), division);
            // the needle rotates at 1000 rad/s, and its ω in world axes is rounded accordingly: 1e-13 across the axis
            Assert.That(coasting.Energy, Is.LessThan(motion == "needle" ? 3e-12 : 1e-14)); // measured 6.6e-13 and 2.8e-15
            Assert.That(coasting.Momentum, Is.LessThan(motion == "needle" ? 1e-11 : 2e-14)); // measured 2.3e-12 and 5.6e-15
        }
    }

    [TestCaseSource(nameof(Free))]
    public void Where_nothing_pushes_the_exact_integrators_are_one(string motion)
    {
        SolvedRun exact = SolvedRun.Of(motion, "Exact", "1/50");
        Assert.That(SolvedRun.Of(motion, "Exact4", "1/50"), Is.EqualTo(exact));
        Assert.That(SolvedRun.Of(motion, "Exact6", "1/50"), Is.EqualTo(exact));
    }

    [TestCaseSource(nameof(Motions))]
    public void Integrators_stand_in_the_order_of_their_quality(string motion)
    {
        double exact6 = Off("Exact6"), exact4 = Off("Exact4"), exact = Off("Exact"), splitting = Off("Splitting"), kutta = Off("RungeKutta4");
        double first = new[] { "LabEuler", "ExplicitEuler", "ImplicitGyroscopic", "ExplicitGyroscopic" }.Min(Off);
        TestContext.Out.WriteLine(FormattableString.Invariant($"{exact6:g2} {exact4:g2} {exact:g2} {splitting:g2} {kutta:g2} {first:g2}"));

        // beyond what roundings do, of more pushes a step among others
        const double Rounding = 3e-13;
        Assert.That(exact6, Is.LessThanOrEqualTo(exact4 + Rounding));
        Assert.That(exact4, Is.LessThanOrEqualTo(exact + Rounding));
        Assert.That(exact, Is.LessThanOrEqualTo(splitting + Rounding));
        // drag reads the velocity: it has no exact flow beside gravity, so Exact4 has no advantage
        if (motion != "fall_quadratic_drag")
            Assert.That(exact4, Is.LessThanOrEqualTo(kutta + Rounding));

        // where ω stays along one axis, or almost, an integrator that rotates about ω exactly is right by luck
        string[] byLuck = ["fast_spin", "intermediate_axis", "separatrix", "cube_sin_torque"];
        if (!byLuck.Contains(motion))
        {
            Assert.That(splitting, Is.LessThanOrEqualTo(first).Or.GreaterThan(2));
            Assert.That(kutta, Is.LessThanOrEqualTo(first).Or.GreaterThan(2));
        }

        double Off(string rule) => SolvedRun.Of(motion, rule, "1/50").Error;
    }

    // 1e-8, 1, 1.5: the moments of no body, so a scene refuses them; the equations of motion do not mind
    [TestCase(0.1)]
    [TestCase(0.02)]
    [TestCase(1.0 / 60)]
    [TestCase(0.001)]
    public void Body_that_cannot_exist_is_followed_at_any_step(double step)
    {
        ExactCase solved = ExactCase.Read("extreme");
        AsymmetricTop top = default;
        top.Start(new TopShape(new Vector3d(1e-8, 1, 1.5), Quaterniond.Identity), Quaterniondd.Unit(Quaterniond.Identity), new Vector3d(100, 0.2, 0.1));
        double worst = 0, floor = 0;
        long done = 0;
        foreach (ExactCase.Sample sample in solved.Samples)
        {
            floor = Math.Max(floor, sample["double_attainable_error"]);
            double steps = Math.Round(sample.Time / step);
            if (Math.Abs(steps * step - sample.Time) > 1e-9)
                continue;

            for (; done < steps; done++)
                top.Advance(step);

            worst = Math.Max(worst, Conserved.AngleBetween(top.Orientation, sample.Orientation) / floor);
        }

        TestContext.Out.WriteLine(FormattableString.Invariant($"{worst:g2} floors"));
        Assert.That(done, Is.GreaterThan(90));
        Assert.That(worst, Is.LessThan(0.1).And.GreaterThan(0)); // measured 0.0048
    }

    /// <summary>The bounds stand beside what is measured; MYRIGIDBODY_WRITE=1 writes both anew.</summary>
    [Test]
    public void Table_of_promises_has_what_is_measured()
    {
        List<string> lines = ["motion;division;rule;error;bound;energy;bound;momentum;bound"];
        foreach ((string motion, string rule) in SolvedRun.Motions.SelectMany(motion => RulesFor(motion).Select(rule => (motion, rule))))
        {
            foreach (string division in SolvedRun.Divisions)
            {
                SolvedRun found = Run(motion, rule, division);
                lines.Add(string.Create(
                    CultureInfo.InvariantCulture,
                    $"{motion};{division};{rule};{found.Error:0.0e0};{Bound(found.Error)};{found.Energy:0.0e0};{Bound(found.Energy)};{found.Momentum:0.0e0};{Bound(found.Momentum)}"));
            }
        }

        if (Environment.GetEnvironmentVariable("MYRIGIDBODY_WRITE") == "1")
        {
            File.WriteAllText(Repository.Root.File("tests/data/hard-cases/solved-motions.csv"), string.Join('\n', lines) + "\n");
            return;
        }

        Assert.That(Promises, Has.Length.EqualTo(lines.Count));
        foreach ((string promise, string line) in Promises.Zip(lines))
        {
            string[] written = promise.Split(';'), now = line.Split(';');
            Assert.That(written[..3], Is.EqualTo(now[..3]));
            foreach (int figure in line == lines[0] ? [] : new[] { 3, 5, 7 })
            {
                // roundings may fall otherwise where the arctangent of the test is another
                double a = double.Parse(written[figure], CultureInfo.InvariantCulture), b = double.Parse(now[figure], CultureInfo.InvariantCulture);
                Assert.That(Math.Max(a, b), Is.LessThanOrEqualTo(1.2 * Math.Min(a, b) + 1e-15).Or.EqualTo(double.PositiveInfinity), line);
            }
        }

        // an angle is at most π, so what is lost is lost
        static string Bound(double found) =>
            double.IsFinite(found) ? Math.Max(3 * found, 1e-15).ToString("0e0", CultureInfo.InvariantCulture) : "Infinity";
    }

    private static IEnumerable<string> Motions => SolvedRun.Motions;

    private static string[] Promises { get; } =
        File.Exists(TestData.Path("hard-cases", "solved-motions.csv")) ? File.ReadAllLines(TestData.Path("hard-cases", "solved-motions.csv")) : [];

    private static SolvedRun Run(string motion, string rule, string division) => rule == "Exact, coasting"
        ? SolvedRun.Of(motion, "Exact", division, Omissions.All)
        : SolvedRun.Of(motion, rule, division);
}
