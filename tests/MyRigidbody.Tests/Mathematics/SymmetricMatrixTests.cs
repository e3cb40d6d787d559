using CsCheck;
using NUnit.Framework;
using static RigidBodyDynamics.Tests.Samples;

namespace RigidBodyDynamics.Tests;

public sealed class SymmetricMatrixTests
{
    private static readonly Gen<SymmetricMatrix3> AnySix = Gen.Select(Vectors, Vectors, (d, o) => new SymmetricMatrix3(d, o));
    private static readonly SymmetricMatrix3 A = new(new Vector3d(1, 2, 3), new Vector3d(4, 5, 6));

    private static readonly Gen<SymmetricMatrix3> Tensors = Gen.Select(
        Turns,
        Gen.Double[0.5, 8],
        Gen.Double[0.5, 8],
        Gen.Double[0.5, 8],
        (q, a, b, c) => new SymmetricMatrix3(new Vector3d(a, b, c), Vector3d.Zero).RotatedBy(Matrix3.Of(q)));

    [Test]
    public void Six_numbers_go_where_their_names_say()
    {
        SymmetricMatrix3 a = new() { XX = 1, XY = 2, XZ = 3, YY = 4, YZ = 5, ZZ = 6 };
        Assert.That(a * new Vector3d(1, 10, 100), Is.EqualTo(new Vector3d(321, 542, 653)));
        Assert.That((a.XX, a.XY, a.XZ, a.YY, a.YZ, a.ZZ), Is.EqualTo((1.0, 2.0, 3.0, 4.0, 5.0, 6.0)));
        Assert.That(a.ToString(), Is.EqualTo("xx 1, yy 4, zz 6, yz 5, xz 3, xy 2"));
        Assert.That(typeof(SymmetricMatrix3).GetConstructors(), Is.Empty, "a list of six numbers goes in several orders");
    }

    // a mass at (1, 2, 0) and one at (−1, −2, 0): Ixy = −Σ m x y
    [Test]
    public void Products_of_inertia_have_the_sign_of_the_tensor()
    {
        SymmetricMatrix3 found = PointMasses.Of([new(1, 2, 0), new(-1, -2, 0), new(0, 0, 1), new(0, 0, -1)], [0.5, 0.5, 1, 1]).Inertia;
        SymmetricMatrix3 expected = new() { XX = 6, YY = 3, ZZ = 5, XY = -2 };
        Assert.That(Math.Max(Apart(found.Diagonal, expected.Diagonal), Apart(found.OffDiagonal, expected.OffDiagonal)), Is.LessThan(1e-14)); // measured 0
    }

    [Test]
    public void Product_with_a_vector_is_that_of_the_full_matrix() => Property.Holds(
        Gen.Select(AnySix, Vectors),
        t =>
        {
            double[,] a = FullMatrix.Of(t.Item1);
            double[] v = [t.Item2.X, t.Item2.Y, t.Item2.Z];
            double[] p = new double[3];
            for (int i = 0; i < 9; i++)
                p[i / 3] += a[i / 3, i % 3] * v[i % 3];
            return Apart(t.Item1 * t.Item2, new Vector3d(p[0], p[1], p[2])) / FullMatrix.Size(a) / t.Item2.Length;
        },
        1e-15); // measured 0: the same sums in the same order

    [Test]
    public void RotatedBy_is_the_triple_product_R_A_R_transposed() => Property.Holds(
        Gen.Select(AnySix, Turns),
        t => ErrorOfTriple(t.Item1, Matrix3.Of(t.Item2)),
        6e-15); // measured 8e-16

    [Test]
    public void RotatedBy_is_the_triple_product_even_of_a_matrix_that_is_no_rotation() => Property.Holds(
        Gen.Select(AnySix, Vectors, Vectors, Vectors),
        t => ErrorOfTriple(t.Item1, new Matrix3(t.Item2, t.Item3, t.Item4)),
        6e-15); // measured 6.5e-16

    [Test]
    public void Inverse_times_the_tensor_is_one() => Property.Holds(
        Tensors,
        a => Math.Max(
            FullMatrix.Apart(FullMatrix.Product(FullMatrix.Of(a.Inverse), FullMatrix.Of(a)), FullMatrix.Of(SymmetricMatrix3.Identity)),
            FullMatrix.Apart(FullMatrix.Product(FullMatrix.Of(a), FullMatrix.Of(a.Inverse)), FullMatrix.Of(SymmetricMatrix3.Identity))),
        2e-14); // measured 1.3e-15, where the moments are 16 to 1

    [Test]
    public void Inverse_of_a_tensor_of_whole_numbers_is_the_one_on_paper()
    {
        // det = 1·(6 − 16) + 6·(20 − 18) + 5·(24 − 10) = 72
        SymmetricMatrix3 inverse = A.Inverse;
        SymmetricMatrix3 expected = 1.0 / 72 * new SymmetricMatrix3(new Vector3d(-10, -22, -34), new Vector3d(26, 14, 2));
        Assert.That(Apart(inverse.Diagonal, expected.Diagonal), Is.LessThan(1e-16)); // measured 0
        Assert.That(Apart(inverse.OffDiagonal, expected.OffDiagonal), Is.LessThan(1e-16)); // measured 0
    }

    [Test]
    public void Sum_difference_and_multiple_go_entry_by_entry()
    {
        SymmetricMatrix3 b = new(new Vector3d(10, 20, 30), new Vector3d(40, 50, 60));
        Assert.That((A + b).Diagonal, Is.EqualTo(new Vector3d(11, 22, 33)));
        Assert.That((A + b).OffDiagonal, Is.EqualTo(new Vector3d(44, 55, 66)));
        Assert.That((b - A).Diagonal, Is.EqualTo(new Vector3d(9, 18, 27)));
        Assert.That((b - A).OffDiagonal, Is.EqualTo(new Vector3d(36, 45, 54)));
        Assert.That((2 * A).Diagonal, Is.EqualTo(new Vector3d(2, 4, 6)));
        Assert.That((2 * A).OffDiagonal, Is.EqualTo(new Vector3d(8, 10, 12)));
    }

    [Test]
    public void Outer_product_holds_every_product_of_two_components()
    {
        SymmetricMatrix3 outer = SymmetricMatrix3.Outer(new Vector3d(2, 3, 5));
        Assert.That(outer.Diagonal, Is.EqualTo(new Vector3d(4, 9, 25)));
        Assert.That(outer.OffDiagonal, Is.EqualTo(new Vector3d(15, 10, 6)));
    }

    [Test]
    public void Text_names_all_six_numbers() =>
        Assert.That(A.ToString(), Is.EqualTo("xx 1, yy 2, zz 3, yz 4, xz 5, xy 6"));

    private static double ErrorOfTriple(SymmetricMatrix3 a, Matrix3 r)
    {
        double[,] full = FullMatrix.Of(r);
        double[,] expected = FullMatrix.Product(full, FullMatrix.Product(FullMatrix.Of(a), FullMatrix.Transposed(full)));
        double size = FullMatrix.Size(full);
        return FullMatrix.Apart(FullMatrix.Of(a.RotatedBy(r)), expected) / (FullMatrix.Size(FullMatrix.Of(a)) * size * size);
    }
}
