using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

public sealed class AllocationTests
{
    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Stepping_a_body_with_many_effects_allocates_nothing(string integrator)
    {
        foreach (TimeSteps steps in Scenery.Divisions())
        {
            // once through all windows, so that every step is compiled
            new Simulation(steps, Scenery.Busy(integrator)).Step(Scenery.Steps);
            Simulation simulation = new(steps, Scenery.Busy(integrator));
            Assert.That(BytesOf(() => simulation.Step(Scenery.Steps / 2)), Is.Zero);
            Assert.That(BytesOf(() => OneByOne(simulation, Scenery.Steps / 2)), Is.Zero);
        }
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Reading_a_body_allocates_nothing(string integrator)
    {
        Simulation simulation = new(TimeSteps.Every(0.02), Scenery.Busy(integrator));
        double sum = 0;
        Read();
        Assert.That(BytesOf(Read), Is.Zero);
        Assert.That(sum, Is.GreaterThan(0));

        void Read()
        {
            Body body = simulation.Bodies[0];
            sum += body.State.Position.Length + body.KineticEnergy + body.AngularMomentum.Length + simulation.Time;
            sum += body.IsAsleep ? 1 : 0;
        }
    }

    [Test]
    public void Applying_a_force_allocates_nothing()
    {
        Simulation simulation = new(TimeSteps.Every(0.02), Scenery.Body("LabEuler"));
        Push();
        Assert.That(BytesOf(Push), Is.Zero);
        Assert.That(simulation.Bodies[0].State.Velocity.X, Is.GreaterThan(Pushes.State.Velocity.X));

        void Push()
        {
            simulation.Bodies[0].ApplyForce(new Vector3d(1, 0, 0));
            simulation.Bodies[0].ApplyTorque(new Vector3d(0, 0, 1));
            simulation.Step();
        }
    }

    [Test]
    public void Measure_sees_an_allocation() => Assert.That(BytesOf(() => GC.KeepAlive(new byte[100])), Is.GreaterThanOrEqualTo(100));

    private static void OneByOne(Simulation simulation, long count)
    {
        for (long i = 0; i < count; i++)
            simulation.Step();
    }

    private static long BytesOf(Action action)
    {
        long before = GC.GetAllocatedBytesForCurrentThread();
        action();
        return GC.GetAllocatedBytesForCurrentThread() - before;
    }
}
