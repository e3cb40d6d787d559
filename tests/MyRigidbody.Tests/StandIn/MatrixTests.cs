using NUnit.Framework;
using UnityEngine;

namespace RigidBodyDynamics.Tests.StandIn;

/// <summary>The stand-in's matrix does what Unity's manual says of each member.</summary>
public sealed class MatrixTests
{
    private static readonly Matrix4x4 Counted = new(new Vector4(0, 1, 2, 3), new Vector4(4, 5, 6, 7), new Vector4(8, 9, 10, 11), new Vector4(12, 13, 14, 15));

    [Test]
    public void One_index_counts_down_the_columns_two_are_row_and_column()
    {
        for (int row = 0; row < 4; row++)
        {
            for (int column = 0; column < 4; column++)
            {
                Assert.That(Counted[row, column], Is.EqualTo(row + 4 * column));
                Assert.That(Counted[row + 4 * column], Is.EqualTo(row + 4 * column));
            }
        }

        Assert.That((Counted.m01, Counted.m10, Counted.m23), Is.EqualTo((4f, 1f, 14f)));
        Assert.That(() => Counted[16], Throws.TypeOf<IndexOutOfRangeException>());
    }

    [Test]
    public void Indexers_write()
    {
        Matrix4x4 m = default;
        for (int i = 0; i < 16; i++)
            m[i] = i;

        Assert.That(m, Is.EqualTo(Counted));
        m[1, 2] = -1;
        Assert.That((m.m12, m[9]), Is.EqualTo((-1f, -1f)));
    }

    [Test]
    public void Columns_and_rows()
    {
        Assert.That(Counted.GetColumn(1), Is.EqualTo(new Vector4(4, 5, 6, 7)));
        Assert.That(Counted.GetRow(1), Is.EqualTo(new Vector4(1, 5, 9, 13)));
        Matrix4x4 m = Matrix4x4.zero;
        m.SetColumn(1, new Vector4(1, 2, 3, 4));
        m.SetRow(3, new Vector4(5, 6, 7, 8));
        Assert.That((m.m01, m.m11, m.m21, m.m30, m.m31, m.m33), Is.EqualTo((1f, 2f, 3f, 5f, 6f, 8f)));
        Assert.That(() => Counted.GetRow(4), Throws.TypeOf<IndexOutOfRangeException>());
    }

    [Test]
    public void Identity_and_zero()
    {
        Assert.That(Matrix4x4.identity.isIdentity, Is.True);
        Assert.That(Counted * Matrix4x4.identity, Is.EqualTo(Counted));
        Assert.That(default(Matrix4x4), Is.EqualTo(Matrix4x4.zero));
    }

    [Test]
    public void The_transpose_has_rows_for_columns()
    {
        Assert.That(Counted.transpose[1, 2], Is.EqualTo(Counted[2, 1]));
        Assert.That(Matrix4x4.Transpose(Counted), Is.EqualTo(Counted.transpose));
    }

    [Test]
    public void A_product_is_row_times_column()
    {
        Matrix4x4 square = Counted * Counted.transpose;
        Assert.That(square[1, 2], Is.EqualTo(1 * 2 + 5 * 6 + 9 * 10 + 13 * 14));
        Assert.That(Counted * new Vector4(1, 0, 2, 0), Is.EqualTo(new Vector4(16, 19, 22, 25)));
    }

    [Test]
    public void Points_are_moved_and_vectors_are_not()
    {
        Matrix4x4 m = Matrix4x4.TRS(new Vector3(10, 20, 30), Quaternion.AngleAxis(90, Vector3.forward), new Vector3(2, 3, 4));
        Assert.That(m.MultiplyPoint3x4(Vector3.right) == new Vector3(10, 22, 30), Is.True);
        Assert.That(m.MultiplyPoint(Vector3.right) == m.MultiplyPoint3x4(Vector3.right), Is.True);
        Assert.That(m.MultiplyVector(Vector3.right) == new Vector3(0, 2, 0), Is.True);
        Assert.That(m.GetPosition(), Is.EqualTo(new Vector3(10, 20, 30)));
        Assert.That(m.lossyScale == new Vector3(2, 3, 4), Is.True);
        Assert.That(m.rotation == Quaternion.AngleAxis(90, Vector3.forward), Is.True);
        Matrix4x4 projection = Matrix4x4.identity;
        projection.m33 = 2;
        Assert.That(projection.MultiplyPoint(new Vector3(2, 4, 6)), Is.EqualTo(new Vector3(1, 2, 3)));
        Assert.That(Matrix4x4.Translate(new Vector3(1, 2, 3)).MultiplyPoint(Vector3.one), Is.EqualTo(new Vector3(2, 3, 4)));
    }

    [TestCase(30, 1, 2, 3)]
    [TestCase(170, -1, 0, 2)]
    [TestCase(180, 0, 1, 0)]
    public void Rotate_is_the_turn_of_the_quaternion(float angle, float x, float y, float z)
    {
        Quaternion q = Quaternion.AngleAxis(angle, new Vector3(x, y, z));
        Matrix4x4 r = Matrix4x4.Rotate(q);
        Vector3 v = new(0.3f, -2, 1);
        Assert.That(r.MultiplyVector(v) == q * v, Is.True);
        Assert.That(r.determinant, Is.EqualTo(1).Within(1e-6));
        Assert.That((r * r.transpose).isIdentity, Is.True);
        Assert.That(Quaternion.Angle(r.rotation, q), Is.LessThan(0.05));
    }

    [Test]
    public void Rotate_of_a_longer_quaternion_is_no_rotation() =>
        Assert.That(Matrix4x4.Rotate(new Quaternion(0, 0, 0.2f, 1)).determinant, Is.EqualTo(0.92 * 0.92 + 0.4 * 0.4).Within(1e-6));

    [Test]
    public void The_inverse_undoes()
    {
        Matrix4x4 m = Matrix4x4.TRS(new Vector3(1, 2, 3), Quaternion.Euler(10, 20, 30), new Vector3(1, 2, 4));
        Assert.That((m * m.inverse).isIdentity, Is.True);
        Assert.That(Matrix4x4.Inverse(m), Is.EqualTo(m.inverse));
        Assert.That(m.determinant, Is.EqualTo(8).Within(1e-5));
        Assert.That(Matrix4x4.Scale(new Vector3(2, 4, 8)).inverse, Is.EqualTo(Matrix4x4.Scale(new Vector3(0.5f, 0.25f, 0.125f))));
    }

    [Test]
    public void The_inverse_of_a_singular_matrix_is_zero()
    {
        Matrix4x4 inertia = Matrix4x4.Scale(new Vector3(0.5f, 0.5f, 0.5f));
        inertia.m33 = 0;
        Assert.That(inertia.inverse, Is.EqualTo(Matrix4x4.zero));
        Assert.That(Counted.inverse, Is.EqualTo(Matrix4x4.zero), "rows 1, 2 and 3 are in arithmetic progression");
        Assert.That(Matrix4x4.Determinant(inertia), Is.Zero);
    }

    [Test]
    public void Equal_is_nearly_so()
    {
        Matrix4x4 near = Matrix4x4.identity;
        near.m11 = 1.000001f;
        Assert.That(near == Matrix4x4.identity, Is.True);
        Assert.That(near.Equals(Matrix4x4.identity), Is.False);
    }
}
