using CsCheck;
using NUnit.Framework;
using static RigidBodyDynamics.Tests.Samples;

namespace RigidBodyDynamics.Tests;

/// <summary>Pushes that depend on the state: drag, spring, heavy top. Those with an energy must be its gradient.</summary>
public sealed class FieldTests
{
    private static readonly Gen<BodyState> States =
        Gen.Select(Vectors, Turns, Vectors, Vectors, (x, q, v, w) => new BodyState(x, q, v, w));

    [Test]
    public void Quadratic_drag_opposes_the_velocity_with_the_square_of_the_speed()
    {
        BodyState state = Pushes.State;
        state.Velocity = new Vector3d(2, 3, -6);
        Assert.That(Pushes.At(new QuadraticDrag(0.5), Pushes.Now, state), Is.EqualTo(new Wrench { Force = new Vector3d(-7, -10.5, 21) }));
    }

    [TestCase(1e-6)]
    [TestCase(0.1)]
    [TestCase(1e6)]
    public void Quadratic_drag_slows_to_v_over_one_plus_z(double h)
    {
        BodyState state = Pushes.State;
        Vector3d after = state.Velocity + Pushes.Over(new QuadraticDrag(0.3), Pushes.Now, h, state).Force / Pushes.Mass.Mass;
        Vector3d expected = state.Velocity / (1 + 0.3 * state.Velocity.Length * h / Pushes.Mass.Mass);
        Assert.That(Apart(after, expected), Is.LessThan(5e-16)); // measured 1.1e-16
        Assert.That(Vector3d.Dot(after, state.Velocity), Is.GreaterThanOrEqualTo(0));
    }

    [Test]
    public void Two_half_steps_of_quadratic_drag_are_the_whole_step() => Property.Holds(
        Gen.Select(Vectors, Gen.Double[-3, 3]),
        t =>
        {
            double h = Math.Pow(10, t.Item2);
            BodyState whole = Pushes.State;
            whole.Velocity = t.Item1;
            BodyState halves = whole;
            whole.Velocity += Pushes.Over(new QuadraticDrag(0.3), Pushes.Now, h, whole).Force / Pushes.Mass.Mass;
            for (int i = 0; i < 2; i++)
                halves.Velocity += Pushes.Over(new QuadraticDrag(0.3), Pushes.Now, h / 2, halves).Force / Pushes.Mass.Mass;
            return Apart(halves.Velocity, whole.Velocity) / t.Item1.Length;
        },
        2e-15); // measured 2.8e-16

    [Test]
    public void Drag_on_a_body_at_rest_is_nothing() =>
        Assert.That(Pushes.Over(new QuadraticDrag(0.3), Pushes.Now, 1, BodyState.AtRest).Force.IsZero, Is.True);

    [Test]
    public void Spring_pulls_its_anchor_to_its_place()
    {
        // the anchor is at (0, 1, 0) in the world, one metre from the centre of mass; the spring ends at (3, 1, 0)
        MassProperties mass = Solids.Box(1, new Vector3d(1, 1, 1));
        BodyState quarter = BodyState.AtRest;
        quarter.Orientation = new Quaterniond(Math.Sqrt(0.5), 0, 0, Math.Sqrt(0.5));
        Wrench wrench = default;
        new Spring(new Vector3d(1, 0, 0), new Vector3d(3, 1, 0), 2).At(Pushes.Now, quarter, mass, ref wrench);
        Assert.That(Apart(wrench.Force, new Vector3d(6, 0, 0)), Is.LessThan(2e-15)); // measured 4.4e-16
        Assert.That(Apart(wrench.Torque, new Vector3d(0, 0, -6)), Is.LessThan(2e-15)); // measured 1.8e-15
    }

    [Test]
    public void Spring_is_the_slope_of_its_energy() => Property.Holds(
        States,
        state => ErrorOfSlope(new Spring(new Vector3d(1, -2, 3), new Vector3d(-0.5, 0.25, 2), 4), state, moved =>
        {
            Vector3d end = moved.Position + Matrix3.Of(moved.Orientation) * new Vector3d(1, -2, 3);
            return 0.5 * 4 * (end - new Vector3d(-0.5, 0.25, 2)).LengthSquared;
        }) / 500,
        1e-9); // measured 4.2e-11: differences of energies 1e-5 apart

    [Test]
    public void Heavy_top_is_the_slope_of_its_height() => Property.Holds(
        States,
        state => ErrorOfSlope(new HeavyTop(new Vector3d(0, 3, 4), 2, new Vector3d(0, 0, 9)), state, moved =>
            2 * (Matrix3.Of(moved.Orientation) * new Vector3d(0, 0.6, 0.8)).Z),
        1e-9); // measured 1.3e-10

    [Test]
    public void Heavy_top_upright_feels_no_torque_and_lying_the_whole()
    {
        HeavyTop top = new(new Vector3d(0, 0, 1), 3, new Vector3d(0, 0, 1));
        Assert.That(Pushes.At(top, Pushes.Now, BodyState.AtRest).BodyTorque.IsZero, Is.True);
        BodyState lying = BodyState.AtRest;
        // its axis along world x: gravity rotates it down, about +y
        lying.Orientation = new Quaterniond(Math.Sqrt(0.5), 0, Math.Sqrt(0.5), 0);
        Vector3d torque = Pushes.At(top, Pushes.Now, lying).TorqueInWorld(lying.Orientation);
        Assert.That(Apart(torque, new Vector3d(0, 3, 0)), Is.LessThan(3e-15)); // measured 8.9e-16
    }

    /// <summary>Moves and rotates the body a little about its centre of mass, in both directions, and compares −dE with the push.</summary>
    private static double ErrorOfSlope(IPush push, BodyState state, Func<BodyState, double> energy)
    {
        const double little = 1e-5;
        Wrench wrench = Pushes.At(push, Pushes.Now, state);
        Vector3d torque = wrench.TorqueInWorld(state.Orientation), com = Pushes.Mass.CenterOfMass;
        double worst = 0;
        foreach (Vector3d axis in new[] { new Vector3d(1, 0, 0), new Vector3d(0, 1, 0), new Vector3d(0, 0, 1) })
        {
            double force = -(energy(Moved(little * axis)) - energy(Moved(-little * axis))) / (2 * little);
            double turn = -(energy(Turned(axis, little)) - energy(Turned(axis, -little))) / (2 * little);
            worst = Math.Max(worst, Math.Max(
                Math.Abs(force - Vector3d.Dot(axis, wrench.Force)), Math.Abs(turn - Vector3d.Dot(axis, torque))));
        }

        return worst;

        BodyState Moved(Vector3d by)
        {
            BodyState moved = state;
            moved.Position += by;
            return moved;
        }

        BodyState Turned(Vector3d axis, double angle)
        {
            BodyState turned = state;
            turned.Orientation = (new Quaterniond(Math.Cos(angle / 2), Math.Sin(angle / 2) * axis) * state.Orientation).Normalized;
            turned.Position = state.Position + Matrix3.Of(state.Orientation) * com - Matrix3.Of(turned.Orientation) * com;
            return turned;
        }
    }
}
