using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>
/// What resets the counter of a body about to sleep: (v² + I ω²/m)/2 of the summed velocities, against the threshold. For a body
/// that does not weigh 1 kg; the recordings do.
/// </summary>
public sealed class WakeCounterTests
{
    private const double Dt = 0.02, Threshold = 0.005, Clock = 0.1;

    // a body of 4 kg with moments 1, 2, 2.5 kg m² about its axes
    [TestCase(0.8)]
    [TestCase(1.2)]
    [TestCase(5)]
    public void Clock_is_set_back_by_the_energy_per_mass_over_the_threshold(double times)
    {
        double energy = times * Threshold;
        foreach (Vector3d axis in new[] { new Vector3d(1, 0, 0), new Vector3d(0, 1, 0), new Vector3d(0, 0, 1) })
        {
            double moment = Vector3d.Dot(axis, new Vector3d(1, 2, 2.5));
            Assert.That(After(1, Math.Sqrt(2 * energy) * axis, Vector3d.Zero), Is.EqualTo(Right(times)).Within(1e-7)); // measured at most 2.4e-8, a float
            Assert.That(After(1, Vector3d.Zero, Math.Sqrt(2 * energy * 4 / moment) * axis), Is.EqualTo(Right(times)).Within(1e-7)); // measured at most 2.4e-8, a float
        }
    }

    [Test]
    public void Velocities_are_summed_before_they_are_squared()
    {
        // four times 0.3 of the speed at the threshold is 1.2 of it, and 1.44 of the energy
        Vector3d v = 0.3 * Math.Sqrt(2 * Threshold) * new Vector3d(0, 1, 0);
        Assert.That(After(3, v, Vector3d.Zero), Is.EqualTo(Clock - 3 * Dt).Within(1e-7)); // measured at most 2.4e-8, a float
        Assert.That(After(4, v, Vector3d.Zero), Is.EqualTo(Right(1.44)).Within(1e-7)); // measured at most 2.4e-8, a float
    }

    // below the threshold the clock runs; above it is set to half of its 0.4 s, to all of it at twice the threshold
    private static double Right(double times) => times < 1 ? Clock - Dt : 0.5 * Math.Min(2, times) * 0.4;

    private static double After(int steps, Vector3d v, Vector3d w)
    {
        UnityRigidbody<ToDouble> body = default;
        body.Start(new Beginning(new BodyDescription("b", MassProperties.FromPrincipal(4, new Vector3d(1, 2, 2.5)))
        {
            Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, v, w),
            Unity = new UnitySettings { AngularDrag = 0, InDouble = true, SleepThreshold = Threshold, WakeCounter = Clock },
        }));
        body.Prepare(Dt, Coasting.Free);
        Nothing nothing = default;
        for (int n = 0; n < steps; n++)
            body.Step(new Instant(n, n * Dt), ref nothing);
        return body.WakeCounter;
    }
}
