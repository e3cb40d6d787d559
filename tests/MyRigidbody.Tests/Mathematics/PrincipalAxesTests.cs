using CsCheck;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

public sealed class PrincipalAxesTests
{
    private static readonly Gen<double> Scales = Gen.Int[-18, 18].Select(digits => Math.Pow(10, digits));

    private static readonly Gen<SymmetricMatrix3> FarApart = Gen.Select(
        Samples.Turns,
        Gen.Double[-12, 0],
        Gen.Double[-12, 0],
        Scales,
        (q, a, b, s) => Turned(s * new Vector3d(1, Math.Pow(10, a), Math.Pow(10, b)), q));

    private static readonly Gen<SymmetricMatrix3> AlmostEqual = Gen.Select(
        Samples.Turns,
        Gen.Int[-9, 9],
        Gen.Int[-9, 9],
        Scales,
        (q, a, b, s) => Turned(s * new Vector3d(1, 1 + a * 2.2e-16, 1 + b * 1e-12), q));

    private static readonly Gen<SymmetricMatrix3> SixNumbers = Gen.Select(
        Samples.Vectors, Samples.Vectors, Scales, (d, o, s) => new SymmetricMatrix3(s * d, s * o));

    private static readonly Gen<SymmetricMatrix3> BarelyTilted = Gen.Select(
        Samples.Vectors, Samples.Vectors, Gen.Double[-20, -8], (d, o, digits) => new SymmetricMatrix3(d, Math.Pow(10, digits) * o));

    [Test]
    public void Frame_and_moments_rebuild_a_tensor_with_moments_a_million_million_apart() =>
        Property.Holds(FarApart, ErrorOfRebuilding, 8e-15, 5000); // measured 1.3e-15

    [Test]
    public void Frame_and_moments_rebuild_a_tensor_with_almost_equal_moments() =>
        Property.Holds(AlmostEqual, ErrorOfRebuilding, 8e-15, 5000); // measured 8e-16

    [Test]
    public void Frame_and_moments_rebuild_any_six_numbers() =>
        Property.Holds(SixNumbers, ErrorOfRebuilding, 8e-15, 5000); // measured 2e-15

    [Test]
    public void Frame_and_moments_rebuild_a_tensor_that_is_almost_diagonal() =>
        Property.Holds(BarelyTilted, ErrorOfRebuilding, 8e-15, 5000); // measured 4.4e-16

    [Test]
    public void Frame_has_length_one() => Property.Holds(
        Gen.OneOf<SymmetricMatrix3>(FarApart, AlmostEqual, SixNumbers, BarelyTilted),
        a =>
        {
            PrincipalAxes.Of(a, out Quaterniond frame);
            return Math.Abs(frame.Length - 1);
        },
        4e-16, // measured 2.2e-16
        5000);

    [Test]
    public void Moments_are_those_the_tensor_was_made_of() => Property.Holds(
        Gen.Select(Samples.Turns, Gen.Double[-12, 0], Gen.Double[-12, 0]),
        t =>
        {
            double[] made = [1, Math.Pow(10, t.Item2), Math.Pow(10, t.Item3)];
            Vector3d found = PrincipalAxes.Of(Turned(new Vector3d(made[0], made[1], made[2]), t.Item1), out Quaterniond _);
            double[] sorted = [found.X, found.Y, found.Z];
            Array.Sort(made);
            Array.Sort(sorted);
            return made.Zip(sorted, (a, b) => Math.Abs(a - b)).Max();
        },
        4e-15); // measured 1e-15

    [Test]
    public void Diagonal_tensor_keeps_its_axes_and_their_order() => Property.Always(
        Gen.Select(Gen.Double[0.01, 100], Gen.Double[0.01, 100], Gen.Double[0.01, 100], Scales),
        t =>
        {
            Vector3d moments = t.Item4 * new Vector3d(t.Item1, t.Item2, t.Item3);
            Vector3d found = PrincipalAxes.Of(new SymmetricMatrix3(moments, Vector3d.Zero), out Quaterniond frame);
            // scaling to 1 and back may round once
            return frame == Quaterniond.Identity
                && Math.Abs(found.X - moments.X) <= Math.BitIncrement(moments.X) - moments.X
                && Math.Abs(found.Y - moments.Y) <= Math.BitIncrement(moments.Y) - moments.Y
                && Math.Abs(found.Z - moments.Z) <= Math.BitIncrement(moments.Z) - moments.Z;
        });

    [Test]
    public void Nothing_at_all_has_no_moments() =>
        Assert.That(PrincipalAxes.Of(default, out Quaterniond _), Is.EqualTo(Vector3d.Zero));

    [TestCase(1e-300)]
    [TestCase(1e300)]
    public void Tensor_near_the_ends_of_double_is_diagonalised_as_well(double scale)
    {
        Quaterniond turn = new Quaterniond(0.8, 0.2, -0.4, 0.4).Normalized;
        SymmetricMatrix3 tensor = Turned(scale * new Vector3d(1, 2, 2.5), turn);
        Assert.That(ErrorOfRebuilding(tensor), Is.LessThan(8e-15)); // measured 3e-16
    }

    private static SymmetricMatrix3 Turned(Vector3d moments, Quaterniond q) => FullMatrix.Symmetric(FullMatrix.Tensor(moments, q));

    private static double ErrorOfRebuilding(SymmetricMatrix3 a)
    {
        Vector3d moments = PrincipalAxes.Of(a, out Quaterniond frame);
        double[,] given = FullMatrix.Of(a);
        return FullMatrix.Apart(FullMatrix.Tensor(moments, frame), given) / FullMatrix.Size(given);
    }
}
