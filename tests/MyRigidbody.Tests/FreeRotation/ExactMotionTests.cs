using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Free bodies, with steps of 1/50 s, against solutions to 20 digits.</summary>
public sealed class ExactMotionTests
{
    private const double Step = 0.02;

    // measured, in running maxima of the floor: 0.5, 0.6, 0.8, 0.04, 0.003, 0.2, 0.7, 1.4, 0.4, 0.8
    [TestCase("asym_moderate")]
    [TestCase("sym_top")]
    [TestCase("tiny")]
    [TestCase("dzhanibekov_1e-3")]
    [TestCase("dzhanibekov_1e-8")]
    [TestCase("intermediate_axis")]
    [TestCase("separatrix")]
    [TestCase("plate")]
    [TestCase("needle")]
    [TestCase("fast_spin")]
    public void Free_body_stays_within_five_times_what_the_last_bit_of_its_inputs_does(string name)
    {
        double worst = 0;
        int samples = 0;
        SolvedScene.Run(ExactCase.Read(name), "Exact", Step, (state, sample, floor) =>
        {
            worst = Math.Max(worst, Conserved.AngleBetween(state.Orientation, sample.Orientation) / floor);
            samples++;
        });
        TestContext.Out.WriteLine(FormattableString.Invariant($"{worst:g2} floors at {samples} samples"));
        Assert.That(samples, Is.GreaterThanOrEqualTo(10));
        Assert.That(worst, Is.LessThan(5));
    }

    // a thousand radians a step: of the first, which is prepared for once, no digit may be left out either
    [Test]
    public void Spin_of_a_thousand_radians_a_step_is_as_exact_as_its_inputs_from_the_first_step_on()
    {
        double worst = 0;
        SolvedScene.Run(ExactCase.Read("fast_spin"), "Exact", 0.1, (state, sample, floor) =>
            worst = Math.Max(worst, Conserved.AngleBetween(state.Orientation, sample.Orientation) / floor));
        TestContext.Out.WriteLine(FormattableString.Invariant($"{worst:g2} floors"));
        Assert.That(worst, Is.LessThan(1));
    }

    [Test]
    public void Body_that_cannot_exist_moves_as_the_equations_say()
    {
        // moments 1e-8, 1, 1.5: none of a real body, so a scene refuses it; 29 rad a step all the same
        ExactCase solved = ExactCase.Read("extreme");
        AsymmetricTop top = default;
        top.Start(new TopShape(new Vector3d(1e-8, 1, 1.5), Quaterniond.Identity), Quaterniondd.Unit(Quaterniond.Identity), new Vector3d(100, 0.2, 0.1));
        double worst = 0, floor = 0;
        int done = 0;
        foreach (ExactCase.Sample sample in solved.Samples)
        {
            floor = Math.Max(floor, sample["double_attainable_error"]);
            int steps = (int)Math.Round(sample.Time / Step);
            if (steps < 1 || Math.Abs(steps * Step - sample.Time) > 1e-9)
                continue;

            for (; done < steps; done++)
                top.Advance(Step);

            worst = Math.Max(worst, Conserved.AngleBetween(top.Orientation, sample.Orientation) / floor);
        }

        Assert.That(done, Is.EqualTo(500));
        Assert.That(worst, Is.LessThan(0.01)); // measured 0.0017
    }

    [Test]
    public void Asymmetric_top_is_right_to_1e_13_after_100_s_and_to_1e_12_after_1000_s()
    {
        double after100 = 0, after1000 = 0;
        SolvedScene.Run(ExactCase.Read("asym_moderate"), "Exact", Step, (state, sample, _) =>
        {
            double error = Conserved.AngleBetween(state.Orientation, sample.Orientation);
            after100 = sample.Time <= 100 ? Math.Max(after100, error) : after100;
            after1000 = Math.Max(after1000, error);
        });
        TestContext.Out.WriteLine(FormattableString.Invariant($"{after100:g2} and {after1000:g2} rad"));
        Assert.That(after100, Is.LessThan(1e-13).And.GreaterThan(0)); // measured 4.8e-15
        Assert.That(after1000, Is.LessThan(1e-12)); // measured 5.8e-14
    }

