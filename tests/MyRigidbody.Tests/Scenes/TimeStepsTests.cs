using CsCheck;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

public sealed class TimeStepsTests
{
    private static readonly (double Time, long Step)[] LabWindows = [(1, 60), (1.5, 90), (2, 120), (2.5, 150), (3, 180)];

    [Test]
    public void Step_n_starts_at_n_times_the_length()
    {
        TimeSteps steps = TimeSteps.Every(1.0 / 60);
        foreach (long n in new[] { 0, 1, 90, 123_456_789, 1L << 52 })
            Assert.That((steps.StartOf(n), steps.Length(n)), Is.EqualTo((n * (1.0 / 60), 1.0 / 60)));
        Assert.That(steps.Count, Is.EqualTo(long.MaxValue));
    }

    [Test]
    public void Windows_of_the_lab_begin_at_their_steps()
    {
        // a program that adds up 1/60 is one step late at 1.5 s, and so is one that asks n/60 >= t in double at others
        TimeSteps listed = TimeSteps.Of([.. Enumerable.Repeat(1.0 / 60, 500)]);
        foreach (TimeSteps steps in new[] { TimeSteps.Every(1.0 / 60), TimeSteps.Every(1.0 / 60, 500), listed })
            Assert.That(LabWindows.Select(w => steps.FirstAt(w.Time)), Is.EqualTo(LabWindows.Select(w => w.Step)));
    }

    [Test]
    public void Moment_at_the_start_of_a_step_is_found_whatever_was_rounded() => Property.Always(
        Gen.Select(Gen.Int[1, 2000], Gen.Int[1, 10_000_000]),
        t => TimeSteps.Every(1.0 / t.Item1).FirstAt((double)t.Item2 / t.Item1) == t.Item2);

    [Test]
    public void Moment_within_a_step_belongs_to_the_next()
    {
        foreach (TimeSteps steps in new[] { TimeSteps.Every(0.25), TimeSteps.Of([0.25, 0.25, 0.25, 0.25]) })
        {
            Assert.That(
                new[] { 1e-3, 0.2499, 0.25, 0.2501, 0.5, 0.74 }.Select(steps.FirstAt), Is.EqualTo(new[] { 1, 1, 1, 2, 2, 3 }));
        }
    }

    [Test]
    public void Everything_up_to_zero_is_at_step_zero_and_what_never_comes_is_after_the_last()
    {
        foreach (TimeSteps steps in new[] { TimeSteps.Every(0.25, 4), TimeSteps.Of([0.1, 0.2, 0.3, 0.4]) })
        {
            Assert.That(new[] { 0, -0.0, -5, double.NegativeInfinity }.Select(steps.FirstAt), Is.All.EqualTo(0));
            Assert.That(new[] { 1.01, 1e300, double.PositiveInfinity }.Select(steps.FirstAt), Is.All.EqualTo(4));
            Assert.That(steps.FirstAt(1), Is.EqualTo(4));
        }

        Assert.That(TimeSteps.Every(0.25).FirstAt(double.PositiveInfinity), Is.EqualTo(long.MaxValue));
        Assert.That(TimeSteps.Every(0.25).FirstAt(1e300), Is.EqualTo(long.MaxValue));
    }

    [Test]
    public void Uneven_steps_start_where_the_ones_before_end()
    {
        TimeSteps steps = TimeSteps.Of([0.5, 0.25, 1, 0.125]);
        Assert.That(Enumerable.Range(0, 5).Select(n => steps.StartOf(n)), Is.EqualTo(new[] { 0, 0.5, 0.75, 1.75, 1.875 }));
        Assert.That(Enumerable.Range(0, 4).Select(n => steps.Length(n)), Is.EqualTo(new[] { 0.5, 0.25, 1, 0.125 }));
        Assert.That(new[] { 0.5, 0.6, 0.75, 1.75, 1.8 }.Select(steps.FirstAt), Is.EqualTo(new[] { 1, 2, 2, 3, 4 }));
        Assert.That(steps.Count, Is.EqualTo(4));
    }

    [Test]
    public void Million_lengths_add_up_without_drift()
    {
        TimeSteps steps = TimeSteps.Of([.. Enumerable.Repeat(0.1, 1_000_000)]);
        // the error of the naive sum is 1.3e-6
        Assert.That(steps.StartOf(1_000_000), Is.EqualTo(100_000).Within(3e-11)); // measured 0
    }

    [Test]
    public void Lengths_are_copied_when_they_are_given()
    {
        double[] mine = [0.5, 0.5];
        TimeSteps steps = TimeSteps.Of(mine);
        mine[0] = 9;
        Assert.That((steps.Length(0), steps.StartOf(1)), Is.EqualTo((0.5, 0.5)));
    }

    [TestCase(3, 0.02, 150)]
    [TestCase(10, 1.0 / 60, 600)]
    [TestCase(1, 0.3, 4)]
    [TestCase(0.3, 0.1, 3)]
    [TestCase(0.001, 0.02, 1)]
    [TestCase(1e9, 1e9, 1)]
    public void Time_is_reached_in_as_many_steps_as_it_takes(double duration, double length, long count)
    {
        TimeSteps steps = TimeSteps.Until(duration, length);
        Assert.That((steps.Count, steps.Length(0)), Is.EqualTo((count, length)));
    }
}
