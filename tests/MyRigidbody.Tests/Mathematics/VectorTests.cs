using System.Globalization;
using CsCheck;
using NUnit.Framework;
using static RigidBodyDynamics.Tests.Samples;

namespace RigidBodyDynamics.Tests;

public sealed class VectorTests
{
    private static readonly Vector3d A = new(1, 2, 3);
    private static readonly Vector3d B = new(4, -5, 6);

    [Test]
    public void Sum_difference_and_multiples_go_component_by_component()
    {
        Assert.That(A + B, Is.EqualTo(new Vector3d(5, -3, 9)));
        Assert.That(A - B, Is.EqualTo(new Vector3d(-3, 7, -3)));
        Assert.That(-B, Is.EqualTo(new Vector3d(-4, 5, -6)));
        Assert.That(2 * A, Is.EqualTo(new Vector3d(2, 4, 6)));
        Assert.That(A * 2, Is.EqualTo(new Vector3d(2, 4, 6)));
        Assert.That(B / 2, Is.EqualTo(new Vector3d(2, -2.5, 3)));
        Assert.That(Vector3d.Scale(A, B), Is.EqualTo(new Vector3d(4, -10, 18)));
    }

    [Test]
    public void Normalized_has_length_one_in_the_same_direction_whatever_the_length() => Property.Holds(
        Gen.Select(Vectors, Gen.Double[-300, 300]),
        s =>
        {
            Vector3d unit = (Math.Pow(10, s.Item2) * s.Item1).Normalized;
            return Math.Max(Math.Abs(unit.Length - 1), Apart(unit, s.Item1 / s.Item1.Length));
        },
        1e-15); // measured 3.3e-16

    [Test]
    public void Zero_has_no_direction_and_normalized_stays_zero() => Assert.That(Vector3d.Zero.Normalized, Is.EqualTo(Vector3d.Zero));

    [Test]
    public void Scalar_product_and_length_follow_Pythagoras()
    {
        Assert.That(Vector3d.Dot(A, B), Is.EqualTo(4 - 10 + 18));
        Assert.That(new Vector3d(2, 3, 6).Length, Is.EqualTo(7));
        Assert.That(new Vector3d(2, 3, 6).LengthSquared, Is.EqualTo(49));
    }

    [Test]
    public void Vector_product_follows_the_right_hand()
    {
        Vector3d x = new(1, 0, 0), y = new(0, 1, 0), z = new(0, 0, 1);
        Assert.That(new[] { Vector3d.Cross(x, y), Vector3d.Cross(y, z), Vector3d.Cross(z, x) }, Is.EqualTo(new[] { z, x, y }));
        Assert.That(Vector3d.Cross(A, B), Is.EqualTo(new Vector3d(2 * 6 + 3 * 5, 3 * 4 - 6, -5 - 2 * 4)));
    }

    [Test]
    public void Vector_product_is_normal_to_both_and_as_long_as_their_parallelogram() => Property.Holds(
        Gen.Select(Vectors, Vectors),
        t =>
        {
            (Vector3d a, Vector3d b) = t;
            Vector3d c = Vector3d.Cross(a, b);
            double bulk = a.LengthSquared * b.LengthSquared, dot = Vector3d.Dot(a, b);
            double normal = Math.Max(
                Math.Abs(Vector3d.Dot(a, c)) / (a.Length * bulk), Math.Abs(Vector3d.Dot(b, c)) / (b.Length * bulk));
            return Math.Max(normal * Math.Sqrt(bulk), Math.Abs(c.LengthSquared + dot * dot - bulk) / bulk);
        },
        4e-15); // measured 6.9e-16

    [Test]
    public void Finite_means_no_infinity_and_no_NaN()
    {
        Assert.That(new Vector3d(double.MaxValue, -double.MaxValue, 5e-324).IsFinite, Is.True);
        foreach (double bad in new[] { double.NaN, double.PositiveInfinity, double.NegativeInfinity })
            Assert.That(new Vector3d(bad, 0, 0).IsFinite || new Vector3d(0, bad, 0).IsFinite || new Vector3d(0, 0, bad).IsFinite, Is.False);
    }

    [Test]
    public void Zero_is_zero_of_either_sign()
    {
        Assert.That(new Vector3d(0, -0.0, 0).IsZero, Is.True);
        Assert.That(new Vector3d(5e-324, 0, 0).IsZero || new Vector3d(0, 5e-324, 0).IsZero || new Vector3d(0, 0, 5e-324).IsZero, Is.False);
    }

    [Test]
    public void Text_reads_back_to_the_same_bits() => Property.Always(Vectors, v =>
    {
        double[] read = [.. v.ToString().Trim('(', ')').Split(", ").Select(s => double.Parse(s, CultureInfo.InvariantCulture))];
        return new Vector3d(read[0], read[1], read[2]).Equals(v);
    });

    [Test]
    public void Equality_is_of_components_without_tolerance()
    {
        Assert.That(A == new Vector3d(1, 2, 3) && A.Equals((object)new Vector3d(1, 2, 3)), Is.True);
        Assert.That(A.GetHashCode(), Is.EqualTo(new Vector3d(1, 2, 3).GetHashCode()));
        Assert.That(
            new[] { new Vector3d(1.0000000000000002, 2, 3), new Vector3d(1, 0, 3), new Vector3d(1, 2, 0) },
            Has.None.Matches<Vector3d>(other => other == A || !(other != A) || other.Equals(A)));
    }
}
