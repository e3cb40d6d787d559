using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>The two methods of every push are consistent.</summary>
public sealed class ImpulseTests
{
    // nodes and weights of Gauss's rule of five points on (0, 1)
    private static readonly (double Node, double Weight)[] GaussRule =
    [
        (0.5 - 0.5 * 0.906179845938664, 0.5 * 0.23692688505618908),
        (0.5 - 0.5 * 0.5384693101056831, 0.5 * 0.47862867049936647),
        (0.5, 0.5 * 0.5688888888888889),
        (0.5 + 0.5 * 0.5384693101056831, 0.5 * 0.47862867049936647),
        (0.5 + 0.5 * 0.906179845938664, 0.5 * 0.23692688505618908),
    ];

    [TestCaseSource(typeof(Pushes), nameof(Pushes.All))]
    public void Impulse_of_a_short_time_is_that_time_times_the_push(IPush push)
    {
        Wrench now = Pushes.At(push, Pushes.Now, Pushes.State);
        foreach (double h in new[] { 1e-3, 1e-6, 1e-9 })
        {
            Wrench mean = Pushes.Times(1 / h, Pushes.Over(push, Pushes.Now, h, Pushes.State));
            double slope = (Pushes.Apart(mean, now) - 1e-14) / h;
            Assert.That(slope, Is.LessThan(3)); // measured 1.5
        }
    }

    [TestCaseSource(typeof(Pushes), nameof(Pushes.All))]
    public void Impulse_is_the_integral_of_the_push_on_a_body_held_in_its_place(IPush push)
    {
        double size = 1 + Pushes.Apart(Pushes.At(push, Pushes.Now, Pushes.State), default);
        foreach (double h in new[] { 0.01, 0.4, 3 })
        {
            Wrench impulse = Pushes.Over(push, Pushes.Now, h, Pushes.State);
            double error = Pushes.Apart(impulse, Integral(push, h)) / (h * size);
            Assert.That(error, Is.LessThan(4e-15)); // measured 9.3e-16
        }
    }

    [TestCaseSource(typeof(Pushes), nameof(Pushes.All))]
    public void Push_is_added_to_what_is_there_already(IPush push)
    {
        Wrench there = new() { Force = new Vector3d(16, 32, 64), Torque = new Vector3d(-8, 128, 4), BodyTorque = new Vector3d(2, 256, 5) };
        Wrench sum = there;
        push.At(Pushes.Now, Pushes.State, Pushes.Mass, ref sum);
        Assert.That(Pushes.Apart(sum, Sum(there, Pushes.At(push, Pushes.Now, Pushes.State))), Is.LessThan(1e-14)); // measured 0

        // what reads the velocity finds it changed by the impulse that was there
        BodyState pushed = Pushes.State;
        pushed.Velocity += Pushes.Mass.InverseMass * there.Force;
        sum = there;
        push.Over(Pushes.Now, 0.4, Pushes.State, Pushes.Mass, ref sum);
        Assert.That(Pushes.Apart(sum, Sum(there, Pushes.Over(push, Pushes.Now, 0.4, pushed))), Is.LessThan(1e-14)); // measured 1.8e-15
    }

    [Test]
    public void Sum_gone_through_in_reverse_is_the_sum_of_the_pushes_in_the_other_order()
    {
        Force force = new(new Vector3d(30, 0, -20));
        QuadraticDrag drag = new(0.4);
        Wrench there = default, back = default, other = default;
        new Both<Force, QuadraticDrag>(force, drag).Over(Pushes.Now, 0.4, Pushes.State, Pushes.Mass, ref there);
        new Both<Force, QuadraticDrag>(force, drag).Over(Pushes.Now.Reversed, 0.4, Pushes.State, Pushes.Mass, ref back);
        new Both<QuadraticDrag, Force>(drag, force).Over(Pushes.Now, 0.4, Pushes.State, Pushes.Mass, ref other);
        Assert.That(back.Force, Is.EqualTo(other.Force));
        Assert.That(Samples.Apart(back.Force, there.Force), Is.GreaterThan(0.1)); // measured 3.7 N s
        Wrench many = default;
        new Many([force, drag]).Over(Pushes.Now.Reversed, 0.4, Pushes.State, Pushes.Mass, ref many);
        Assert.That(many.Force, Is.EqualTo(back.Force));
    }

    // the place is held, the velocity follows the push: 64 panels of Runge and Kutta for it, Gauss where it is steady
    private static Wrench Integral(IPush push, double h)
    {
        const int panels = 64;
        Wrench sum = default;
        bool followsVelocity = (push.Traits & EffectTraits.ReadsVelocity) != 0;
        for (int i = 0; i < panels; i++)
        {
            Instant start = Pushes.Now.Later(h * i / panels);
            sum = Sum(sum, followsVelocity
                ? RungeKutta(push, start, h / panels, sum)
                : Gauss(push, start, h / panels));
        }

        return sum;
    }

    private static Wrench Gauss(IPush push, Instant start, double h)
    {
        Wrench sum = default;
        foreach ((double node, double weight) in GaussRule)
            sum = Sum(sum, Pushes.Times(weight * h, Pushes.At(push, start.Later(node * h), Pushes.State)));
        return sum;
    }

    private static Wrench RungeKutta(IPush push, Instant start, double panel, Wrench soFar)
    {
        const int steps = 40;
        double h = panel / steps;
        Wrench sum = default;
        for (int i = 0; i < steps; i++)
        {
            Instant t = start.Later(i * h);
            Wrench base0 = Sum(soFar, sum);
            Wrench k1 = At(t, base0);
            Wrench k2 = At(t.Later(h / 2), Sum(base0, Pushes.Times(h / 2, k1)));
            Wrench k3 = At(t.Later(h / 2), Sum(base0, Pushes.Times(h / 2, k2)));
            Wrench k4 = At(t.Later(h), Sum(base0, Pushes.Times(h, k3)));
            sum = Sum(sum, Pushes.Times(h / 6, Sum(Sum(k1, k4), Pushes.Times(2, Sum(k2, k3)))));
        }

        return sum;

        Wrench At(Instant now, Wrench given)
        {
            BodyState state = Pushes.State;
            state.Velocity += given.Force / Pushes.Mass.Mass;
            return Pushes.At(push, now, state);
        }
    }

    private static Wrench Sum(in Wrench a, in Wrench b) =>
        new() { Force = a.Force + b.Force, Torque = a.Torque + b.Torque, BodyTorque = a.BodyTorque + b.BodyTorque };
}
