using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Impossible operations on a body are refused by name and value, and leave it unchanged.</summary>
public sealed class RefusedPushTests
{
    private static readonly Vector3d Nan = new(0, double.NaN, 0), Infinite = new(0, 0, double.NegativeInfinity), Huge = new(1e308, 0, 0), J = new(1, 2, 3);

    private static IEnumerable<(string Name, Action<Body> Do)> NotFinite =>
        from vector in new[] { Nan, Infinite }
        from refused in new (string, Action<Body>)[]
        {
            ("force", body => body.ApplyForce(vector)),
            ("force", body => body.ApplyForce(vector, J, inBody: true)),
            ("point", body => body.ApplyForce(J, vector)),
            ("torque", body => body.ApplyTorque(vector)),
            ("impulse", body => body.ApplyImpulse(vector, inBody: true)),
            ("point", body => body.ApplyImpulse(J, vector, inBody: true)),
            ("impulse", body => body.ApplyAngularImpulse(vector)),
            ("velocity", body => body.State = new BodyState(J, Quaterniond.Identity, vector, J)),
            ("angularVelocity", body => body.State = new BodyState(J, Quaterniond.Identity, J, vector)),
            ("position", body => body.State = new BodyState(vector, Quaterniond.Identity, J, J)),
            ("orientation", body => body.State = new BodyState(J, default, J, J)),
        }
        select refused;

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Numbers_that_are_none(string rule)
    {
        foreach ((string name, Action<Body> act) in NotFinite)
            LeavesAll(rule, act, Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.StartsWith(name + ": must "));
    }

    [TestCase("LabEuler")]
    [TestCase("RungeKutta4")]
    [TestCase("Exact")]
    public void Impulse_after_which_no_velocity_would_be_finite(string rule)
    {
        LeavesAll(rule, body => body.ApplyImpulse(Huge), Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains("finite velocity"));
        LeavesAll(rule, body => body.ApplyAngularImpulse(Huge), Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains("finite velocity"));
        LeavesAll(rule, body => body.ApplyImpulse(Huge, new Vector3d(0, 1e10, 0)), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Forces_whose_sum_is_not_finite(string rule)
    {
        Simulation simulation = new(TimeSteps.Every(0.02));
        Body body = simulation.Add(Scenery.Busy(rule)), same = simulation.Add(Scenery.Busy(rule));
        body.ApplyForce(Huge);
        Assert.That(() => body.ApplyForce(Huge), Throws.TypeOf<OverflowException>().With.Message.StartsWith("body \"body\": "));
        // the first of them still waits, and can be taken back
        body.ApplyForce(-Huge);
        simulation.Step();
        Assert.That(body.State, Is.EqualTo(same.State));
    }

    [TestCase(-0.001)]
    [TestCase(1.001)]
    [TestCase(double.NaN)]
    public void Part_of_a_step_that_is_none(double alpha) =>
        LeavesAll("Exact", body => body.Between(alpha), Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.StartsWith("alpha: must be from 0 to 1"));

    [Test]
    public void Body_that_is_gone_and_body_of_another_simulation()
    {
        Simulation simulation = new(TimeSteps.Every(0.02)), other = new(TimeSteps.Every(0.02));
        Body gone = simulation.Add(Scenery.Busy("Exact", "gone"));
        simulation.Remove(gone);
        foreach (Action act in new Action[]
        {
            () => gone.ApplyForce(J), () => gone.ApplyTorque(J), () => gone.ApplyImpulse(J, J), () => gone.ApplyAngularImpulse(J),
            () => gone.State = BodyState.AtRest, () => gone.Change(Scenery.Body("Exact")), () => gone.Between(0.5), () => _ = gone.IsAsleep,
            () => _ = gone.KineticEnergy,
        })
        {
            Assert.That(act, Throws.InvalidOperationException.With.Message.Contains("\"gone\" (removed)"));
        }

        Body elsewhere = other.Add(Scenery.Body("Exact", "elsewhere"));
        Assert.That(() => simulation.Remove(elsewhere), Throws.ArgumentException.With.Message.Contains("\"elsewhere\""));
        Assert.That((other.Bodies.Count, gone.Name), Is.EqualTo((1, "gone")));
    }

    private static void LeavesAll(string rule, Action<Body> act, NUnit.Framework.Constraints.IResolveConstraint refusal)
    {
        Simulation simulation = new(TimeSteps.Every(0.02));
        Body body = simulation.Add(Scenery.Busy(rule));
        simulation.Step(7);
        BodyState before = body.State;
        BodyPlan plan = body.Plan;
        Assert.That(() => act(body), refusal);
        Assert.That((body.State, body.Plan, simulation.StepsDone), Is.EqualTo((before, plan, 7L)));
        Assert.That(() => simulation.Step(), Throws.Nothing);
    }
}
