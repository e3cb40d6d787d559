using NUnit.Framework;
using UnityEngine;

namespace RigidBodyDynamics.Tests.StandIn;

/// <summary>The stand-in's vectors do what Unity's manual says of each member.</summary>
public sealed class VectorTests
{
    [Test]
    public void Directions_are_Unitys() =>
        Assert.That(
            new[] { Vector3.right, Vector3.left, Vector3.up, Vector3.down, Vector3.forward, Vector3.back, Vector3.one, Vector3.zero },
            Is.EqualTo(new[] { new Vector3(1, 0, 0), new(-1, 0, 0), new(0, 1, 0), new(0, -1, 0), new(0, 0, 1), new(0, 0, -1), new(1, 1, 1), new(0, 0, 0) }));

    [Test]
    public void Operators_work_by_component()
    {
        Vector3 a = new(1, 2, 3), b = new(4, -5, 6);
        Assert.That(a + b, Is.EqualTo(new Vector3(5, -3, 9)));
        Assert.That(a - b, Is.EqualTo(new Vector3(-3, 7, -3)));
        Assert.That(-a, Is.EqualTo(new Vector3(-1, -2, -3)));
        Assert.That(2 * a, Is.EqualTo(a * 2).And.EqualTo(new Vector3(2, 4, 6)));
        Assert.That(a / 2, Is.EqualTo(new Vector3(0.5f, 1, 1.5f)));
        Assert.That(Vector3.Scale(a, b), Is.EqualTo(new Vector3(4, -10, 18)));
        Assert.That(Vector3.Min(a, b), Is.EqualTo(new Vector3(1, -5, 3)));
        Assert.That(Vector3.Max(a, b), Is.EqualTo(new Vector3(4, 2, 6)));
    }

    [Test]
    public void Products_are_those_of_the_books()
    {
        Vector3 a = new(1, 2, 3), b = new(4, -5, 6);
        Assert.That(Vector3.Dot(a, b), Is.EqualTo(12));
        Assert.That(Vector3.Cross(a, b), Is.EqualTo(new Vector3(27, 6, -13)));
        Assert.That(Vector3.Cross(Vector3.right, Vector3.up), Is.EqualTo(Vector3.forward));
    }

    [Test]
    public void Lengths()
    {
        Vector3 v = new(2, 3, 6);
        Assert.That(v.sqrMagnitude, Is.EqualTo(49).And.EqualTo(Vector3.SqrMagnitude(v)));
        Assert.That(v.magnitude, Is.EqualTo(7).And.EqualTo(Vector3.Magnitude(v)));
        Assert.That(Vector3.Distance(v, new Vector3(2, 3, 10)), Is.EqualTo(4));
        Assert.That(Vector3.ClampMagnitude(v, 3.5f), Is.EqualTo(v / 2));
        Assert.That(Vector3.ClampMagnitude(v, 8), Is.EqualTo(v));
    }

    [Test]
    public void What_is_shorter_than_a_hundred_thousandth_is_normalised_to_zero()
    {
        Vector3 v = new(0, 3, 4);
        Assert.That(v.normalized, Is.EqualTo(new Vector3(0, 0.6f, 0.8f)));
        v.Normalize();
        Assert.That(v, Is.EqualTo(Vector3.Normalize(new Vector3(0, 30, 40))));
        Assert.That(new Vector3(9e-6f, 0, 0).normalized, Is.EqualTo(Vector3.zero));
    }

    [Test]
    public void Indexers_and_Set_reach_each_component_and_no_other()
    {
        Vector3 three = default;
        Vector4 four = default;
        Vector2 two = default;
        for (int i = 0; i < 4; i++)
        {
            four[i] = i + 1;
            if (i < 3)
                three[i] = i + 1;
            if (i < 2)
                two[i] = i + 1;
        }

        Assert.That(three, Is.EqualTo(new Vector3(1, 2, 3)));
        Assert.That(four, Is.EqualTo(new Vector4(1, 2, 3, 4)));
        Assert.That(two, Is.EqualTo(new Vector2(1, 2)));
        Assert.That((three[2], four[3], two[1]), Is.EqualTo((3f, 4f, 2f)));
        three.Set(7, 8, 9);
        four.Set(7, 8, 9, 10);
        two.Set(7, 8);
        Assert.That((three, four, two), Is.EqualTo((new Vector3(7, 8, 9), new Vector4(7, 8, 9, 10), new Vector2(7, 8))));
        Assert.That(() => three[3], Throws.TypeOf<IndexOutOfRangeException>());
        Assert.That(() => four[4], Throws.TypeOf<IndexOutOfRangeException>());
        Assert.That(() => two[-1], Throws.TypeOf<IndexOutOfRangeException>());
    }

