using NUnit.Framework;
using static RigidBodyDynamics.Tests.Samples;

namespace RigidBodyDynamics.Tests;

/// <summary>Force, keys, forces per step, sums: their forces and torques.</summary>
public sealed class EffectTests
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
        Assert.That(Pushes.At(new KeyPush(key), Pushes.Now, Pushes.State), Is.EqualTo(new Wrench { Force = new Vector3d(x, y, 0) }));
        Wrench impulse = Pushes.Over(new KeyPush(key), Pushes.Now, 2, Pushes.State);
        Assert.That(impulse, Is.EqualTo(new Wrench { Force = new Vector3d(2 * x, 2 * y, 0) }));
    }

    [TestCase(0.0)]
    [TestCase(0.7)]
    [TestCase(3.0)]
    public void Key_R_turns_with_the_sine_of_the_time_on_every_world_axis(double t)
    {
        double sin = Math.Sin(t), integral = Math.Cos(t) - Math.Cos(t + 0.5);
        Wrench now = Pushes.At(new KeyPush(LabKey.R), new Instant(0, t), Pushes.State);
        Wrench later = Pushes.Over(new KeyPush(LabKey.R), new Instant(0, t), 0.5, Pushes.State);
        Assert.That(Apart(now.Torque, new Vector3d(sin, sin, sin)), Is.LessThan(3e-16)); // measured 0
        Assert.That(Apart(later.Torque, new Vector3d(integral, integral, integral)), Is.LessThan(5e-16)); // measured 5.6e-17
    }

    [Test]
    public void Forces_per_step_are_looked_up_by_the_number_of_the_step_and_end_with_the_list()
    {
        PerStep perStep = new(Kicks, [new Vector3d(7, 8, 9)]);
        Wrench first = new() { Force = Kicks[0], Torque = new Vector3d(7, 8, 9) };
        Assert.That(Pushes.At(perStep, new Instant(0, 99), Pushes.State), Is.EqualTo(first));
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
        Assert.That(new PerStep([], []).Traits, Is.EqualTo(EffectTraits.None));
        Assert.That(new PerStep(Kicks, []).Traits, Is.EqualTo(EffectTraits.Moves | EffectTraits.ReadsTime));
        Assert.That(new PerStep([], Kicks).Traits, Is.EqualTo(EffectTraits.Turns | EffectTraits.ReadsTime));
    }

    [Test]
    public void Sum_has_a_potential_if_every_part_has_one()
    {
        Force force = new(new Vector3d(1, -2, 3));
        Spring spring = new(new Vector3d(1, 0, 0), new Vector3d(0, 1, 0), 2);
        QuadraticDrag drag = new(0.5);
        IPush[] with = [default(Nothing), new Both<Both<Nothing, Force>, Spring>(new(default, force), spring), new Many([force, spring])];
        IPush[] without = [new Both<Force, QuadraticDrag>(force, drag), new Both<QuadraticDrag, Force>(drag, force), new Many([drag, spring])];
        Assert.That(with.Select(sum => (sum.Traits & EffectTraits.HasPotential) != 0), Is.All.True);
        Assert.That(without.Select(sum => (sum.Traits & EffectTraits.HasPotential) != 0), Is.All.False);
    }

    [Test]
    public void Sum_is_the_sum_of_its_parts_and_declares_what_any_of_them_declares()
    {
        Force force = new(new Vector3d(1, -2, 3));
        Spring spring = new(new Vector3d(1, 0, 0), new Vector3d(0, 1, 0), 2);
        QuadraticDrag drag = new(0.5);
        Both<Force, Spring> two = new(force, spring);
        IPush[] sums = [new Both<Both<Force, Spring>, QuadraticDrag>(two, drag), new Many([force, spring, drag])];
        foreach (IPush sum in sums)
        {
            Assert.That(sum.Traits, Is.EqualTo((force.Traits | spring.Traits | drag.Traits) & ~EffectTraits.HasPotential));
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

    private static IEnumerable<TestCaseData> Words()
    {
        Vector3d x = new(1, 0, 0), y = new(0, 3, 0), ones = new(1, 1, 1);
        yield return new TestCaseData(new Force(new Vector3d(1, -2, 0.5)), "force (1, -2, 0.5) N");
        yield return new TestCaseData(new KeyPush(LabKey.UpArrow), "key UpArrow");
        yield return new TestCaseData(new QuadraticDrag(0.25), "drag 0.25 abs(v) v N");
        yield return new TestCaseData(new Spring(x, y, 4.5), "spring 4.5 N/m from (1, 0, 0) to (0, 3, 0)");
        yield return new TestCaseData(new Force(y, at: x, inBody: true), "force (0, 3, 0) N at (1, 0, 0) m of the body, body axes");
        yield return new TestCaseData(new Force(x, ones, y, 1.5), "force (1, 0, 0) + (1, 1, 1) sin(1.5 t) + (0, 3, 0) cos(1.5 t) N");
        yield return new TestCaseData(new HeavyTop(2 * x, 3.5, y), "heavy top, m g l = 3.5 N m along (1, 0, 0), up (0, 1, 0)");
        yield return new TestCaseData(new PerStep(Kicks, []), "a force for each of 2 steps, a torque for each of 0");
        yield return new TestCaseData(Torque.Constant(ones), "torque (1, 1, 1) N m, world axes");
        yield return new TestCaseData(
            new Torque(x, ones, y, 1.5, true), "torque (1, 0, 0) + (1, 1, 1) sin(1.5 t) + (0, 3, 0) cos(1.5 t) N m, body axes");
        yield return new TestCaseData(new Gravity(new Vector3d(0, -9.81, 0)), "gravity (0, -9.81, 0) m/s²");
        yield return new TestCaseData(new LinearDamping(0.5), "linear damping 0.5 /s");
        yield return new TestCaseData(new AngularDamping(0.25), "angular damping 0.25 /s");
        yield return new TestCaseData(new DecayPerStep(0.98, 0.5), "v × 0.98, ω × 0.5 a step");
        yield return new TestCaseData(new HeldKeys(new LabKeyboard()), "keys held on the keyboard");
    }

    [TestCaseSource(nameof(Words))]
    public void Effect_says_in_words_what_it_does(object effect, string words) => Assert.That(effect.ToString(), Is.EqualTo(words));
}
