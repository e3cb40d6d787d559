using CsCheck;
using NUnit.Framework;
using static RigidBodyDynamics.Tests.Samples;

namespace RigidBodyDynamics.Tests;

public sealed class ConservedTests
{
    private static readonly Vector3d[] Points =
        [new Vector3d(1, 0, 0.2), new Vector3d(-0.5, 1, 0), new Vector3d(0, -0.7, 1.5), new Vector3d(0.3, 0.3, -1)];

    private static readonly MassProperties Cloud = PointMasses.Of(Points, [1, 2, 3, 4]);

    private static readonly Gen<BodyState> States =
        Gen.Select(Vectors, Turns, Vectors, Vectors, (x, q, v, w) => new BodyState(x, q, v, w));

    [Test]
    public void Angular_momentum_is_the_sum_over_the_points_of_r_cross_p() => Property.Holds(
        States,
        state =>
        {
            Vector3d sum = Vector3d.Zero;
            BodyState turning = state;
            turning.Velocity = Vector3d.Zero;
            foreach ((double mass, Vector3d arm, Vector3d velocity) in Moving(turning))
                sum += mass * Vector3d.Cross(arm, velocity);
            return Apart(Conserved.AngularMomentum(state, Cloud), sum) / (20 * state.AngularVelocity.Length);
        },
        4e-15); // measured 1.5e-15

    [Test]
    public void Impulse_that_is_applied_changes_both_momenta_by_itself_and_nothing_else() => Property.Holds(
        Gen.Select(States, Vectors, Vectors, Vectors),
        sample =>
        {
            (BodyState state, Vector3d force, Vector3d torque, Vector3d bodyTorque) = sample;
            Wrench impulse = new() { Force = force, Torque = torque, BodyTorque = bodyTorque };
            BodyState after = impulse.AppliedTo(state, Cloud);
            Vector3d turned = Conserved.AngularMomentum(after, Cloud) - Conserved.AngularMomentum(state, Cloud);
            Vector3d pushed = Conserved.Momentum(after, Cloud) - Conserved.Momentum(state, Cloud);
            bool isInPlace = after.Position.Equals(state.Position) && after.Orientation.Equals(state.Orientation);
            return isInPlace ? (Apart(turned, torque + state.Orientation.Rotate(bodyTorque)) / 20 + Apart(pushed, force)) / (20 * state.AngularVelocity.Length + 20 * state.Velocity.Length) : 1;
        },
        1e-15); // measured 1.2e-16

    [Test]
    public void Orientation_of_another_length_has_the_momentum_and_energy_of_its_rotation() => Property.Holds(
        Gen.Select(States, Gen.Double[0.5, 2]),
        sample =>
        {
            (BodyState state, double length) = sample;
            BodyState longer = state;
            Quaterniond q = state.Orientation;
            longer.Orientation = new Quaterniond(length * q.W, length * q.X, length * q.Y, length * q.Z);
            Vector3d momentum = Conserved.AngularMomentum(state, Cloud);
            double energy = Conserved.KineticEnergy(state, Cloud);
            return Apart(Conserved.AngularMomentum(longer, Cloud), momentum) / (20 * state.AngularVelocity.Length)
                + Math.Abs(Conserved.KineticEnergy(longer, Cloud) - energy) / energy;
        },
        1e-14); // measured 3.0e-15

    [Test]
    public void State_is_printed_with_all_its_numbers() => Assert.That(
        new BodyState(new Vector3d(1, 2.5, 0), Quaterniond.Identity, new Vector3d(0, 0, -3), new Vector3d(0, 0.1, 0)).ToString(),
        Is.EqualTo($"position (1, 2.5, 0), orientation {Quaterniond.Identity}, velocity (0, 0, -3), angular velocity (0, 0.1, 0)"));

    [Test]
    public void Kinetic_energy_is_the_sum_over_the_points() => Property.Holds(
        States,
        state =>
        {
            double sum = Moving(state).Sum(p => 0.5 * p.Mass * p.Velocity.LengthSquared);
            return Math.Abs(Conserved.KineticEnergy(state, Cloud) / sum - 1);
        },
        2e-14); // measured 2.1e-15

    [Test]
    public void Momentum_is_the_sum_over_the_points() => Property.Holds(
        States,
        state =>
        {
            Vector3d sum = Vector3d.Zero;
            foreach ((double mass, Vector3d _, Vector3d velocity) in Moving(state))
                sum += mass * velocity;
            return Apart(Conserved.Momentum(state, Cloud), sum) / 200;
        },
        4e-15); // measured 2.1e-16

    [Test]
    public void Body_in_a_simulation_reports_the_same_energy_and_momentum()
    {
        BodyState start = new(Vector3d.Zero, new Quaterniond(0.8, 0.2, -0.4, 0.4), new Vector3d(1, 2, 3), new Vector3d(3, 2, 1));
        Body body = new Simulation(TimeSteps.Every(0.1), new BodyDescription("b", Cloud) { Start = start }).Bodies[0];
        Assert.That(body.KineticEnergy, Is.EqualTo(Conserved.KineticEnergy(body.State, Cloud)));
        Assert.That(body.AngularMomentum, Is.EqualTo(Conserved.AngularMomentum(body.State, Cloud)));
        Assert.That(body.KineticEnergy, Is.GreaterThan(0.5 * 10 * 14));
    }

    [Test]
    public void State_is_finite_only_if_every_number_in_it_is()
    {
        Vector3d bad = new(0, 0, double.NaN), good = new(1, 2, 3);
        Quaterniond badTurn = new(double.PositiveInfinity, 0, 0, 0), turn = Quaterniond.Identity;
        Assert.That(new BodyState(good, turn, good, good).IsFinite, Is.True);
        Assert.That(
            new[]
            {
                new BodyState(bad, turn, good, good),
                new BodyState(good, badTurn, good, good),
                new BodyState(good, turn, bad, good),
                new BodyState(good, turn, good, bad),
            },
            Has.None.Matches<BodyState>(s => s.IsFinite));
    }

    private static IEnumerable<(double Mass, Vector3d Arm, Vector3d Velocity)> Moving(BodyState state)
    {
        double[] masses = [1, 2, 3, 4];
        Vector3d center = Vector3d.Zero;
        for (int i = 0; i < 4; i++)
            center += masses[i] / 10 * Points[i];
        for (int i = 0; i < 4; i++)
        {
            Vector3d arm = Matrix3.Of(state.Orientation) * (Points[i] - center);
            yield return (masses[i], arm, state.Velocity + Vector3d.Cross(state.AngularVelocity, arm));
        }
    }
}
