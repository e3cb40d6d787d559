using System.Globalization;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>1000 bodies of 17 kinds, 5000 steps of 1/50 s each, against solutions in 300 digits.</summary>
public sealed class RandomBodiesTests
{
    private static readonly string[] Lines = File.ReadAllLines(TestData.Path("random-bodies", "random-bodies.csv"));
    private static readonly string[] Columns = Lines[0].Split(',');

    [Test]
    public void Of_1000_random_bodies_all_stay_within_six_times_what_the_last_bit_of_their_inputs_does()
    {
        (double Worst, string Row)[] found = [.. Lines.Skip(1).AsParallel().Select(line => (Worst(line, "Exact"), line)).OrderByDescending(f => f.Item1)];
        foreach ((double worst, string row) in found.Take(6))
            TestContext.Out.WriteLine(FormattableString.Invariant($"{worst:g3} floors: {string.Join(',', row.Split(',').Take(7))}"));

        Assert.That(found, Has.Length.EqualTo(1000));
        Assert.That(found.Count(f => f.Worst <= 3), Is.GreaterThanOrEqualTo(990)); // measured 996
        Assert.That(found[0].Worst, Is.LessThan(6)); // measured 4.4
    }

    // what run gives: closed forms and at most 127 steps
    [Test]
    public void Of_1000_random_bodies_that_coast_all_stay_there_and_half_of_them_within_2e_14()
    {
        (double Worst, double Angle, string Row)[] found =
            [.. Lines.Skip(1).AsParallel().Select(line => (Worst(line, "Exact", out double angle, Omissions.All), angle, line)).OrderByDescending(f => f.Item1)];
        double median = found.Select(f => f.Angle).Order().ElementAt(500);
        TestContext.Out.WriteLine(FormattableString.Invariant($"worst {found[0].Worst:g3} and {found[1].Worst:g3} floors, median {median:g2} rad"));
        Assert.That(found[0].Worst, Is.LessThan(10)); // measured 8.0: near isotropic, floor of 1.5e-14 rad
        Assert.That(found.Count(f => f.Worst <= 3), Is.GreaterThanOrEqualTo(990)); // measured 994 (stepped: 939)
        Assert.That(median, Is.LessThan(2e-14)); // measured 1.1e-14 (stepped: 5.4e-14)
    }

    [Test]
    public void Classical_Runge_Kutta_keeps_hardly_one_of_them_there()
    {
        string[] some = [.. Lines.Skip(1).Where((_, i) => i % 10 == 0)];
        Assert.That(some.Count(line => Worst(line, "RungeKutta4") <= 10), Is.LessThan(some.Length / 50)); // measured 0 of 100
    }

    private static double Worst(string line, string integrator) => Worst(line, integrator, out _, Omissions.None);

    private static double Worst(string line, string integrator, out double largest, Omissions omissions)
    {
        string[] cells = line.Split(',');
        BodyDescription body = new("body", MassProperties.FromPrincipal(1, new Vector3d(Cell("I1"), Cell("I2"), Cell("I3"))))
        {
            Rule = Rules.Named(integrator),
            Start = new BodyState(
                Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, new Vector3d(Cell("w1"), Cell("w2"), Cell("w3"))),
        };
        Simulation simulation = new(new SceneDescription("random", string.Empty, TimeSteps.Every(0.02), [body]), omissions);
        double worst = 0;
        largest = 0;
        foreach (int time in new[] { 10, 50, 100 })
        {
            simulation.Step(50L * time - simulation.StepsDone);
            Quaterniond right = new(Cell("q0_" + time), Cell("q1_" + time), Cell("q2_" + time), Cell("q3_" + time));
            double angle = Conserved.AngleBetween(simulation.Bodies[0].State.Orientation, right), ratio = angle / Cell("floor_" + time);
            largest = Math.Max(largest, angle);
            worst = ratio <= worst ? worst : double.IsNaN(ratio) ? double.PositiveInfinity : ratio;
        }

        return worst;

        double Cell(string column) => double.Parse(cells[Array.IndexOf(Columns, column)], CultureInfo.InvariantCulture);
    }
}
