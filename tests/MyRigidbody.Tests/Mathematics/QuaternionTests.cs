using System.Globalization;
using CsCheck;
using NUnit.Framework;
using static RigidBodyDynamics.Tests.Samples;

namespace RigidBodyDynamics.Tests;

public sealed class QuaternionTests
{
    private static readonly Gen<(Quaterniond Q, Vector3d V)> Turned = Gen.Select(Turns, Vectors);

    [Test]
    public void Basis_multiplies_as_Hamilton_carved_it_into_the_bridge()
    {
        Quaterniond i = new(0, 1, 0, 0), j = new(0, 0, 1, 0), k = new(0, 0, 0, 1), minusOne = new(-1, 0, 0, 0);
        Assert.That(new[] { i * i, j * j, k * k, i * j * k }, Is.All.EqualTo(minusOne).Using<Quaterniond>((a, b) => a == b));
        Assert.That(new[] { i * j, j * k, k * i }, Is.EqualTo(new[] { k, i, j }).Using<Quaterniond>((a, b) => a == b));
        Assert.That(new[] { j * i, k * j, i * k }, Is.EqualTo(new[] { -1 * k, -1 * i, -1 * j }).Using<Quaterniond>((a, b) => a == b));
    }

    [Test]
    public void Product_is_associative() => Property.Holds(
        Gen.Select(Turns, Turns, Turns),
        q => Apart(q.Item1 * q.Item2 * q.Item3, q.Item1 * (q.Item2 * q.Item3)),
        2e-15); // measured 3.3e-16

    [Test]
    public void Identity_changes_no_bit() =>
        Property.Always(Quaternions, q => q * Quaterniond.Identity == q && Quaterniond.Identity * q == q);

    [Test]
    public void Conjugate_is_the_inverse() => Property.Holds(
        Turns,
        q => Math.Max(Apart(q * q.Conjugate, Quaterniond.Identity), Apart(q.Conjugate * q, Quaterniond.Identity)),
        2e-15); // measured 6.7e-16

    [Test]
    public void Length_of_a_product_is_the_product_of_the_lengths() => Property.Holds(
        Gen.Select(Quaternions, Quaternions),
        q => Math.Abs((q.Item1 * q.Item2).Length / (q.Item1.Length * q.Item2.Length) - 1),
        2e-15); // measured 4.4e-16

    [Test]
    public void Rotate_is_the_matrix_times_the_vector() => Property.Holds(
        Turned,
        t => Apart(t.Q.Rotate(t.V), Matrix3.Of(t.Q) * t.V) / t.V.Length,
        4e-15); // measured 5.7e-16

    [Test]
    public void Rotate_is_the_product_q_v_conjugate() => Property.Holds(
        Turned,
        t => Apart(t.Q.Rotate(t.V), (t.Q * new Quaterniond(0, t.V) * t.Q.Conjugate).Vector) / t.V.Length,
        4e-15); // measured 8e-16

    [Test]
    public void RotateInverse_undoes_Rotate() => Property.Holds(
        Turned,
        t => Math.Max(
            Apart(t.Q.RotateInverse(t.Q.Rotate(t.V)), t.V),
            Apart(t.Q.Rotate(t.Q.RotateInverse(t.V)), t.V)) / t.V.Length,
        4e-15); // measured 2.4e-15

    [Test]
    public void RotateInverse_is_Rotate_by_the_conjugate() =>
        Property.Always(Turned, t => t.Q.RotateInverse(t.V) == t.Q.Conjugate.Rotate(t.V));

    [Test]
    public void Product_turns_as_one_after_the_other() => Property.Holds(
        Gen.Select(Turns, Turns, Vectors),
        t => Apart((t.Item1 * t.Item2).Rotate(t.Item3), t.Item1.Rotate(t.Item2.Rotate(t.Item3))) / t.Item3.Length,
        6e-15); // measured 1.6e-15

    [Test]
    public void Quaternion_and_its_opposite_are_the_same_turn() =>
        Property.Always(Turned, t => t.Q.Rotate(t.V) == (-1.0 * t.Q).Rotate(t.V));

    [Test]
    public void Turn_keeps_lengths_and_handedness() => Property.Holds(
        Gen.Select(Turns, Vectors, Vectors),
        t =>
        {
            Vector3d a = t.Item1.Rotate(t.Item2), b = t.Item1.Rotate(t.Item3);
            double bulk = t.Item2.Length * t.Item3.Length;
            double hand = Apart(Vector3d.Cross(a, b), t.Item1.Rotate(Vector3d.Cross(t.Item2, t.Item3))) / bulk;
            double angle = Math.Abs(Vector3d.Dot(a, b) - Vector3d.Dot(t.Item2, t.Item3)) / bulk;
            return Math.Max(hand, angle);
        },
        6e-15); // measured 2e-15

