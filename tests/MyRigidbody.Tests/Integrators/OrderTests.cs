using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>The order that the catalogue declares is the observed order, where the integrator converges.</summary>
public sealed class OrderTests
{
    // where an integrator is exact there is no order to observe; measured at most 5.7e-13
    private const double Exact = 1e-11;

    private static IEnumerable<string> RuleNames => Rules.All.Select(rule => rule.Name);

    // measured: 1.00, 1.98 to 2.00, 3.94 to 4.01; the error of Exact6 is 6.7e-14
    [TestCaseSource(nameof(RuleNames))]
    public void Rotation_of_a_cube_under_the_key_R_converges_with_the_declared_order(string integrator)
    {
        ExactCase.Sample end = ExactCase.Read("cube_sin_torque").Samples[^1];
        Quaterniond closedForm = Quaterniond.FromAxisAngle(new Vector3d(1, 1, 1), 6 * Math.Sqrt(3) * (10 - Math.Sin(10)));
        Assert.That(Conserved.AngleBetween(closedForm, end.Orientation), Is.LessThan(5e-14)); // measured 6.5e-15

        AssertOrder(integrator, 10, body => body.With(new KeyPush(LabKey.R)), state => Math.Max(
            Conserved.AngleBetween(state.Orientation, closedForm), Samples.Apart(state.AngularVelocity, end.AngularVelocity)));
    }

    // measured: 1.00 for each of order 1; the errors of the others are at most 5.7e-13
    [TestCaseSource(nameof(RuleNames))]
    public void Fall_under_a_constant_force_converges_with_the_declared_order(string integrator) => AssertOrder(
        integrator,
        2,
        body => body.With(new Force(new Vector3d(3, 0, 0))).With(new Gravity(new Vector3d(0, -9.81, 0))),
        // x = F t²/2m, y = −g t²/2, v = F t/m
        state => Samples.Apart(state.Position, new Vector3d(6, -19.62, 0)) + Samples.Apart(state.Velocity, new Vector3d(6, -19.62, 0)));

    // measured, over all of them: 1.00 to 1.01, 2.00, 3.92 to 4.03, 5.96 to 6.14
    [TestCaseSource(nameof(Torqued))]
    public void Tumbling_under_a_torque_converges_with_the_declared_order(string integrator, string motion)
    {
        ExactCase solved = ExactCase.Read(motion);
        int order = Rules.Named(integrator).Order;
        double coarse = double.NaN, observed = double.NaN;
        for (double step = 0.5; step > 1e-5; step /= 2)
        {
            double fine = SolvedScene.ErrorAtEnd(solved, integrator, step);
            // below it the roundings of all steps count; far above it the error is no power of the step yet
            if (fine < 20 * 2e-16 * (20 / step))
                break;

            observed = coarse < 0.1 ? Math.Log2(coarse / fine) : double.NaN;
            TestContext.Out.WriteLine(FormattableString.Invariant($"step {step}: {fine:g3} rad, order {observed:f2}"));
            coarse = fine;
        }

        Assert.That(observed, Is.EqualTo(order).Within(0.2));
    }

    private static IEnumerable<object[]> Torqued =>
        from rule in Rules.All
        where rule.Keeps.HasFlag(Keeps.Motion)
        from motion in new[] { "body_torque", "world_torque", "lagrange_top" }
        select new object[] { rule.Name, motion };

    [Test]
    public void Names_are_unique_found_exactly_as_written_and_default_to_one_of_them()
    {
        Assert.That(RuleNames, Is.Unique);
        foreach (Rule rule in Rules.All)
        {
            Assert.That(Rules.Named(rule.Name), Is.SameAs(rule));
            Assert.That(rule.Order, Is.GreaterThanOrEqualTo(1));
            Assert.That(rule.About, Is.Not.Empty.And.Not.Contains("\n"));
        }

        Assert.That(Rules.All, Does.Contain(Rules.Default));
        Assert.That(() => Rules.Named("labeuler"), Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains("labeuler"));
    }

    private static void AssertOrder(string integrator, double time, Action<BodyDescription> describe, Func<BodyState, double> error)
    {
        int order = Rules.Named(integrator).Order;
        // far enough down that a small term of the declared order is not hidden by a large one of the next
        int steps = order == 1 ? 64_000 : 4000 / (order * order);
        double coarse = Error(steps), fine = Error(2 * steps);
        double observed = Math.Log2(coarse / fine);
        TestContext.Out.WriteLine(FormattableString.Invariant($"errors {coarse:g3} and {fine:g3}, order {observed:f3}"));
        if (coarse > Exact)
            Assert.That(observed, Is.EqualTo(order).Within(0.2));
        else
            Assert.That(fine, Is.LessThan(Exact));

        double Error(int count)
        {
            BodyDescription body = new("cube", Solids.Box(1, new Vector3d(1, 1, 1)))
            {
                Rule = Rules.Named(integrator),
                Unity = new UnitySettings
                {
                    AngularDrag = 0,
                    MaxAngularVelocity = double.PositiveInfinity,
                    SleepThreshold = 0,
                    InDouble = true,
                },
            };
            describe(body);
            return error(Scenery.Run(TimeSteps.Every(time / count, count), body, count));
        }
    }
}
