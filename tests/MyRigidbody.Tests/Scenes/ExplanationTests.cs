using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>The simulation does what a body's plan says.</summary>
public sealed class ExplanationTests
{
    [TestCase("Exact", 1, 2, 3, "free rotation of a body with three different moments (exact)")]
    [TestCase("Exact6", 2, 3, 2, "free rotation of a body with two equal moments (exact)")]
    [TestCase("Exact4", 2, 2, 2, "free rotation of a body with three equal moments (exact)")]
    [TestCase("Splitting", 1, 2, 3, "free rotation, split into three (order 2)")]
    [TestCase("RungeKutta4", 1, 2, 3, "rotation by RungeKutta4")]
    [TestCase("LabEuler", 1, 2, 3, "rotation by LabEuler (no gyroscopic term)")]
    public void Rotation_is_named_for_what_it_is(string integrator, double i1, double i2, double i3, string words)
    {
        BodyDescription body = Top(integrator, new Vector3d(i1, i2, i3));
        Assert.That(Parts(body), Is.EqualTo(new[] { "drift", words }));
    }

    [Test]
    public void Parts_follow_the_windows_of_the_effects()
    {
        BodyDescription body = Top("Exact", new Vector3d(1, 2, 3))
            .With(new Gravity(new Vector3d(0, -9.81, 0)))
            .With(new LinearDamping(0.3), 1)
            .With(new KeyPush(LabKey.R), 1, 2);
        BodyPlan plan = new Simulation(TimeSteps.Every(0.02), body).Bodies[0].Plan;
        Explanation explanation = new(plan);
        const string Falls = "gravity (0, -9.81, 0) m/s² (closed form)", Turns = "free rotation of a body with three different moments (exact)";
        Assert.That(plan.Stretches.Select(explanation.Time), Is.EqualTo(new[] { "0 s to 1 s", "1 s to 2 s", "from 2 s" }));
        Assert.That(explanation.Parts(plan.Stretches[0]), Is.EqualTo(new[] { "drift", Falls, Turns }));
        Assert.That(explanation.Parts(plan.Stretches[1]), Is.EqualTo(new[] { "drift", Falls, "linear damping 0.3 /s (closed form)", Turns, "key R" }));
        Assert.That(plan.Stretches.Select(explanation.Coasts), Is.EqualTo(new[] { true, false, true }));
        Assert.That(explanation.Omitted.Select(omission => omission.What), Is.EqualTo(new[] { "steps whose states are not read", "drag" }));
        Assert.That(explanation.ToString(), Does.StartWith("top, by Exact\n  0 s to 1 s: drift, ").And.Contain("; computed when its state is read\n").And.Contain("  left out: drag (none in the scene)\n"));
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void What_is_said_to_coast_is_dormant_and_nothing_else(string integrator)
    {
        foreach (Vector3d spin in new Vector3d[] { new(1, 1.1, 0.9), new(1e-3, 5, 1e-3), Vector3d.Zero })
        {
            foreach ((bool isPushed, bool canMove, bool canTurn) in new[] { (false, true, true), (true, true, true), (false, true, false), (false, false, true) })
            {
                BodyDescription like = Scenery.Body(integrator), body = Top(like.Rule.Name, new Vector3d(1, 2, 3));
                body.Unity = like.Unity;
                body.Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, canMove ? spin : Vector3d.Zero, canTurn ? spin : Vector3d.Zero);
                (body.CanMove, body.CanTurn) = (canMove, canTurn);
                if (isPushed)
                    body.With(new KeyPush(LabKey.R));

                Body built = new Simulation(TimeSteps.Every(0.02), body).Bodies[0];
                Assert.That(new Explanation(built.Plan).Coasts(built.Plan.Stretches[0]), Is.EqualTo(built.IsDormant), $"{spin} {isPushed} {canMove} {canTurn}");
            }
        }
    }

    [Test]
    public void Each_thing_left_out_comes_with_a_body_that_has_it()
    {
        BodyDescription[] bodies =
        [
            Top("Exact", new Vector3d(1, 2, 3)), Top("Exact", new Vector3d(2, 2, 2)), Top("Exact", new Vector3d(1e-6, 1, 1)),
            Top("Exact", new Vector3d(1, 1, 2)), new("at rest", Solids.Sphere(1, 1)),
        ];
        foreach (BodyDescription body in bodies)
        {
            BodyPlan plan = new Simulation(TimeSteps.Every(0.02), body).Bodies[0].Plan;
            Explanation explanation = new(plan);
            Assert.That(explanation.Omitted, Has.Count.GreaterThanOrEqualTo(3));
            foreach (Omission omission in explanation.Omitted)
            {
                Simulation with = new(new SceneDescription("with", string.Empty, plan.Steps, [omission.With]), omission.MayLeaveOut);
                with.Step(10);
                Assert.That(with.Bodies[0].State.IsFinite, omission.What);
                Assert.That(new Explanation(with.Bodies[0]).Omitted.Select(other => other.What), Does.Not.Contain(omission.What));
            }
        }
    }

