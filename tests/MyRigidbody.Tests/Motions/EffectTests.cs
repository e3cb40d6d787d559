using NUnit.Framework;
using static RigidBodyDynamics.Tests.Samples;

namespace RigidBodyDynamics.Tests;

/// <summary>Force, keys, forces per step, the hand, sums: what they push with.</summary>
public class EffectTests
{
    private static readonly Vector3d[] Kicks = [new Vector3d(1, 0, -2), new Vector3d(0.5, 0.25, 0)];

    [Test]
    public void Force_acts_at_the_centre_of_mass_whatever_the_body_does()
    {
        Force force = new(new Vector3d(1, -2, 3));
        Wrench now = Pushes.At(force, Pushes.Now, Pushes.State), later = Pushes.Over(force, Pushes.Now, 0.5, Pushes.State);
        Assert.That(now, Is.EqualTo(new Wrench { Force = new Vector3d(1, -2, 3) }));
        Assert.That(later, Is.EqualTo(new Wrench { Force = new Vector3d(0.5, -1, 1.5) }));
    }

    [TestCase(LabKey.LeftArrow, -5, 0)]
    [TestCase(LabKey.RightArrow, 5, 0)]
    [TestCase(LabKey.UpArrow, 0, 5)]
    [TestCase(LabKey.DownArrow, 0, -5)]
    public void Arrow_pushes_with_five_newton(LabKey key, double x, double y)
    {
        Assert.That(Pushes.At(new Key(key), Pushes.Now, Pushes.State), Is.EqualTo(new Wrench { Force = new Vector3d(x, y, 0) }));
        Assert.That(Pushes.Over(new Key(key), Pushes.Now, 2, Pushes.State), Is.EqualTo(new Wrench { Force = new Vector3d(2 * x, 2 * y, 0) }));
    }

    [TestCase(0.0)]
    [TestCase(0.7)]
    [TestCase(3.0)]
    public void Key_R_turns_with_the_sine_of_the_time_on_every_world_axis(double t)
    {
        double sin = Math.Sin(t), integral = Math.Cos(t) - Math.Cos(t + 0.5);
        Wrench now = Pushes.At(new Key(LabKey.R), new Instant(0, t), Pushes.State);
        Wrench later = Pushes.Over(new Key(LabKey.R), new Instant(0, t), 0.5, Pushes.State);
        Assert.That(Apart(now.Torque, new Vector3d(sin, sin, sin)), Is.LessThan(3e-16)); // measured 0
        Assert.That(Apart(later.Torque, new Vector3d(integral, integral, integral)), Is.LessThan(5e-16)); // measured 1.1e-16
    }

    [Test]
    public void Forces_per_step_are_looked_up_by_the_number_of_the_step_and_end_with_the_list()
    {
        PerStep perStep = new(Kicks, [new Vector3d(7, 8, 9)]);
        Assert.That(Pushes.At(perStep, new Instant(0, 99), Pushes.State), Is.EqualTo(new Wrench { Force = Kicks[0], Torque = new Vector3d(7, 8, 9) }));
        Assert.That(Pushes.Over(perStep, new Instant(1, 0), 2, Pushes.State), Is.EqualTo(new Wrench { Force = 2 * Kicks[1] }));
        Assert.That(Pushes.At(perStep, new Instant(2, 0), Pushes.State), Is.EqualTo(default(Wrench)));
        Assert.That(Pushes.At(perStep, new Instant(long.MaxValue, 0), Pushes.State), Is.EqualTo(default(Wrench)));
    }

    [Test]
    public void Forces_per_step_are_copied_when_they_are_given()
    {
        Vector3d[] mine = [new Vector3d(1, 2, 3)];
        PerStep perStep = new(mine, mine);
        mine[0] = new Vector3d(9, 9, 9);
        Assert.That(Pushes.At(perStep, new Instant(0, 0), Pushes.State).Force, Is.EqualTo(new Vector3d(1, 2, 3)));
    }