    // the same assertion the exact step passes
    [TestCase("ImplicitGyroscopic", 1)] // measured 2.5 rad
    [TestCase("ExplicitGyroscopic", 1)] // measured 3.0 rad
    [TestCase("LabEuler", 1)] // measured 2.6 rad
    [TestCase("Splitting", 1e-4)] // measured 1.3e-3 rad
    [TestCase("RungeKutta4", 1e-7)] // measured 2.1e-6 rad
    public void Other_integrators_have_lost_the_asymmetric_top_after_100_s(string integrator, double atLeast)
    {
        double worst = 0;
        SolvedScene.Run(ExactCase.Read("asym_moderate"), integrator, Step, (state, sample, _) =>
            worst = sample.Time <= 100 ? Math.Max(worst, Conserved.AngleBetween(state.Orientation, sample.Orientation)) : worst);
        TestContext.Out.WriteLine(FormattableString.Invariant($"{worst:g2} rad"));
        Assert.That(worst, Is.GreaterThan(atLeast));
    }

    // 8000 steps with twelve pushes each; energy and Q taken from the rounded ω instead of carried: 1500 and 1600 floors
    [TestCase("body_torque")] // measured 18
    [TestCase("world_torque")] // measured 16
    public void Energy_and_Q_are_carried_through_pushes_so_that_roundings_do_not_add_up(string name)
    {
        double worst = 0;
        SolvedScene.Run(ExactCase.Read(name), "Exact6", 0.0025, (state, sample, floor) =>
            worst = Math.Max(worst, Conserved.AngleBetween(state.Orientation, sample.Orientation) / floor));
        TestContext.Out.WriteLine(FormattableString.Invariant($"{worst:g2} floors"));
        Assert.That(worst, Is.LessThan(40).And.GreaterThan(0));
    }

    [Test]
    public void Tumbling_slab_flips_nine_times_in_a_minute()
    {
        ExactCase solved = ExactCase.Read("dzhanibekov_1e-3");
        Simulation simulation = Scenery.Stepped(TimeSteps.Every(Step), SolvedScene.Body(solved, "Exact"));
        int flips = 0;
        double side = 1;
        for (int i = 0; i < 3000; i++)
        {
            simulation.Step();
            BodyState state = simulation.Bodies[0].State;
            double about2 = state.Orientation.RotateInverse(state.AngularVelocity).Y;
            if (about2 * side < 0)
            {
                flips++;
                side = -side;
            }
        }

        Assert.That(flips, Is.EqualTo(9));
    }

    // of a top, of one near its unstable axis, of a needle; up to 1e18 rad in a step, where no angle is left to be known
    [TestCase(1, 1e9, 1)]
    [TestCase(1e-9, 1, 2e-9)]
    [TestCase(1e3, 1, 0)]
    public void Energy_and_momentum_outlast_steps_of_any_length(double w1, double w2, double w3)
    {
        foreach (double step in new[] { 1.0, 1e3, 1e6, 1e9 })
        {
            BodyDescription body = new("b", MassProperties.FromPrincipal(1, new Vector3d(1, 2, 3)))
            {
                Rule = Rules.Exact,
                Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, new Vector3d(w1, w2, w3)),
            };
            Simulation simulation = Scenery.Stepped(TimeSteps.Every(step), body);
            double energy = simulation.Bodies[0].KineticEnergy;
            Vector3d momentum = simulation.Bodies[0].AngularMomentum;
            simulation.Step(100);
            Assert.That(simulation.Bodies[0].KineticEnergy / energy, Is.EqualTo(1).Within(1e-14)); // measured 8.9e-16
            Assert.That(
                (simulation.Bodies[0].AngularMomentum - momentum).Length / momentum.Length, Is.LessThan(1e-13)); // measured 3.4e-14
        }
    }

    // 20 steps of 50 s and one of 1000 s: hundreds of rad each
    [TestCase(50)] // measured 0.37
    [TestCase(1000)] // measured 0.66
    public void Step_may_be_as_long_as_one_likes(double step)
    {
        double worst = 0;
        SolvedScene.Run(ExactCase.Read("asym_moderate"), "Exact", step, (state, sample, floor) =>
            worst = Math.Max(worst, Conserved.AngleBetween(state.Orientation, sample.Orientation) / floor));
        TestContext.Out.WriteLine(FormattableString.Invariant($"{worst:g2} floors"));
        Assert.That(worst, Is.LessThan(10).And.GreaterThan(0));
    }
}