    [Test]
    public void Two_is_equal_where_nearly_so_and_Equals_where_exactly_so()
    {
        Vector3 v = new(1, 2, 3), near = new(1.000001f, 2, 3);
        Assert.That(v == near, Is.True);
        Assert.That(v.Equals(near), Is.False);
        Assert.That(v != new Vector3(1.0001f, 2, 3), Is.True);
        Assert.That((Vector4)v == (Vector4)near, Is.True);
        Assert.That((Vector2)v == (Vector2)near, Is.True);
    }

    [Test]
    public void Between_two_vectors()
    {
        Vector3 a = new(0, 0, 0), b = new(10, 0, 0);
        Assert.That(Vector3.Lerp(a, b, 0.25f), Is.EqualTo(new Vector3(2.5f, 0, 0)));
        Assert.That(Vector3.Lerp(a, b, 2), Is.EqualTo(b));
        Assert.That(Vector3.LerpUnclamped(a, b, 2), Is.EqualTo(new Vector3(20, 0, 0)));
        Assert.That(Vector3.MoveTowards(a, b, 3), Is.EqualTo(new Vector3(3, 0, 0)));
        Assert.That(Vector3.MoveTowards(a, b, 30), Is.EqualTo(b));
    }

    [Test]
    public void Angles_and_projections()
    {
        Assert.That(Vector3.Angle(Vector3.right, new Vector3(1, 1, 0)), Is.EqualTo(45).Within(1e-5));
        Assert.That(Vector3.SignedAngle(Vector3.up, Vector3.right, Vector3.forward), Is.EqualTo(-90).Within(1e-5));
        Assert.That(Vector3.Angle(Vector3.zero, Vector3.up), Is.Zero);
        Assert.That(Vector3.Project(new Vector3(3, 4, 5), 2 * Vector3.up), Is.EqualTo(new Vector3(0, 4, 0)));
        Assert.That(Vector3.ProjectOnPlane(new Vector3(3, 4, 5), Vector3.up), Is.EqualTo(new Vector3(3, 0, 5)));
        Assert.That(Vector3.Reflect(new Vector3(1, -1, 0), Vector3.up), Is.EqualTo(new Vector3(1, 1, 0)));
    }

    [Test]
    public void A_Vector4_is_a_Vector3_with_zero_and_back_again_without_it()
    {
        Vector4 four = new Vector3(1, 2, 3);
        Vector3 three = new Vector4(1, 2, 3, 4);
        Vector3 flat = new Vector2(1, 2);
        Assert.That((four, three, flat), Is.EqualTo((new Vector4(1, 2, 3, 0), new Vector3(1, 2, 3), new Vector3(1, 2, 0))));
        Assert.That(Vector4.Dot(four, Vector4.one), Is.EqualTo(6));
    }

    [Test]
    public void Texts_have_two_decimals()
    {
        Assert.That(new Vector3(1, -2.345f, 3).ToString(), Is.EqualTo("(1.00, -2.35, 3.00)").Or.EqualTo("(1.00, -2.34, 3.00)"));
        Assert.That(new Vector3(1, 2, 3).ToString("F4"), Is.EqualTo("(1.0000, 2.0000, 3.0000)"));
    }

    [Test]
    public void Numbers_are_single()
    {
        // 2²⁴ + 1 is no float
        Assert.That((new Vector3(16777216, 0, 0) + new Vector3(1, 0, 0)).x, Is.EqualTo(16777216f));
    }
}