    [Test]
    public void Lists_without_entries_declare_nothing()
    {
        Assert.That(new PerStep([], []).Traits, Is.EqualTo(PushTraits.None));
        Assert.That(new PerStep(Kicks, []).Traits, Is.EqualTo(PushTraits.Moves | PushTraits.ReadsTime));
        Assert.That(new PerStep([], Kicks).Traits, Is.EqualTo(PushTraits.Turns | PushTraits.ReadsTime));
    }

    [Test]
    public void Hand_pushes_with_what_it_was_given_last()
    {
        Hand hand = new();
        HeldBy held = new(hand);
        Assert.That(Pushes.At(held, Pushes.Now, Pushes.State), Is.EqualTo(default(Wrench)));
        hand.Force = new Vector3d(1, 2, 3);
        hand.Torque = new Vector3d(4, 5, 6);
        Assert.That(Pushes.Over(held, Pushes.Now, 2, Pushes.State), Is.EqualTo(new Wrench { Force = new Vector3d(2, 4, 6), Torque = new Vector3d(8, 10, 12) }));
    }

    [Test]
    public void Sum_is_the_sum_of_its_parts_and_declares_what_any_of_them_declares()
    {
        Force force = new(new Vector3d(1, -2, 3));
        Spring spring = new(new Vector3d(1, 0, 0), new Vector3d(0, 1, 0), 2);
        QuadraticDrag drag = new(0.5);
        IPush[] sums = [new Both<Both<Force, Spring>, QuadraticDrag>(new Both<Force, Spring>(force, spring), drag), new Many([force, spring, drag])];
        foreach (IPush sum in sums)
        {
            Assert.That(sum.Traits, Is.EqualTo(force.Traits | spring.Traits | drag.Traits));
            Wrench expected = default;
            Wrench impulse = default;
            foreach (IPush part in new IPush[] { force, spring, drag })
            {
                part.At(Pushes.Now, Pushes.State, Pushes.Mass, ref expected);
                part.Over(Pushes.Now, 0.3, Pushes.State, Pushes.Mass, ref impulse);
            }

            Assert.That(Pushes.At(sum, Pushes.Now, Pushes.State), Is.EqualTo(expected));
            Assert.That(Pushes.Over(sum, Pushes.Now, 0.3, Pushes.State), Is.EqualTo(impulse));
        }
    }

    [Test]
    public void Effects_say_in_words_what_they_do()
    {
        Assert.That(new Force(new Vector3d(1, -2, 0.5)).ToString(), Is.EqualTo("force (1, -2, 0.5) N"));
        Assert.That(new Key(LabKey.UpArrow).ToString(), Is.EqualTo("key UpArrow"));
        Assert.That(new QuadraticDrag(0.25).ToString(), Does.Contain("0.25"));
        Assert.That(new Spring(new Vector3d(1, 0, 0), new Vector3d(0, 3, 0), 4.5).ToString(), Does.Contain("4.5").And.Contain("(1, 0, 0)").And.Contain("(0, 3, 0)"));
        Assert.That(new HeavyTop(new Vector3d(0, 0, 2), 3.5, new Vector3d(0, 4, 0)).ToString(), Does.Contain("3.5").And.Contain("(0, 0, 1)").And.Contain("(0, 1, 0)"));
        Assert.That(new PerStep(Kicks, []).ToString(), Does.Contain("2 steps").And.Contain("of 0"));
        Assert.That(Torque.Constant(new Vector3d(1, 2, 3)).ToString(), Is.EqualTo("torque (1, 2, 3) N m, world axes"));
        Assert.That(new Torque(Vector3d.Zero, new Vector3d(1, 1, 1), Vector3d.Zero, 1.5, true).ToString(), Does.Contain("sin(1.5 t)").And.Contain("body"));
        Assert.That(new Gravity(new Vector3d(0, -9.81, 0)).ToString(), Does.Contain("(0, -9.81, 0)"));
        Assert.That(new LinearDamping(0.5).ToString() + new AngularDamping(0.25), Does.Contain("linear damping 0.5").And.Contain("angular damping 0.25"));
        Assert.That(new DecayPerStep(0.98, 0.5).ToString(), Does.Contain("0.98").And.Contain("0.5"));
        Assert.That(new HeldBy(new Hand()).ToString(), Is.Not.Empty);
    }
}
