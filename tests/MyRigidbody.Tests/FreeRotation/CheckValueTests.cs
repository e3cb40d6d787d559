using System.Globalization;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>500 single steps of all kinds of bodies, forwards and backwards, up to 120 rad, against a Taylor series in 78 digits.</summary>
public sealed class CheckValueTests
{
    private const double Rounding = 1.1102230246251565e-16;

    [Test]
    public void Single_steps_of_any_length_and_sign_are_right_to_a_few_roundings_of_the_angle()
    {
        List<(double Worst, string Row)> rows = [];
        foreach (string line in File.ReadLines(TestData.Path("free-rotation-check.csv")).Where(line => line[0] is not ('#' or 'I')))
        {
            double[] n = [.. line.Split(',').Select(text => double.Parse(text, CultureInfo.InvariantCulture))];
            Vector3d w = new(n[3], n[4], n[5]);
            BodyDescription body = new("body", MassProperties.FromPrincipal(1, new Vector3d(n[0], n[1], n[2])));
            body.Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, w);
            BodyState state = new FreeMotion(body).At(n[6]);
            double turn = Conserved.AngleBetween(state.Orientation, new Quaterniond(n[10], n[11], n[12], n[13]));
            Vector3d after = state.Orientation.RotateInverse(state.AngularVelocity);
            double spin = Samples.Apart(after, new Vector3d(n[7], n[8], n[9])) / w.Length;
            rows.Add((Math.Max(turn, spin) / (Rounding * (1 + w.Length * Math.Abs(n[6]))), line));
        }

        rows.Sort((a, b) => b.Worst.CompareTo(a.Worst));
        foreach ((double worst, string row) in rows.Take(6))
            TestContext.Out.WriteLine(FormattableString.Invariant($"{worst:g3} roundings: {row}"));

        Assert.That(rows, Has.Count.EqualTo(500));
        // the rest pass near the unstable axis, where the motion itself multiplies what the last bit of the inputs does
        Assert.That(rows.Count(row => row.Worst <= 10), Is.GreaterThanOrEqualTo(490)); // measured 497
        Assert.That(rows[0].Worst, Is.LessThan(2000)); // measured 715, on the separatrix at 31 rad
    }
}
