using NUnit.Framework;
using RigidBodyDynamics.Judging;

namespace RigidBodyDynamics.Tests.Judging;

/// <summary>
/// Single frames written by hand: v = (1, 2, 0) m/s, F/m = (5, 0, 0) m/s², Δt = 0.02 s, so v + Δt F/m = (1.1, 2, 0) and
/// v′ = (1.078, 1.96, 0).
/// </summary>
internal sealed class MatchTests
{
    private static readonly Vector Before = new(1, 2, 0), Push = new(5, 0, 0);

    [Test]
    public void The_formula_matches() => Assert.That(Of(new Vector(1.078, 1.96, 0)).Miss, Is.EqualTo(Miss.None));

    [Test]
    public void A_frame_without_damping_has_another_factor_and_the_right_gain()
    {
        Match match = Of(new Vector(1.1, 2, 0));
        Assert.That(match.Miss, Is.EqualTo(Miss.Decay));
        Assert.That(match.Decay, Is.EqualTo(1).Within(1e-12)); // measured 0
    }

    [Test]
    public void A_frame_without_the_time_step_gains_too_much() => Assert.That(Of(0.98 * new Vector(6, 2, 0)).Miss, Is.EqualTo(Miss.Gain));

    [Test]
    public void Damping_at_the_beginning_matches_in_its_own_order()
    {
        // 0.98 (1, 2, 0) + (0.1, 0, 0)
        Vector after = new(1.08, 1.96, 0);
        Assert.That(Of(after).Miss, Is.EqualTo(Miss.Gain));
        Assert.That(Of(after, Order.DecayThenGain).Miss, Is.EqualTo(Miss.None));
    }

    [Test]
    public void Where_force_and_velocity_have_one_direction_gain_and_factor_cannot_be_told_apart() =>
        Assert.That(new Match(new Link(null, new Vector(1, 0, 0), new Vector(1.1, 0, 0), Push), 0.02, Order.GainThenDecay).Miss, Is.EqualTo(Miss.Either));

    [Test]
    public void A_velocity_that_becomes_no_number_is_a_miss() => Assert.That(Of(new Vector(double.NaN, 0, 0)).Miss, Is.EqualTo(Miss.Gain));

    /// <summary>q + [0, ½Δt ω] q rotates by 2 atan(½Δt |ω|) about ω, for any length: twice the tangent is Δt |ω|.</summary>
    [Test]
    public void The_turn_of_the_first_order_formula_reads_as_the_angle_that_was_put_in()
    {
        Vector angle = new(0.06, -0.02, 0.09);
        Orientation q = new Orientation(0.1, -0.5, 0.2, 0.8), next = q + new Orientation(0.5 * angle, 0) * q;
        Vector read = Turns.FirstOrder(next.Normalized * q.Conjugate);
        Assert.That((read - angle).Length, Is.LessThan(1e-15)); // measured 1.1e-16
    }

    [Test]
    public void The_exact_rotation_reads_as_its_angle()
    {
        Vector angle = new(0.3, -0.2, 0.9);
        Assert.That((Turns.Exact(Orientation.Turn(angle)) - angle).Length, Is.LessThan(1e-15)); // measured 1.3e-16
    }

    private static Match Of(Vector after, Order order = Order.GainThenDecay) => new(new Link(null, Before, after, Push), 0.02, order);
}
