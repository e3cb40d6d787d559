using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>A state that is set is valid from now on; time and effects continue.</summary>
public sealed class SetStateTests
{
    private const double H = 1 / 64.0;

    private static readonly BodyState Elsewhere =
        new(new Vector3d(-4, 0.5, 7), new Quaterniond(0.1, -0.7, 0.5, 0.5).Normalized, new Vector3d(0, 3, -1), new Vector3d(-2, 0.3, 1.4));

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Body_goes_on_as_one_that_came_in_that_state(string rule)
    {
        Simulation simulation = new(TimeSteps.Every(H));
        Body set = simulation.Add(Scenery.Busy(rule, "set"));
        simulation.Step(23);
        set.State = Elsewhere;
        BodyDescription there = Scenery.Busy(rule, "there");
        there.Start = Elsewhere;
        Body came = simulation.Add(there);
        for (int n = 0; n < 60; n++)
        {
            Assert.That(set.State, Is.EqualTo(came.State), "step " + n);
            simulation.Step();
        }
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Body_in_the_last_step_before_a_window_goes_on_into_it(string rule)
    {
        // 1 s of 2 N on 2 kg, whatever it did before
        Simulation simulation = new(TimeSteps.Every(H));
        BodyDescription waiting = Scenery.Body(rule).With(new Force(new Vector3d(2, 0, 0)), 0.5, 1.5);
        waiting.Unity.Drag = 0;
        Body body = simulation.Add(waiting);
        simulation.Step(32);
        BodyState still = body.State;
        still.Velocity = Vector3d.Zero;
        body.State = still;
        simulation.Step(100);
        Assert.That(body.State.Velocity.X, Is.EqualTo(1).Within(rule == "UnityRigidbody" ? 1e-6 : 1e-14)); // measured 0
    }

    [Test]
    public void Others_do_not_feel_it()
    {
        Simulation simulation = new(TimeSteps.Every(H), Scenery.Body("Exact", "a"), Scenery.Busy("Exact", "b"));
        Simulation same = new(TimeSteps.Every(H), Scenery.Body("Exact", "a"), Scenery.Busy("Exact", "b"));
        simulation.Step(150);
        simulation.Bodies[0].State = Elsewhere;
        simulation.Step(150);
        same.Step(300);
        Assert.That(simulation.Bodies[1].State, Is.EqualTo(same.Bodies[1].State));
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void What_had_been_left_out_is_there_when_a_state_asks_for_it_and_explain_says_so(string rule)
    {
        Simulation simulation = new(TimeSteps.Every(H));
        BodyDescription resting = Scenery.Body(rule);
        resting.Start = BodyState.AtRest;
        Body body = simulation.Add(resting);
        simulation.Step(5);
        BodyState spinning = BodyState.AtRest;
        spinning.AngularVelocity = new Vector3d(1, 2, 3);
        body.State = spinning;
        Assert.That(body.Plan.LeftOut, Is.EqualTo(Omissions.Translation));
        Assert.That(new Explanation(body).ToString(), Does.Not.Contain("left out: rotation (").And.Contain("left out: translation ("));
        simulation.Step(5);
        Assert.That(Conserved.AngleBetween(body.State.Orientation, Quaterniond.Identity), Is.EqualTo(Math.Sqrt(14) * 5 * H).Within(0.02)); // measured 1.0e-3
    }

    [Test]
    public void Orientation_of_another_length_is_scaled()
    {
        Simulation simulation = new(TimeSteps.Every(H));
        Body body = simulation.Add(Scenery.Body("Exact"));
        body.State = new BodyState(Vector3d.Zero, new Quaterniond(0, 3, 0, 4), Vector3d.Zero, Vector3d.Zero);
        Assert.That(Samples.Apart(body.State.Orientation, new Quaterniond(0, 0.6, 0, 0.8)), Is.LessThan(3e-16)); // measured 0
    }

    [TestCase("LabEuler")]
    [TestCase("RungeKutta4")]
    [TestCase("Splitting")]
    [TestCase("Exact")]
    public void Body_that_has_diverged_comes_back_when_its_state_is_set(string rule)
    {
        // after a hundred seconds the square of its velocity does not fit
        BodyDescription heavy = new BodyDescription("heavy", Scenery.Body(rule).Mass) { Rule = Rules.Named(rule) }.With(new Gravity(new Vector3d(0, -1e153, 0)));
        BodyState spinning = BodyState.AtRest;
        spinning.AngularVelocity = new Vector3d(1, 2, 3);
        foreach (BodyState respawn in new[] { BodyState.AtRest, spinning })
        {
            Simulation simulation = new(TimeSteps.Every(1));
            Body body = simulation.Add(heavy);
            Assert.That(
                () =>
                {
                    simulation.Step(150);
                    _ = body.State;
                },
                Throws.TypeOf<StateOverflowException>());
            body.State = respawn;
            body.Change(new BodyDescription("calm", heavy.Mass));
            Assert.That(Samples.Apart(body.State.AngularVelocity, respawn.AngularVelocity), Is.LessThan(2e-15)); // measured 4.4e-16
            Assert.That(() => simulation.Step(150), Throws.Nothing);
            Assert.That(Samples.Apart(body.State.Velocity, Vector3d.Zero), Is.Zero);
        }
    }
}