    [Test]
    public void FromAxisAngle_turns_as_Rodrigues_formula_says() => Property.Holds(
        Gen.Select(Axes, Angles, Vectors),
        t =>
        {
            (Vector3d n, double angle, Vector3d v) = t;
            Vector3d expected = Math.Cos(angle) * v + Math.Sin(angle) * Vector3d.Cross(n, v)
                + (1 - Math.Cos(angle)) * Vector3d.Dot(n, v) * n;
            return Apart(Quaterniond.FromAxisAngle(7 * n, angle).Rotate(v), expected) / v.Length;
        },
        6e-15); // measured 1.3e-15

    [Test]
    public void FromAxisAngle_holds_half_the_angle_even_of_a_tiny_turn()
    {
        Quaterniond q = Quaterniond.FromAxisAngle(new Vector3d(0, 0, 2), 1e-160);
        Assert.That(q.Z, Is.EqualTo(0.5e-160));
        Assert.That(q.W, Is.EqualTo(1));
    }

    [Test]
    public void Quarter_turn_about_z_takes_x_to_y()
    {
        Quaterniond q = Quaterniond.FromAxisAngle(new Vector3d(0, 0, 1), Math.PI / 2);
        Assert.That(Apart(q.Rotate(new Vector3d(1, 0, 0)), new Vector3d(0, 1, 0)), Is.LessThan(5e-16)); // measured 2.2e-16
    }

    [Test]
    public void Angles_about_one_axis_add() => Property.Holds(
        Gen.Select(Axes, Angles, Angles),
        t => Apart(
            Quaterniond.FromAxisAngle(t.Item1, t.Item2) * Quaterniond.FromAxisAngle(t.Item1, t.Item3),
            Quaterniond.FromAxisAngle(t.Item1, t.Item2 + t.Item3)),
        4e-15); // measured 6.7e-16

    [Test]
    public void Normalized_has_length_one_and_the_same_direction() => Property.Holds(
        Gen.Select(Turns, Gen.Double[-90, 90]),
        t =>
        {
            Quaterniond unit = (Math.Pow(10, t.Item2) * t.Item1).Normalized;
            return Math.Max(Math.Abs(unit.Length - 1), Apart(unit, t.Item1));
        },
        1e-15); // measured 4.4e-16

    [Test]
    public void Matrix_columns_are_the_turned_axes() => Property.Holds(
        Turns,
        q =>
        {
            Matrix3 m = Matrix3.Of(q);
            Vector3d x = new(m.Row1.X, m.Row2.X, m.Row3.X), y = new(m.Row1.Y, m.Row2.Y, m.Row3.Y), z = new(m.Row1.Z, m.Row2.Z, m.Row3.Z);
            return Math.Max(
                Apart(x, q.Rotate(new Vector3d(1, 0, 0))),
                Math.Max(Apart(y, q.Rotate(new Vector3d(0, 1, 0))), Apart(z, q.Rotate(new Vector3d(0, 0, 1)))));
        },
        2e-15); // measured 4.9e-324

    [Test]
    public void Angle_between_orientations_is_that_of_the_turn_between_them() => Property.Holds(
        Gen.Select(Turns, Axes, Gen.OneOf<double>(Gen.Double[0, Math.PI], Gen.OneOf(0, 1e-8, 1e-12, Math.PI))),
        t =>
        {
            Quaterniond turn = new(Math.Cos(0.5 * t.Item3), Math.Sin(0.5 * t.Item3) * t.Item2);
            double there = Conserved.AngleBetween(t.Item1, t.Item1 * turn);
            double opposite = Conserved.AngleBetween(t.Item1, -1.0 * (t.Item1 * turn));
            return Math.Max(Math.Abs(there - t.Item3), Math.Abs(opposite - t.Item3));
        },
        4e-15); // measured 6.7e-16

    [Test]
    public void Text_reads_back_to_the_same_bits() => Property.Always(Quaternions, q =>
    {
        double[] read = [.. q.ToString().Trim('[', ']').Split(", ").Select(s => double.Parse(s, CultureInfo.InvariantCulture))];
        return new Quaterniond(read[0], read[1], read[2], read[3]).Equals(q);
    });

    [Test]
    public void Equality_is_of_components_without_tolerance()
    {
        Quaterniond q = new(1, 2, 3, 4);
        Assert.That(q == new Quaterniond(1, 2, 3, 4) && q.Equals((object)new Quaterniond(1, 2, 3, 4)), Is.True);
        Assert.That(q.GetHashCode(), Is.EqualTo(new Quaterniond(1, 2, 3, 4).GetHashCode()));
        Assert.That(
            new Quaterniond[] { new(1, 2, 3, 4.000000000000001), new(1, 2, 0, 4), new(1, 0, 3, 4), new(0, 2, 3, 4) },
            Has.None.Matches<Quaterniond>(other => other == q || !(other != q) || other.Equals(q)));
    }