    [Test]
    public void Body_that_rests_says_so_and_why()
    {
        BodyDescription body = new("stone", Solids.Sphere(1, 1));
        Assert.That(Parts(body), Is.EqualTo(new[] { "rest" }));
        string text = new Explanation(new Simulation(TimeSteps.Every(0.02), body).Bodies[0]).ToString();
        Assert.That(text, Does.Contain("rotation (it starts without angular velocity and no torque acts)"));
        Assert.That(text, Does.Contain("translation (it starts at rest and nothing moves it)"));
    }

    [TestCase(0.01, "swings are stable in steps below 0.2 s")]
    [TestCase(0.25, "swings are stable in steps below 0.2 s, and the scene's is 0.25 s")]
    public void Spring_says_its_longest_step(double step, string note)
    {
        BodyDescription body = Top("Exact", new Vector3d(1, 2, 3)).With(new Spring(Vector3d.Zero, Vector3d.Zero, 100));
        Explanation explanation = new(new Simulation(TimeSteps.Every(step), body).Bodies[0]);
        Assert.That(explanation.Notes, Has.Count.EqualTo(1));
        Assert.That(explanation.Notes[0], Does.EndWith(note));
    }

    [Test]
    public void Effect_of_a_user_s_own_says_what_it_is()
    {
        BodyDescription body = Top("Exact", new Vector3d(1, 2, 3));
        Assert.That(LeftOut(body), Is.EqualTo(new[] { "steps whose states are not read", "gravity", "damping", "drag", "forces and torques" }));
        Assert.That(LeftOut(Copy().With(new Wind(0.1, new Vector3d(1, 0, 0), Vector3d.Zero))), Is.EqualTo(new[] { "gravity", "damping" }));
        Assert.That(LeftOut(Copy().With(new Force(new Vector3d(1, 0, 0)))), Does.Contain("gravity"));
        foreach ((EffectTraits trait, string what) in new[] { (EffectTraits.IsGravity, "gravity"), (EffectTraits.IsDamping, "damping"), (EffectTraits.IsDrag, "drag") })
        {
            Declared mine = new(new Force(new Vector3d(1, 0, 0)), EffectTraits.Moves | trait);
            Assert.That(LeftOut(Copy().With(mine)), Does.Not.Contain(what).And.Count.EqualTo(2), what);
        }

        BodyDescription Copy() => body.Copy("copy", body.Mass);
        static List<string> LeftOut(BodyDescription body) =>
            [.. new Explanation(new Simulation(TimeSteps.Every(0.02), body).Bodies[0]).Omitted.Select(omission => omission.What)];
    }

    [Test]
    public void Swing_of_a_user_s_own_says_its_longest_step()
    {
        Explanation explanation = new(new Simulation(TimeSteps.Every(0.5), Top("Exact", new Vector3d(1, 2, 3)).With(default(Pendulum))).Bodies[0]);
        Assert.That(explanation.Notes, Is.EqualTo(new[] { "pendulum: swings are stable in steps below 0.4 s, and the scene's is 0.5 s" }));
    }

    /// <summary>Swings with ω = 5 rad/s about the origin.</summary>
    private readonly struct Pendulum : IPush, ISwing
    {
        public EffectTraits Traits => EffectTraits.Moves | EffectTraits.ReadsPosition;

        public void At(in Instant now, in BodyState body, MassProperties mass, ref Wrench wrench) => wrench.Force -= 25 * mass.Mass * body.Position;

        public void Over(in Instant now, double duration, in BodyState body, MassProperties mass, ref Wrench impulse) =>
            impulse.Force -= 25 * duration * mass.Mass * body.Position;

        public double LongestStableStep(MassProperties mass) => 2.0 / 5;

        public override string ToString() => "pendulum";
    }

    [Test]
    public void Unity_s_body_says_what_it_does_of_itself()
    {
        BodyDescription body = Top("UnityRigidbody", new Vector3d(1, 2, 3));
        Assert.That(Parts(body), Does.Contain("drag 0 /s, angularDrag 0.05 /s, limit 7 rad/s, sleep below 0.005 J/kg of the velocity summed over 0.2 s"));
    }

    private static IReadOnlyList<string> Parts(BodyDescription body)
    {
        BodyPlan plan = new Simulation(TimeSteps.Every(0.02), body).Bodies[0].Plan;
        return new Explanation(plan).Parts(plan.Stretches[0]);
    }

    private static BodyDescription Top(string integrator, Vector3d moments) => new("top", MassProperties.FromPrincipal(1, moments))
    {
        Rule = Rules.Named(integrator),
        Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(1, 2, 3), new Vector3d(1, 1.1, 0.9)),
    };
}
