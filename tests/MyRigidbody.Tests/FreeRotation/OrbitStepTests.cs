using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>The constants of a step against values computed to 18 digits.</summary>
public sealed class OrbitStepTests
{
    // moments (1, 2, 3); spin, step, then S, c1, c3 and cos(ψ/2) : |L| sin(ψ/2)
    // measured, S, c1 and c3 together: 0, 1.7e-16, 3.4e-15, 1.4e-13, 1.0e-17; the angle: 3.5e-18, 1.1e-16, 5.3e-15, 6.9e-18
    [TestCase(1, 1.1, 0.9, 0.02, 0.0199974003873628068, 0.999757366977775081, 0.999852694115625211, 0.999869681915842858, 0.0584972640878391517)]
    [TestCase(1, 1.1, 0.9, 0.5, 0.462822652555396326, 0.860289583009693369, 0.917715891937206428, 0.919980044430464354, 1.42029930133293895)]
    [TestCase(1, 1.1, 0.9, 10, 0.580750351082138034, -0.768620770855915054, 0.866916211959902779, 0.53451584630802624, 3.06246054601506956)]
    [TestCase(1, 1.1, 0.9, 1000, -0.865181981349874847, -0.302938336132904293, 0.669757893450059967, 0.695751407073820442, double.NaN)]
    [TestCase(0.001, 5, 0.001, 0.02, 0.0199778073657118023, 0.998335644814929701, 0.998335644948189088, 0.998750260320011378, 0.499791732674847059)]
    public void Constants_of_a_step_have_the_values_of_the_series_in_many_digits(
        double w1, double w2, double w3, double h, double s, double c1, double c3, double c, double z)
    {
        // the values are for moments 1, 2, 3; the library divides by the middle one, so |L| and Z are half as large
        TopShape shape = new(new Vector3d(1, 2, 3), Quaterniond.Identity);
        double a1 = shape.I1 * w1 * w1 + shape.G1 * w2 * w2, a3 = shape.I3 * w3 * w3 + shape.G3 * w2 * w2;
        double q = shape.M1 * w1 * w1 - shape.M3 * w3 * w3;
        foreach (int sign in new[] { 1, -1 })
        {
            OrbitStep step = default;
            step.Set(shape, a1, a3, q, sign * h);
            double bound = 4e-16 * (1 + 2 * h);
            Assert.That(step.S, Is.EqualTo(sign * s).Within(bound));
            Assert.That((step.C1, step.C3), Is.EqualTo((c1, c3)).Using<(double, double)>((x, y) =>
                Math.Abs(x.Item1 - y.Item1) < bound && Math.Abs(x.Item2 - y.Item2) < bound));
            double length = Math.Sqrt(shape.I1 * a1 + shape.I3 * a3);
            double angle = Math.Atan2(step.Sine * length, 1 - step.Versine), expected = Math.Atan2(sign * z / (2 * length), c);
            double turns = (angle - expected) / Math.PI, error = Math.Abs(turns - Math.Round(turns)) * Math.PI;
            TestContext.Out.WriteLine(FormattableString.Invariant($"error {error:g2}"));
            // after 1000 s the motion itself is held against a solution, in ExactMotionTests and FreeMotionTests
            if (!double.IsNaN(z))
                Assert.That(error, Is.LessThan(bound));
        }
    }
}
