using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>A push of zero leaves the prepared constants valid.</summary>
public sealed class IdlePushTests
{
    private static readonly TimeSteps Steps = TimeSteps.Every(0.02);

    private static IEnumerable<object[]> Cases =>
        from rule in new[] { "Exact", "Splitting" }
        from moments in new[] { new Vector3d(1, 2, 2.5), new Vector3d(2, 2, 1), new Vector3d(2, 2, 2) }
        select new object[] { rule, moments };

    [TestCaseSource(nameof(Cases))]
    public void Keys_that_are_not_held_change_no_bit(string rule, Vector3d moments)
    {
        BodyDescription free = Body(rule, moments).With(new Gravity(new Vector3d(0, -9.81, 0))).With(new AngularDamping(0.1));
        BodyDescription held = free.Copy("held", free.Mass).With(new HeldKeys(new LabKeyboard()));
        AreSame(free, held, (_, _) => { }, (a, b) => a.Equals(b));
    }

    // a preparation thrown away is made again from an ω that has been rounded, and other last bits come of it
    [TestCaseSource(nameof(Cases))]
    public void Force_alone_changes_no_bit_of_a_rotation(string rule, Vector3d moments)
    {
        BodyDescription free = Body(rule, moments), pushed = free.Copy("pushed", free.Mass);
        AreSame(free, pushed, (body, n) => body.ApplyForce(new Vector3d(n % 7, 1, -n % 3)), (a, b) =>
            a.Orientation.Equals(b.Orientation) && a.AngularVelocity.Equals(b.AngularVelocity) && !a.Velocity.Equals(b.Velocity));
    }

    [TestCaseSource(nameof(Cases))]
    public void Torque_alone_changes_no_bit_of_a_way(string rule, Vector3d moments)
    {
        BodyDescription free = Body(rule, moments), turned = free.Copy("turned", free.Mass);
        AreSame(free, turned, (body, n) => body.ApplyTorque(new Vector3d(n % 7, 1, -n % 3)), (a, b) =>
            a.Position.Equals(b.Position) && a.Velocity.Equals(b.Velocity) && !a.AngularVelocity.Equals(b.AngularVelocity));
    }

    private static void AreSame(BodyDescription one, BodyDescription other, Action<Body, int> push, Func<BodyState, BodyState, bool> same)
    {
        Simulation first = Scenery.Stepped(Steps, one), second = Scenery.Stepped(Steps, other);
        for (int n = 1; n <= 1000; n++)
        {
            push(second.Bodies[0], n);
            first.Step();
            second.Step();
            Assert.That(same(first.Bodies[0].State, second.Bodies[0].State), Is.True, $"step {n}");
        }
    }

    private static BodyDescription Body(string rule, Vector3d moments) => new("body", MassProperties.FromPrincipal(2, moments))
    {
        Rule = Rules.Named(rule),
        Start = new BodyState(new Vector3d(1, 2, 3), new Quaterniond(0.9, 0.1, -0.3, 0.2), new Vector3d(0.5, -1, 0.3), new Vector3d(1, -2, 0.7)),
    };
}
