using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Whole steps from times of any length, and what is left of them.</summary>
public sealed class AdvanceTests
{
    [Test]
    public void Tenth_of_a_second_is_five_steps_of_two_hundredths_for_hours()
    {
        Simulation simulation = new(TimeSteps.Every(0.02));
        for (int i = 1; i <= 100_000; i++)
        {
            Assert.That(simulation.Advance(0.1), Is.EqualTo(5));
            Assert.That(simulation.Alpha, Is.LessThan(1e-9)); // measured 0
        }

        Assert.That(simulation.StepsDone, Is.EqualTo(500_000));
    }

    [TestCase(1 / 60.0)]
    [TestCase(1 / 144.0)]
    [TestCase(0.0037)]
    [TestCase(0.31)]
    public void Steps_and_rest_are_the_time_that_has_passed(double frame)
    {
        Simulation simulation = new(TimeSteps.Every(0.02));
        long taken = 0;
        for (int i = 1; i <= 10_000; i++)
        {
            taken += simulation.Advance(frame);
            double passed = i * frame / 0.02;
            Assert.That(simulation.StepsDone, Is.EqualTo(taken));
            Assert.That(simulation.StepsDone + simulation.Alpha, Is.EqualTo(passed).Within(1e-8)); // measured 2.9e-11
            Assert.That(simulation.Alpha, Is.InRange(0, 1));
        }
    }

    [Test]
    public void Same_frames_twice_come_to_the_same_bits_and_to_those_of_the_steps()
    {
        foreach (string rule in Scenery.Integrators)
        {
            Simulation one = new(TimeSteps.Every(0.02)), two = new(TimeSteps.Every(0.02)), steps = new(TimeSteps.Every(0.02));
            Body a = one.Add(Scenery.Busy(rule)), b = two.Add(Scenery.Busy(rule)), c = steps.Add(Scenery.Busy(rule));
            Random random = new(11);
            for (int i = 0; i < 300; i++)
            {
                double frame = 0.03 * random.NextDouble();
                steps.Step(one.Advance(frame));
                two.Advance(frame);
                Assert.That((a.State, one.Alpha), Is.EqualTo((b.State, two.Alpha)));
                Assert.That(c.State, Is.EqualTo(a.State));
                Assert.That(a.Between(one.Alpha), Is.EqualTo(b.Between(two.Alpha)));
            }
        }
    }

    [Test]
    public void Lengths_from_a_list_are_taken_one_by_one()
    {
        Simulation simulation = new(TimeSteps.Of([0.1, 0.2, 0.05, 0.4]));
        Assert.That(simulation.Advance(0.15), Is.EqualTo(1));
        Assert.That(simulation.Alpha, Is.EqualTo(0.25).Within(1e-15));
        Assert.That(simulation.Advance(0.19), Is.EqualTo(1));
        Assert.That(simulation.Alpha, Is.EqualTo(0.8).Within(1e-14)); // measured 4.4e-16
        Assert.That(simulation.Advance(0.01), Is.EqualTo(1));
        Assert.That(simulation.Advance(0), Is.Zero);
        Assert.That(simulation.Advance(0.4), Is.EqualTo(1));
        Assert.That(simulation.Time, Is.EqualTo(0.75).Within(1e-15));
    }

    [Test]
    public void At_the_end_of_its_time_it_stands_still_and_is_drawn_at_its_last_state()
    {
        foreach (TimeSteps steps in new[] { TimeSteps.Every(0.02, 10), TimeSteps.Of([.. Enumerable.Repeat(0.02, 10)]) })
        {
            Simulation simulation = new(steps, Scenery.Busy("Exact"));
            Assert.That(simulation.Advance(0.15), Is.EqualTo(7));
            Assert.That(simulation.Advance(100), Is.EqualTo(3));
            Assert.That(simulation.Advance(100), Is.Zero);
            Assert.That(simulation.Alpha, Is.EqualTo(1));
            Assert.That(simulation.Bodies[0].Between(simulation.Alpha), Is.EqualTo(simulation.Bodies[0].State));
        }
    }

    [Test]
    public void Step_of_its_own_length_does_not_touch_the_rest()
    {
        Simulation simulation = new(TimeSteps.Every(0.02));
        simulation.Advance(0.033);
        simulation.StepBy(0.5);
        Assert.That(simulation.Alpha, Is.EqualTo(0.65).Within(1e-14)); // measured 0
        Assert.That(simulation.Advance(0.007), Is.EqualTo(1));
        Assert.That(simulation.Time, Is.EqualTo(0.54).Within(1e-15));
    }

    [Test]
    public void Time_whose_steps_failed_does_not_count()
    {
        Simulation simulation = new(TimeSteps.Every(0.02));
        simulation.Advance(0.03);
        Body body = simulation.Add(new BodyDescription("b", Solids.Sphere(1, 1)).With(new Spring(Vector3d.Zero, new Vector3d(1e300, 0, 0), 1), 0.05));
        Assert.That(() => simulation.Advance(0.2), Throws.TypeOf<StateOverflowException>());
        Assert.That(simulation.StepsDone, Is.EqualTo(3));
        Assert.That(simulation.Alpha, Is.EqualTo(0.5).Within(1e-14)); // measured 0
        simulation.Remove(body);
        Assert.That(simulation.Advance(0.011), Is.EqualTo(1));
    }

    [TestCase(double.NaN)]
    [TestCase(double.PositiveInfinity)]
    [TestCase(-1e-9)]
    [TestCase(1e300)]
    public void Time_that_is_none_is_refused_by_value(double elapsed)
    {
        Simulation simulation = new(TimeSteps.Every(0.02), Scenery.Busy("Exact"));
        simulation.Advance(0.07);
        (BodyState state, double alpha) = (simulation.Bodies[0].State, simulation.Alpha);
        Assert.That(() => simulation.Advance(elapsed), Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.StartsWith("elapsed: must "));
        Assert.That((simulation.StepsDone, simulation.Bodies[0].State, simulation.Alpha), Is.EqualTo((3L, state, alpha)));
    }
}
