using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>The traits of a push are true: an integrator may leave out what is not declared.</summary>
public sealed class EffectTraitsTests
{
    private static readonly EffectTraits[] Reads =
    [
        EffectTraits.ReadsTime,
        EffectTraits.ReadsPosition,
        EffectTraits.ReadsOrientation,
        EffectTraits.ReadsVelocity,
        EffectTraits.ReadsAngularVelocity,
    ];

    [TestCaseSource(typeof(Pushes), nameof(Pushes.All))]
    public void Push_depends_on_nothing_that_it_does_not_declare(IPush push)
    {
        foreach (EffectTraits read in Reads.Where(r => (push.Traits & r) == 0))
            Assert.That(Changes(push, read), Is.False, read.ToString());
    }

    [TestCaseSource(typeof(Pushes), nameof(Pushes.All))]
    public void Push_depends_on_all_that_it_declares(IPush push)
    {
        foreach (EffectTraits read in Reads.Where(r => (push.Traits & r) != 0))
            Assert.That(Changes(push, read), Is.True, read.ToString());
    }

    [TestCaseSource(typeof(Pushes), nameof(Pushes.All))]
    public void Push_moves_and_turns_if_and_only_if_it_declares_so(IPush push)
    {
        foreach (Wrench wrench in new[] { Pushes.At(push, Pushes.Now, Pushes.State), Pushes.Over(push, Pushes.Now, 0.1, Pushes.State) })
        {
            Assert.That(!wrench.Force.IsZero, Is.EqualTo((push.Traits & EffectTraits.Moves) != 0));
            Assert.That(!(wrench.Torque.IsZero && wrench.BodyTorque.IsZero), Is.EqualTo((push.Traits & EffectTraits.Turns) != 0));
        }
    }

    // true if another time, position, ... gives another push
    private static bool Changes(IPush push, EffectTraits read)
    {
        Instant now = Pushes.Now;
        BodyState state = Pushes.State;
        switch (read)
        {
            case EffectTraits.ReadsTime: now = new Instant(2, 1.9); break;
            case EffectTraits.ReadsPosition: state.Position += new Vector3d(0.3, -2, 1); break;
            case EffectTraits.ReadsOrientation: state.Orientation = new Quaterniond(0.1, 0.7, 0.7, -0.1); break;
            case EffectTraits.ReadsVelocity: state.Velocity += new Vector3d(0.3, -2, 1); break;
            default: state.AngularVelocity += new Vector3d(0.3, -2, 1); break;
        }

        bool same = Equals(Pushes.At(push, now, state), Pushes.At(push, Pushes.Now, Pushes.State))
            && Equals(Pushes.Over(push, now, 0.1, state), Pushes.Over(push, Pushes.Now, 0.1, Pushes.State));
        return !same;
    }
}
