using System.Globalization;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>1000 bodies of 17 kinds, 5000 steps of 1/50 s each, against solutions in 300 digits.</summary>
public sealed class RandomBodiesTests
{
    private static readonly string[] Lines = File.ReadAllLines(TestData.Path("random-bodies", "random-bodies.csv"));
    private static readonly string[] Columns = Lines[0].Split(',');

    [Test]
    public void Of_1000_random_bodies_998_stay_within_ten_times_what_the_last_bit_of_their_inputs_does()
    {
        (double Worst, string Row)[] found = [.. Lines.Skip(1).AsParallel().Select(line => (Worst(line, "Exact"), line)).OrderByDescending(f => f.Item1)];
        foreach ((double worst, string row) in found.Take(6))
            TestContext.Out.WriteLine(FormattableString.Invariant($"{worst:g3} floors: {string.Join(',', row.Split(',').Take(7))}"));

        Assert.That(found, Has.Length.EqualTo(1000));
        Assert.That(found.Count(f => f.Worst <= 10), Is.GreaterThanOrEqualTo(998)); // measured 998
        Assert.That(found[0].Worst, Is.LessThan(20)); // measured 12: two moments equal to 1e-9, floor of 1.7e-14 rad
    }

    [Test]
    public void Classical_Runge_Kutta_keeps_hardly_one_of_them_there()
    {
        string[] some = [.. Lines.Skip(1).Where((_, i) => i % 10 == 0)];
        Assert.That(some.Count(line => Worst(line, "RungeKutta4") <= 10), Is.LessThan(some.Length / 50)); // measured 0 of 100
    }

    private static double Worst(string line, string integrator)
    {
        string[] cells = line.Split(',');
        BodyDescription body = new("body", MassProperties.FromPrincipal(1, new Vector3d(Cell("I1"), Cell("I2"), Cell("I3"))))
        {
            Integrator = integrator,
            Start = new BodyState(
                Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, new Vector3d(Cell("w1"), Cell("w2"), Cell("w3"))),
        };
        Simulation simulation = Scenery.Stepped(TimeSteps.Every(0.02), body);
        double worst = 0;
        foreach (int time in new[] { 10, 50, 100 })
        {
            simulation.Step(50L * time - simulation.StepsDone);
            Quaterniond right = new(Cell("q0_" + time), Cell("q1_" + time), Cell("q2_" + time), Cell("q3_" + time));
            double ratio = Conserved.AngleBetween(simulation.Bodies[0].State.Orientation, right) / Cell("floor_" + time);
            worst = ratio <= worst ? worst : double.IsNaN(ratio) ? double.PositiveInfinity : ratio;
        }

        return worst;

        double Cell(string column) => double.Parse(cells[Array.IndexOf(Columns, column)], CultureInfo.InvariantCulture);
    }
}