    [Test]
    public void Product_of_two_turns_differs_from_that_the_other_way_round()
    {
        Quaterniond x = Quaterniond.FromAxisAngle(new Vector3d(1, 0, 0), 1), y = Quaterniond.FromAxisAngle(new Vector3d(0, 1, 0), 1);
        Assert.That((x * y).Z, Is.EqualTo(Math.Sin(0.5) * Math.Sin(0.5)).Within(1e-16)); // measured 0
        Assert.That((y * x).Z, Is.EqualTo(-Math.Sin(0.5) * Math.Sin(0.5)).Within(1e-16)); // measured 0
    }

    [Test]
    public void Slerp_turns_evenly_about_one_axis() => Property.Holds(
        Gen.Select(Turns, Axes, Gen.OneOf<double>(Gen.Double[-3.14, 3.14], Gen.OneOf(0, 1e-8, -1e-12, 1e-160, 1.5707963267948966)), Gen.Double[-0.5, 1.5]),
        s =>
        {
            (Quaterniond a, Vector3d axis, double angle, double t) = s;
            Quaterniond expected = a * Turn(axis, t * angle), b = a * Turn(axis, angle);
            return Math.Max(Apart(Quaterniond.Slerp(a, b, t), expected), Apart(Quaterniond.Slerp(a, -1 * b, t), expected));
        },
        2e-15); // measured 3.3e-16

    [Test]
    public void Slerp_keeps_the_digits_of_a_small_turn()
    {
        Quaterniond a = Quaterniond.Identity, b = new(1, 3e-12, -4e-12, 0);
        Quaterniond part = Quaterniond.Slerp(a, b, 0.3);
        Assert.That(Apart(1e12 * part.Vector, new Vector3d(0.9, -1.2, 0)), Is.LessThan(1e-15)); // measured 0
    }

    [Test]
    public void Chord_and_arc_meet_at_the_ends_and_in_the_middle() => Property.Holds(
        Gen.Select(Turns, Turns),
        s =>
        {
            (Quaterniond a, Quaterniond b) = s;
            Quaterniond near = Quaterniond.Dot(a, b) < 0 ? -1 * b : b;
            double ends = Math.Max(Apart(Quaterniond.Nlerp(a, b, 0), a), Apart(Quaterniond.Nlerp(a, b, 1), near));
            ends = Math.Max(ends, Math.Max(Apart(Quaterniond.Slerp(a, b, 0), a), Apart(Quaterniond.Slerp(a, b, 1), near)));
            return Math.Max(ends, Apart(Quaterniond.Nlerp(a, b, 0.5), Quaterniond.Slerp(a, b, 0.5)));
        },
        2e-15); // measured 3.3e-16

    [Test]
    public void Chord_is_slower_at_the_ends_than_the_arc_and_on_the_same_circle()
    {
        Vector3d axis = new Vector3d(1, -2, 2) / 3;
        Quaterniond tenth = Quaterniond.Nlerp(Quaterniond.Identity, Turn(axis, 2), 0.1);
        // tan of the half angle: 0.1 sin 1 / (0.9 + 0.1 cos 1)
        double half = Math.Atan(0.1 * Math.Sin(1) / (0.9 + 0.1 * Math.Cos(1)));
        Assert.That(Apart(tenth, Turn(axis, 2 * half)), Is.LessThan(2e-16)); // measured 1.4e-17
        Assert.That(half, Is.LessThan(0.1));
    }

    [Test]
    public void Scalar_product_is_the_cosine_of_half_the_angle_and_knows_the_sign()
    {
        Quaterniond a = new(0.5, 0.5, -0.5, 0.5), b = a * Turn(new Vector3d(0, 0.6, 0.8), 1.4);
        Assert.That(Quaterniond.Dot(a, b), Is.EqualTo(Math.Cos(0.7)).Within(2e-16)); // measured 0
        Assert.That(Quaterniond.Dot(a, -1 * b), Is.EqualTo(-Quaterniond.Dot(a, b)));
        Assert.That(Quaterniond.Dot(new Quaterniond(1, 2, 3, 4), new Quaterniond(5, 6, 7, 8)), Is.EqualTo(70));
    }

    private static Quaterniond Turn(Vector3d axis, double angle) => new(Math.Cos(0.5 * angle), Math.Sin(0.5 * angle) * axis);
}
