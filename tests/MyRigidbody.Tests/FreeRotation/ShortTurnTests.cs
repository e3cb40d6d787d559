using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>The rotation of a step that is short enough for series, against the motion in twice the digits.</summary>
public sealed class ShortTurnTests
{
    // moments and ω: a top, one near its unstable axis, a plate, a rod, and one whose momentum hardly swings while it spins fast
    private static readonly (Vector3d Moments, Vector3d Spin)[] Tops =
    [
        (new(1, 2, 3), new(1, 1.1, 0.9)),
        (new(1, 2, 3), new(1e-3, 1.5, -2e-3)),
        (new(1, 2, 2.99), new(0.2, -1.3, 1.7)),
        (new(0.02, 1, 1.01), new(1, 0.2, -0.1)),
        (new(1, 2, 3), new(1e-3, 1e-3, 2)),
    ];

    // half the length of the longest short rotation, just below that, just above, and twice as long
    [TestCase(0.5)]
    [TestCase(0.999)]
    [TestCase(1.001)]
    [TestCase(2)]
    public void Turn_about_as_long_as_the_series_reach_is_right_and_leaves_the_orientation_a_unit(double part)
    {
        double worst = 0, length = 0;
        foreach ((Vector3d moments, Vector3d spin) in Tops)
        {
            double h = part * Longest(moments, spin);
            BodyDescription body = new("b", MassProperties.FromPrincipal(1, moments)) { Rule = Rules.Exact };
            body.Start = new BodyState(Vector3d.Zero, new Quaterniond(0.5, 0.5, -0.5, 0.5), Vector3d.Zero, Vector3d.Zero);
            body.AngularVelocityInBody = spin;
            FreeMotion truth = new(body);
            Simulation simulation = Scenery.Stepped(TimeSteps.Every(h), body);
            for (int i = 1; i <= 300; i++)
            {
                simulation.Step();
                Quaterniond q = simulation.Bodies[0].State.Orientation;
                length = Math.Max(length, Math.Abs(q.LengthSquared - 1));
                worst = Math.Max(worst, Conserved.AngleBetween(q, truth.At(i * h).Orientation) / i);
            }
        }

        TestContext.Out.WriteLine(FormattableString.Invariant($"{worst:g2} rad a step, length {length:g2}"));
        Assert.That(worst, Is.LessThan(1e-15)); // measured at most 7.5e-16
        Assert.That(length, Is.LessThan(6e-16)); // measured 4.4e-16
    }

    // so a turn that is short by the rate of the orbit is short by how far M goes, and nothing else need be asked
    [Test]
    public void Momentum_swings_no_faster_than_the_rate_of_its_orbit()
    {
        Random random = new(1);
        double most = 0;
        for (int i = 0; i < 10_000; i++)
        {
            // on the separatrix, I₁ A₁ and I₃ A₃ in the ratio of G₁ I₁ and G₃ I₃, both are the same: half of the bodies are near it
            double small = random.NextDouble(), a = random.NextDouble(), near = i % 2 == 0 ? 1 + (1e-3 * (random.NextDouble() - 0.5)) : Math.Exp(6 * (random.NextDouble() - 0.5));
            TopShape shape = new(new Vector3d(small, small + (a * (1 - small)), 1), Quaterniond.Identity);
            double a1 = near * shape.G1, a3 = shape.G3, l2 = (shape.I1 * a1) + (shape.I3 * a3);
            most = Math.Max(most, -shape.DeltaOfQ * a1 * a3 / l2 / Math.Max(shape.AlphaOfA3 * a3, shape.BetaOfA1 * a1));
        }

        Assert.That(most, Is.InRange(0.999, 1 + 1e-12)); // measured 1 - 2e-8
    }

    // the longest step, s, whose rotation is short: by the angle between M and M₊, or by ψ
    private static double Longest(Vector3d moments, Vector3d spin)
    {
        TopShape shape = new(moments, Quaterniond.Identity);
        double a1 = shape.I1 * spin.X * spin.X + shape.G1 * spin.Y * spin.Y, a3 = shape.I3 * spin.Z * spin.Z + shape.G3 * spin.Y * spin.Y;
        double low = 0, high = 10;
        for (int i = 0; i < 60; i++)
        {
            double h = 0.5 * (low + high);
            OrbitStep step = default;
            step.Set(shape, a1, a3, shape.M1 * spin.X * spin.X - shape.M3 * spin.Z * spin.Z, h);
            double flip = Math.Sqrt(Math.Max(shape.AlphaOfA3 * a3, shape.BetaOfA1 * a1)) * step.S;
            bool isShort = flip <= 0.25 && step.Versine <= AsymmetricTop.LargestVersine;
            (low, high) = isShort ? (h, high) : (low, h);
        }

        return low;
    }
}
