using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

public sealed class LabEulerTests
{
    [Test]
    public void Lab_step_is_the_five_steps_written_out_with_arrays()
    {
        MassProperties mass = PointMasses.Of(
            [new Vector3d(1, 0, 0.2), new Vector3d(-1, 1, -0.2), new Vector3d(0, -1, 0.5), new Vector3d(0, 0, -0.5)], [1, 1, 1, 1]);
        BodyDescription body = new BodyDescription("b", mass.WithCenterOfMass(Vector3d.Zero)) { Rule = Rules.LabEuler }
            .With(new KeyPush(LabKey.R))
            .With(new KeyPush(LabKey.RightArrow))
            .With(new KeyPush(LabKey.UpArrow), 1, 2)
            .With(new Torque(new Vector3d(0.3, 0, 0), Vector3d.Zero, new Vector3d(0, 0.2, -0.5), 2, inBody: false))
            .With(new Gravity(new Vector3d(0, -9.81, 0)))
            .With(new DecayPerStep(0.98, 0.99));
        Simulation simulation = new(TimeSteps.Every(1.0 / 60, 500), body);
        PlainStep plain = new() { Mass = 4, Inertia = FullMatrix.Of(mass.Inertia) };
        double worst = 0;
        for (int n = 0; n < 500; n++)
        {
            double t = n / 60.0, sin = Math.Sin(t), cos = Math.Cos(2 * t);
            simulation.Step();
            plain.Advance(
                1.0 / 60,
                [5, -4 * 9.81 + (n >= 60 && n < 120 ? 5 : 0), 0],
                [sin + 0.3, sin + 0.2 * cos, sin - 0.5 * cos],
                0.98,
                0.99);
            BodyState state = simulation.Bodies[0].State;
            worst = new[]
            {
                worst,
                Samples.Apart(state.Position, Of(plain.X)) / 100,
                Samples.Apart(state.Velocity, Of(plain.V)) / 10,
                Samples.Apart(state.AngularVelocity, Of(plain.W)),
                Samples.Apart(state.Orientation, new Quaterniond(plain.Q[0], plain.Q[1], plain.Q[2], plain.Q[3])),
            }.Max();
        }

        Assert.That(worst, Is.LessThan(5e-14)); // measured 2.4e-15
        Assert.That(Conserved.AngleBetween(simulation.Bodies[0].State.Orientation, Quaterniond.Identity), Is.GreaterThan(0.1));
    }

    [Test]
    public void Damping_by_a_rate_is_applied_once_a_step_at_its_end()
    {
        BodyState start = BodyState.AtRest;
        start.Velocity = new Vector3d(1, 0, 0);
        start.AngularVelocity = new Vector3d(0, 0, 2);
        BodyDescription body = new BodyDescription("b", Solids.Sphere(1, 1)) { Rule = Rules.LabEuler, Start = start }
            .With(new LinearDamping(0.5)).With(new AngularDamping(0.25)).With(new DecayPerStep(0.5, 0.25));
        BodyState state = Scenery.Run(TimeSteps.Every(0.1), body, 1);
        Assert.That(state.Position.X, Is.EqualTo(0.1));
        Assert.That(state.Velocity.X, Is.EqualTo(0.5 * Math.Exp(-0.05)).Within(1e-16)); // measured 0
        Assert.That(state.AngularVelocity.Z, Is.EqualTo(0.5 * Math.Exp(-0.025)).Within(1e-16)); // measured 0
    }

    [Test]
    public void Torque_in_body_axes_is_the_same_torque_turned_into_world_axes()
    {
        BodyState start = Pushes.State;
        BodyDescription inBody = Described(new Torque(new Vector3d(1, 2, 3), Vector3d.Zero, Vector3d.Zero, 0, inBody: true));
        BodyDescription inWorld = Described(Torque.Constant(Matrix3.Of(start.Orientation) * new Vector3d(1, 2, 3)));
        Vector3d a = Scenery.Run(TimeSteps.Every(0.1), inBody, 1).AngularVelocity;
        Vector3d b = Scenery.Run(TimeSteps.Every(0.1), inWorld, 1).AngularVelocity;
        Assert.That(Samples.Apart(a, b), Is.LessThan(1e-15)); // measured 1.1e-16
        Assert.That(Samples.Apart(a, start.AngularVelocity), Is.GreaterThan(0.05));

        BodyDescription Described(Torque torque) =>
            new BodyDescription("b", Solids.Box(1, new Vector3d(1, 2, 3))) { Rule = Rules.LabEuler, Start = start }.With(torque);
    }

    private static Vector3d Of(double[] a) => new(a[0], a[1], a[2]);
}
