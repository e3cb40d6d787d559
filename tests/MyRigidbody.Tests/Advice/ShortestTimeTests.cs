using NUnit.Framework;
using RigidBodyDynamics.Lab;

namespace RigidBodyDynamics.Tests;

/// <summary>When a time is known well enough not to be taken again.</summary>
public sealed class ShortestTimeTests
{
    [Test]
    public void Time_is_known_when_the_shortest_has_come_back_five_times_whatever_came_between() =>
        Assert.That(Known(100, 180, 100.9, 100, 250, 100.2, 100.5), Is.EqualTo((7, 100)));

    [Test]
    public void Shorter_time_makes_those_before_it_count_for_nothing() =>
        Assert.That(Known(100, 100, 100, 100, 90, 90, 90, 90, 90), Is.EqualTo((9, 90)));

    [Test]
    public void Times_that_never_agree_leave_it_unknown() =>
        Assert.That(Known(100, 110, 120, 130, 140, 150, 160, 170), Is.EqualTo((0, 100)));

    [Test]
    public void What_cannot_be_done_is_known_at_once() =>
        Assert.That(Known(double.PositiveInfinity), Is.EqualTo((1, double.PositiveInfinity)));

    // after how many times it was known, 0 for never, and what it then was
    private static (int Count, double Value) Known(params double[] times)
    {
        ShortestTime time = new();
        Assert.That(time.Value, Is.NaN);
        int known = 0;
        for (int i = 0; i < times.Length; i++)
        {
            time.Add(times[i]);
            known = known == 0 && time.IsKnown ? i + 1 : known;
        }

        return (known, time.Value);
    }
}
