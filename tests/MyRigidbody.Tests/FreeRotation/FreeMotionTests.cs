using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>The state of a coasting body at any time, in one call.</summary>
public sealed class FreeMotionTests
{
    // measured, in floors: 3.0, 0.7, 4.0, 1.5, 7.3, 1.5, 6.4, 1.1, 7.7
    [TestCase("asym_moderate")]
    [TestCase("sym_top")]
    [TestCase("tiny")]
    [TestCase("dzhanibekov_1e-3")]
    [TestCase("dzhanibekov_1e-8")]
    [TestCase("separatrix")]
    [TestCase("plate")]
    [TestCase("needle")]
    [TestCase("fast_spin")]
    public void State_at_any_time_is_as_good_as_its_inputs(string name)
    {
        ExactCase solved = ExactCase.Read(name);
        FreeMotion motion = new(SolvedScene.Body(solved, "Exact"));
        double worst = 0, floor = 0;
        foreach (ExactCase.Sample sample in solved.Samples.Skip(1))
        {
            floor = Math.Max(floor, sample["double_attainable_error"]);
            worst = Math.Max(worst, Conserved.AngleBetween(motion.At(sample.Time).Orientation, sample.Orientation) / floor);
        }

        TestContext.Out.WriteLine(FormattableString.Invariant($"{worst:g2} floors"));
        Assert.That(worst, Is.LessThan(15));
    }

    [Test]
    public void State_after_200_s_in_one_call_is_right_to_1e_13()
    {
        ExactCase solved = ExactCase.Read("asym_moderate");
        FreeMotion motion = new(SolvedScene.Body(solved, "Exact"));
        ExactCase.Sample sample = solved.Samples.Single(s => s.Time == 200);
        double error = Conserved.AngleBetween(motion.At(200).Orientation, sample.Orientation);
        Assert.That(error, Is.LessThan(1e-13).And.GreaterThan(0)); // measured 9.6e-15
    }

    [Test]
    public void Time_runs_backwards_as_well()
    {
        BodyDescription body = Scenery.Body("Exact").With(new Gravity(new Vector3d(0, -9.81, 0))).With(new LinearDamping(0.3)).With(new AngularDamping(0.2));
        BodyState there = new FreeMotion(body).At(3);
        BodyDescription after = body.Copy("later", body.Mass);
        after.Start = there;
        BodyState back = new FreeMotion(after).At(-3), start = new FreeMotion(body).At(0);
        Assert.That(Conserved.AngleBetween(back.Orientation, start.Orientation), Is.LessThan(1e-14)); // measured 2.1e-15
        Assert.That(Samples.Apart(back.Position, start.Position), Is.LessThan(1e-13)); // measured 3.8e-14
        Assert.That(Samples.Apart(back.AngularVelocity, start.AngularVelocity), Is.LessThan(1e-14)); // measured 6.7e-16
        Assert.That(Samples.Apart(back.Velocity, start.Velocity), Is.LessThan(1e-14)); // measured 0
    }

