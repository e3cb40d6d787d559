using NUnit.Framework;
using UnityEngine;

namespace RigidBodyDynamics.Tests.StandIn;

/// <summary>The stand-in's functions are those of Unity's manual.</summary>
public sealed class MathfTests
{
    [Test]
    public void Functions_are_the_doubles_rounded()
    {
        Assert.That(Mathf.Sin(1), Is.EqualTo((float)Math.Sin(1)));
        Assert.That(Mathf.Cos(1), Is.EqualTo((float)Math.Cos(1)));
        Assert.That(Mathf.Tan(1), Is.EqualTo((float)Math.Tan(1)));
        Assert.That(Mathf.Asin(0.5f), Is.EqualTo((float)(Math.PI / 6)));
        Assert.That(Mathf.Acos(0.5f), Is.EqualTo((float)(Math.PI / 3)));
        Assert.That(Mathf.Atan(1), Is.EqualTo((float)(Math.PI / 4)));
        Assert.That(Mathf.Atan2(1, -1), Is.EqualTo((float)(3 * Math.PI / 4)));
        Assert.That(Mathf.Sqrt(2), Is.EqualTo((float)Math.Sqrt(2)));
        Assert.That(Mathf.Pow(2, 0.5f), Is.EqualTo((float)Math.Sqrt(2)));
        Assert.That(Mathf.Exp(1), Is.EqualTo((float)Math.E));
        Assert.That((Mathf.Log(2), Mathf.Log(8, 2), Mathf.Log10(1000)), Is.EqualTo(((float)Math.Log(2), 3f, 3f)));
    }

    [Test]
    public void Constants() =>
        Assert.That(
            (Mathf.PI, Mathf.Deg2Rad, Mathf.Rad2Deg, Mathf.Infinity, Mathf.NegativeInfinity, Mathf.Epsilon),
            Is.EqualTo(((float)Math.PI, (float)(Math.PI / 180), (float)(180 / Math.PI), float.PositiveInfinity, float.NegativeInfinity, float.Epsilon)));

    [TestCase(2.5f, 2f, 3, 2)]
    [TestCase(3.5f, 4f, 4, 3)]
    [TestCase(-2.5f, -2f, -2, -3)]
    public void Halves_are_rounded_to_the_even_neighbour(float f, float rounded, int ceil, int floor)
    {
        Assert.That((Mathf.Round(f), Mathf.RoundToInt(f)), Is.EqualTo((rounded, (int)rounded)));
        Assert.That((Mathf.Ceil(f), Mathf.CeilToInt(f)), Is.EqualTo(((float)ceil, ceil)));
        Assert.That((Mathf.Floor(f), Mathf.FloorToInt(f)), Is.EqualTo(((float)floor, floor)));
    }

    [Test]
    public void Sizes()
    {
        Assert.That((Mathf.Abs(-2.5f), Mathf.Abs(-2), Mathf.Sign(-3), Mathf.Sign(0)), Is.EqualTo((2.5f, 2, -1f, 1f)));
        Assert.That((Mathf.Min(1, 2.5f), Mathf.Max(1, 2.5f), Mathf.Min(3, 1, 2), Mathf.Max(3f, 1, 2), Mathf.Max(1, 2)), Is.EqualTo((1f, 2.5f, 1, 3f, 2)));
        Assert.That((Mathf.Clamp(5, 1, 3), Mathf.Clamp(0.5f, 1, 3), Mathf.Clamp01(-1), Mathf.Clamp01(0.3f)), Is.EqualTo((3, 1f, 0f, 0.3f)));
        Assert.That(Mathf.Approximately(1, 10f / 10), Is.True);
        Assert.That(Mathf.Approximately(1, 1.00001f), Is.False);
    }

    [Test]
    public void Between_two_numbers()
    {
        Assert.That((Mathf.Lerp(2, 4, 0.25f), Mathf.Lerp(2, 4, 9), Mathf.LerpUnclamped(2, 4, 2), Mathf.InverseLerp(2, 4, 3), Mathf.InverseLerp(2, 2, 3)), Is.EqualTo((2.5f, 4f, 6f, 0.5f, 0f)));
        Assert.That((Mathf.MoveTowards(1, 5, 3), Mathf.MoveTowards(1, 5, 9), Mathf.MoveTowards(5, 1, 3)), Is.EqualTo((4f, 5f, 2f)));
        Assert.That((Mathf.SmoothStep(0, 1, 0.5f), Mathf.SmoothStep(0, 1, 0.25f), Mathf.SmoothStep(0, 1, 2)), Is.EqualTo((0.5f, 0.15625f, 1f)));
    }

    [Test]
    public void Round_the_circle()
    {
        Assert.That((Mathf.DeltaAngle(1080, 90), Mathf.DeltaAngle(10, 350), Mathf.LerpAngle(350, 10, 0.5f)), Is.EqualTo((90f, -20f, 360f)));
        Assert.That(Mathf.MoveTowardsAngle(350, 10, 5), Is.EqualTo(355));
        Assert.That((Mathf.Repeat(7, 3), Mathf.Repeat(-1, 3), Mathf.PingPong(4, 3), Mathf.PingPong(7, 3)), Is.EqualTo((1f, 2f, 2f, 1f)));
    }

    [TestCase(5, 8, 4, false)]
    [TestCase(8, 8, 8, true)]
    [TestCase(7, 8, 8, false)]
    [TestCase(1, 1, 1, true)]
    public void Powers_of_two(int value, int next, int closest, bool isPower) =>
        Assert.That((Mathf.NextPowerOfTwo(value), Mathf.ClosestPowerOfTwo(value), Mathf.IsPowerOfTwo(value)), Is.EqualTo((next, closest, isPower)));

    [Test]
    public void The_next_power_of_two_ends_where_there_is_none() => Assert.That(Mathf.NextPowerOfTwo(int.MaxValue), Is.EqualTo(int.MinValue));

    [Test]
    public void A_damped_approach_reaches_its_target_and_does_not_overshoot()
    {
        float at = 0, velocity = 0, most = 0;
        for (int i = 0; i < 500; i++)
        {
            at = Mathf.SmoothDamp(at, 10, ref velocity, 0.3f, Mathf.Infinity, 0.02f);
            most = Mathf.Max(most, at);
        }

        Assert.That(at, Is.EqualTo(10).Within(1e-4));
        Assert.That(most, Is.LessThanOrEqualTo(10));
    }

    [TestCase(0.5f, 0.21404114f)]
    [TestCase(0.02f, 0.0015479876f)]
    public void Gamma_is_that_of_sRGB(float gamma, float linear)
    {
        Assert.That(Mathf.GammaToLinearSpace(gamma), Is.EqualTo(linear).Within(1e-6));
        Assert.That(Mathf.LinearToGammaSpace(linear), Is.EqualTo(gamma).Within(1e-6));
        Assert.That(Mathf.Gamma(-0.5f, 1, 2), Is.EqualTo(-0.25f));
    }
}
