using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>
/// A free box keeps its angular momentum and so changes its angular velocity. Neither the lab's integrator nor Unity's has
/// the gyroscopic term: the assertion that a right integrator passes, they fail.
/// </summary>
public sealed class TumblingTests
{
    private static readonly MassProperties Slab = Solids.Box(1, new Vector3d(1, 2, 3));

    // measured: the momentum rotates, and changes by 0.32 of itself within ten seconds
    [TestCase("ExplicitEuler")]
    [TestCase("LabEuler")]
    [TestCase("UnityRigidbody")]
    [TestCase("UnityRigidbody in double")]
    public void Integrator_without_a_gyroscopic_term_does_not_keep_the_angular_momentum(string integrator)
    {
        Simulation simulation = Tumble(integrator);
        Vector3d before = simulation.Bodies[0].AngularMomentum;
        double worst = 0;
        for (int i = 0; i < 1000; i++)
        {
            simulation.Step();
            worst = Math.Max(worst, (simulation.Bodies[0].AngularMomentum - before).Length / before.Length);
        }

        Assert.That(worst, Is.GreaterThan(0.3));
    }

    [TestCase("ExplicitEuler")]
    [TestCase("LabEuler")]
    [TestCase("UnityRigidbody")]
    [TestCase("UnityRigidbody in double")]
    public void Integrator_without_a_gyroscopic_term_keeps_the_angular_velocity_to_the_bit(string integrator)
    {
        Simulation simulation = Tumble(integrator);
        BodyState start = simulation.Bodies[0].State;
        for (int i = 0; i < 1000; i++)
        {
            simulation.Step();
            Assert.That(simulation.Bodies[0].State.AngularVelocity, Is.EqualTo(start.AngularVelocity));
        }

        Assert.That(Conserved.AngleBetween(simulation.Bodies[0].State.Orientation, start.Orientation), Is.GreaterThan(0.1));
    }

    private static Simulation Tumble(string integrator)
    {
        BodyState start = BodyState.AtRest;
        start.AngularVelocity = new Vector3d(1, 2, 0.5);
        BodyDescription like = Scenery.Body(integrator);
        return new Simulation(TimeSteps.Every(0.01), new BodyDescription("slab", Slab)
        {
            Rule = like.Rule,
            Start = start,
            Unity = new UnitySettings { AngularDrag = 0, InDouble = like.Unity.InDouble },
        });
    }
}