    [Test]
    public void Damped_fall_runs_backwards_through_many_times_constant()
    {
        // v = v₀ e^(−ct) and x = v₀ (1 − e^(−ct))/c: with c = 2 twenty and forty decay times back
        BodyDescription body = new BodyDescription("ball", Solids.Sphere(1, 0.5)).With(new LinearDamping(2)).With(new AngularDamping(2));
        body.Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(3, 0, 0), new Vector3d(0, 1e-20, 0));
        foreach (double time in new[] { -1.0, -5, -10, -20 })
        {
            BodyState state = new FreeMotion(body).At(time);
            Assert.That(state.Velocity.X, Is.EqualTo(3 * Math.Exp(-2 * time)).Within(1e-13).Percent); // measured 0
            Assert.That(state.Position.X, Is.EqualTo(3 * (1 - Math.Exp(-2 * time)) / 2).Within(1e-13).Percent); // measured 0
            Assert.That(state.AngularVelocity.Y, Is.EqualTo(1e-20 * Math.Exp(-2 * time)).Within(1e-13).Percent); // measured 1.8e-14
        }
    }

    // three moments different, two equal, all equal
    [TestCase(1, 2, 2.5)]
    [TestCase(2, 2, 1)]
    [TestCase(2, 2, 2)]
    public void Unit_of_the_moments_does_not_matter(double i1, double i2, double i3)
    {
        foreach (double unit in new[] { 1e-300, 1e-170, 1e-18, 1e18, 1e150, 1e300 })
        {
            foreach (Rule rule in Rules.All.Where(rule => rule.Keeps.HasFlag(Keeps.Motion)))
            {
                BodyState here = Run(1, rule.Name), there = Run(unit, rule.Name);
                Assert.That(Conserved.AngleBetween(here.Orientation, there.Orientation), Is.LessThan(1e-13), rule.Name); // measured 8.2e-15
            }

            BodyState Run(double scale, string integrator)
            {
                BodyDescription body = new("b", MassProperties.FromPrincipal(1, scale * new Vector3d(i1, i2, i3))) { Rule = Rules.Named(integrator) };
                body.Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, new Vector3d(1, 2, -1.5));
                return Scenery.Run(TimeSteps.Every(0.02, 100), body, 100);
            }
        }
    }

    // three moments different, two equal, all equal
    [TestCase(1, 2, 2.5)]
    [TestCase(2, 2, 1)]
    [TestCase(2, 2, 2)]
    public void Damped_rotation_is_free_rotation_in_a_slower_time_at_any_step(double i1, double i2, double i3)
    {
        // L' = L × ω − c L with L = e^(−ct) M is M' = M × ω(M) in the time s = (1 − e^(−ct))/c
        const double C = 0.3;
        BodyDescription free = new("free", MassProperties.FromPrincipal(1, new Vector3d(i1, i2, i3)));
        free.Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, new Vector3d(1, 2, -1.5));
        BodyDescription damped = free.Copy("damped", free.Mass).With(new AngularDamping(C));
        damped.Rule = Rules.Exact;
        FreeMotion motion = new(free);
        foreach (double step in new[] { 0.01, 0.1, 1, 10 })
        {
            Simulation simulation = Scenery.Stepped(TimeSteps.Every(step), damped);
            simulation.Step((long)Math.Round(10 / step));
            double s = (1 - Math.Exp(-C * 10)) / C;
            BodyState right = motion.At(s), found = simulation.Bodies[0].State;
            double angle = Conserved.AngleBetween(found.Orientation, right.Orientation);
            TestContext.Out.WriteLine(FormattableString.Invariant($"step {step}: {angle:g2} rad"));
            Assert.That(angle, Is.LessThan(2e-14)); // measured 3.7e-15
            Assert.That(
                Samples.Apart(found.AngularVelocity, Math.Exp(-C * 10) * right.AngularVelocity) / found.AngularVelocity.Length,
                Is.LessThan(1e-14)); // measured 2.3e-15
        }
    }

    [Test]
    public void Fall_with_drag_proportional_to_velocity_needs_no_steps()
    {
        ExactCase solved = ExactCase.Read("fall_linear_drag");
        BodyDescription body = new BodyDescription("ball", Solids.Sphere(1, 0.5))
            .With(new Gravity(new Vector3d(0, -9.81, 0))).With(new LinearDamping(0.3));
        FreeMotion motion = new(body);
        foreach (ExactCase.Sample sample in solved.Samples)
            Assert.That(Samples.Apart(motion.At(sample.Time).Position, sample.Position), Is.LessThan(5e-13)); // measured 2.3e-13 of 870 m
    }

    [Test]
    public void What_has_no_closed_form_is_refused_by_name()
    {
        BodyDescription Body() => new("b", Solids.Sphere(1, 1));
        Assert.That(() => new FreeMotion(Body().With(new KeyPush(LabKey.R))), Refuses("effects[0]"));
        Assert.That(() => new FreeMotion(Body().With(new LinearDamping(1)).With(new Gravity(Vector3d.Zero), 0, 1)), Refuses("effects[1]"));
        Assert.That(() => new FreeMotion(Body().With(new Gravity(Vector3d.Zero), 0.5)), Refuses("effects[0]"));
        Assert.That(() => new FreeMotion(Body().With(new DecayPerStep(0.98, 1))), Refuses("effects"));
        Assert.That(() => new FreeMotion(Body()).At(double.NaN), Refuses("time"));
        Assert.That(() => new FreeMotion(Body()).At(double.PositiveInfinity), Refuses("time"));

        static NUnit.Framework.Constraints.IResolveConstraint Refuses(string name) =>
            Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains(name);
    }
}
