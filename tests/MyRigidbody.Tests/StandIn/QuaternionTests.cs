using NUnit.Framework;
using UnityEngine;

namespace RigidBodyDynamics.Tests.StandIn;

/// <summary>The stand-in's quaternion does what Unity's manual says of each member; w is last.</summary>
public sealed class QuaternionTests
{
    private static readonly float Half = Mathf.Sqrt(0.5f);

    [Test]
    public void A_product_turns_by_its_right_factor_first()
    {
        Quaternion aboutX = Quaternion.AngleAxis(90, Vector3.right), aboutY = Quaternion.AngleAxis(90, Vector3.up);
        Vector3 turned = aboutY * aboutX * Vector3.up; // y → z → x
        Assert.That(Vector3.Distance(turned, Vector3.right), Is.LessThan(1e-6)); // measured 1.2e-7
    }

    [Test]
    public void Hamiltons_rules()
    {
        Quaternion i = new(1, 0, 0, 0), j = new(0, 1, 0, 0), k = new(0, 0, 1, 0), minusOne = new(0, 0, 0, -1);
        Assert.That((i * j).Equals(k) && (j * k).Equals(i) && (k * i).Equals(j), Is.True);
        Assert.That((i * i).Equals(minusOne) && (j * i).Equals(new Quaternion(0, 0, -1, 0)), Is.True);
    }

    [Test]
    public void A_product_is_not_normalised() =>
        Assert.That(Quaternion.Dot(new Quaternion(0, 0, 0, 2) * new Quaternion(3, 0, 0, 0), new Quaternion(1, 0, 0, 0)), Is.EqualTo(6));

    [TestCase(0, 90, 0, 0, 1, 0)]
    [TestCase(90, 0, 0, 1, 0, 0)]
    [TestCase(0, 0, 90, 0, 0, 1)]
    public void Euler_counts_in_degrees(float x, float y, float z, float axisX, float axisY, float axisZ)
    {
        Quaternion q = Quaternion.Euler(x, y, z);
        Assert.That(q == new Quaternion(Half * axisX, Half * axisY, Half * axisZ, Half), Is.True);
        Assert.That(Quaternion.Euler(new Vector3(x, y, z)), Is.EqualTo(q));
    }

    [Test]
    public void Euler_turns_about_z_then_x_then_y()
    {
        Quaternion expected = Quaternion.AngleAxis(30, Vector3.up) * Quaternion.AngleAxis(20, Vector3.right) * Quaternion.AngleAxis(10, Vector3.forward);
        Assert.That(Quaternion.Angle(Quaternion.Euler(20, 30, 10), expected), Is.LessThan(0.05));
    }

    [TestCase(20, 30, 10)]
    [TestCase(350, 200, 100)]
    [TestCase(0, 0, 300)]
    [TestCase(89, 10, 0)]
    public void Euler_angles_come_back_from_0_to_360(float x, float y, float z)
    {
        Vector3 back = Quaternion.Euler(x, y, z).eulerAngles;
        Assert.That(Vector3.Distance(back, new Vector3(x, y, z)), Is.LessThan(2e-3)); // measured 1.3e-4, at 89° where asin is steep
    }

    [TestCase(90)]
    [TestCase(270)]
    public void At_the_poles_z_is_zero(float x)
    {
        Quaternion q = Quaternion.Euler(x, 40, 0);
        Assert.That(Quaternion.Euler(q.eulerAngles) == q, Is.True);
        Assert.That(q.eulerAngles.z, Is.Zero);
    }

    [Test]
    public void Normalising()
    {
        Quaternion q = new(1, 2, 4, 10);
        Assert.That(q.normalized == new Quaternion(1 / 11f, 2 / 11f, 4 / 11f, 10 / 11f), Is.True);
        Assert.That(Quaternion.Normalize(q), Is.EqualTo(q.normalized));
        q.Normalize();
        Assert.That(Quaternion.Dot(q, q), Is.EqualTo(1).Within(1e-6));
        Assert.That(new Quaternion(0, 0, 0, 0).normalized, Is.EqualTo(Quaternion.identity));
    }

    [Test]
    public void The_inverse_turns_back()
    {
        Quaternion q = Quaternion.AngleAxis(70, new Vector3(1, 2, 3));
        Assert.That(q * Quaternion.Inverse(q) == Quaternion.identity, Is.True);
    }

    [Test]
    public void An_axis_of_no_length_does_not_turn() => Assert.That(Quaternion.AngleAxis(50, Vector3.zero), Is.EqualTo(Quaternion.identity));

    [Test]
    public void Angle_and_axis_come_back()
    {
        Quaternion.AngleAxis(70, new Vector3(0, 3, 4)).ToAngleAxis(out float angle, out Vector3 axis);
        Assert.That(angle, Is.EqualTo(70).Within(1e-4));
        Assert.That(axis == new Vector3(0, 0.6f, 0.8f), Is.True);
    }

    [Test]
    public void Indexer_and_Set_count_x_y_z_w()
    {
        Quaternion q = default;
        for (int i = 0; i < 4; i++)
            q[i] = i + 1;

        Assert.That(q, Is.EqualTo(new Quaternion(1, 2, 3, 4)));
        Assert.That(q[3], Is.EqualTo(q.w));
        q.Set(5, 6, 7, 8);
        Assert.That(q, Is.EqualTo(new Quaternion(5, 6, 7, 8)));
        Assert.That(() => q[4], Throws.TypeOf<IndexOutOfRangeException>());
    }

    [Test]
    public void Equal_is_the_same_turn_nearly_and_not_its_negative()
    {
        Quaternion q = Quaternion.AngleAxis(40, Vector3.up);
        Assert.That(q == Quaternion.AngleAxis(40.01f, Vector3.up), Is.True);
        Assert.That(q == Quaternion.AngleAxis(41, Vector3.up), Is.False);
        Assert.That(q == new Quaternion(-q.x, -q.y, -q.z, -q.w), Is.False);
        Assert.That(Quaternion.Angle(q, new Quaternion(-q.x, -q.y, -q.z, -q.w)), Is.Zero);
    }

    [Test]
    public void Half_of_the_way()
    {
        Quaternion end = Quaternion.AngleAxis(80, Vector3.up), half = Quaternion.AngleAxis(40, Vector3.up);
        Assert.That(Quaternion.Slerp(Quaternion.identity, end, 0.5f) == half, Is.True);
        Assert.That(Quaternion.Lerp(Quaternion.identity, end, 0.5f) == half, Is.True);
        Assert.That(Quaternion.Slerp(Quaternion.identity, end, 3) == end, Is.True);
        Assert.That(Quaternion.RotateTowards(Quaternion.identity, end, 40) == half, Is.True);
    }

    [Test]
    public void Turns_that_take_directions_to_directions()
    {
        Vector3 from = new(1, 2, 3), to = new(-3, 1, 2);
        Assert.That(Vector3.Angle(Quaternion.FromToRotation(from, to) * from, to), Is.LessThan(0.05));
        Assert.That(Vector3.Angle(Quaternion.FromToRotation(from, -from) * from, -from), Is.LessThan(0.05));
        Quaternion look = Quaternion.LookRotation(to, Vector3.up);
        Assert.That(Vector3.Angle(look * Vector3.forward, to), Is.LessThan(0.05));
        Assert.That(Vector3.Dot(look * Vector3.right, Vector3.up), Is.EqualTo(0).Within(1e-6));
    }

    [Test]
    public void The_text_has_five_decimals() =>
        Assert.That(Quaternion.identity.ToString(), Is.EqualTo("(0.00000, 0.00000, 0.00000, 1.00000)"));
}
