using NUnit.Framework;
using static RigidBodyDynamics.Tests.Samples;

namespace RigidBodyDynamics.Tests;

public sealed class TorqueTests
{
    private static readonly Vector3d Steady = new(1, -2, 3);
    private static readonly Vector3d SinePart = new(0.5, 0, -1);
    private static readonly Vector3d CosinePart = new(0, 2, 0.25);

    [TestCase(0.0)]
    [TestCase(0.7)]
    [TestCase(123.4)]
    public void Torque_is_constant_plus_sine_plus_cosine(double time)
    {
        const double rate = 1.5;
        Vector3d expected = Steady + Math.Sin(rate * time) * SinePart + Math.Cos(rate * time) * CosinePart;
        Wrench world = Pushes.At(new Torque(Steady, SinePart, CosinePart, rate, inBody: false), new Instant(0, time), Pushes.State);
        Wrench body = Pushes.At(new Torque(Steady, SinePart, CosinePart, rate, inBody: true), new Instant(0, time), Pushes.State);
        Assert.That(Apart(world.Torque, expected), Is.LessThan(2e-15)); // measured 4.4e-16
        Assert.That(world.BodyTorque.IsZero, Is.True);
        Assert.That(body.BodyTorque, Is.EqualTo(world.Torque));
        Assert.That(body.Torque.IsZero, Is.True);
    }

    [TestCase(0.01)]
    [TestCase(1.0)]
    [TestCase(50.0)]
    public void Impulse_is_the_integral_in_closed_form(double h)
    {
        const double rate = -1.5, t = 0.7;
        Vector3d expected = h * Steady
            + (Math.Cos(rate * t) - Math.Cos(rate * (t + h))) / rate * SinePart
            + (Math.Sin(rate * (t + h)) - Math.Sin(rate * t)) / rate * CosinePart;
        Wrench impulse = Pushes.Over(new Torque(Steady, SinePart, CosinePart, rate, inBody: false), new Instant(0, t), h, Pushes.State);
        Assert.That(Apart(impulse.Torque, expected) / h, Is.LessThan(1e-13)); // measured 6.9e-15: the difference cancels where h is 0.01
    }

    [TestCase(20)]
    [TestCase(30)]
    [TestCase(45)]
    public void Impulse_of_a_tiny_time_loses_no_digits(int halvings)
    {
        // the difference of two cosines a tiny time apart, with 256 bits
        double h = Math.Pow(2, -halvings);
        Fixed before = ManyDigits.SinCos(0.75).Cos, after = ManyDigits.SinCos(0.75 + h).Cos;
        Fixed expected = new(before.To(300).Mantissa - after.To(300).Mantissa, 300);
        Torque torque = new(Vector3d.Zero, new Vector3d(1, 0, 0), Vector3d.Zero, 1, inBody: false);
        double impulse = Pushes.Over(torque, new Instant(0, 0.75), h, Pushes.State).Torque.X;
        Assert.That(expected.UlpsTo(impulse), Is.LessThan(3)); // measured 0.61
    }

    [Test]
    public void Swing_of_no_rate_is_a_constant_cosine()
    {
        Torque torque = new(Steady, SinePart, CosinePart, 0, inBody: false);
        Assert.That(Pushes.At(torque, new Instant(0, 5), Pushes.State).Torque, Is.EqualTo(Steady + CosinePart));
        Assert.That(Pushes.Over(torque, new Instant(0, 5), 2, Pushes.State).Torque, Is.EqualTo(2 * (Steady + CosinePart)));
    }

    [Test]
    public void Constant_torque_declares_that_it_needs_no_clock()
    {
        Assert.That(Torque.Constant(Steady).Traits, Is.EqualTo(EffectTraits.Turns));
        Assert.That(new Torque(Steady, Vector3d.Zero, Vector3d.Zero, 3, true).Traits, Is.EqualTo(EffectTraits.Turns));
        Assert.That(new Torque(Steady, SinePart, Vector3d.Zero, 3, true).Traits, Is.EqualTo(EffectTraits.Turns | EffectTraits.ReadsTime));
    }

    [Test]
    public void Torque_in_body_axes_turns_with_the_body()
    {
        Quaterniond quarter = Quaterniond.FromAxisAngle(new Vector3d(0, 0, 1), Math.PI / 2);
        Wrench wrench = new() { Torque = new Vector3d(0, 0, 5), BodyTorque = new Vector3d(1, 0, 0) };
        Assert.That(Apart(wrench.TorqueInWorld(quarter), new Vector3d(0, 1, 5)), Is.LessThan(5e-16)); // measured 2.2e-16
    }
}
