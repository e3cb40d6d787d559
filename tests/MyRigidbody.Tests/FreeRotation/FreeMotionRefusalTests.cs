using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

public sealed class FreeMotionRefusalTests
{
    [Test]
    public void Start_that_is_no_state_is_refused()
    {
        BodyDescription body = new("b", Solids.Sphere(1, 1));
        body.Start = new BodyState(new Vector3d(double.NaN, 0, 0), Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero);
        Assert.That(() => new FreeMotion(body), Throws.InstanceOf<ArgumentException>());
    }

    [Test]
    public void Longest_time_either_way_is_answered_and_a_longer_one_is_not()
    {
        BodyDescription body = new("b", Solids.Sphere(1, 1));
        body.Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(1, 0, 0), Vector3d.Zero);
        FreeMotion motion = new(body);
        foreach (double longest in new[] { 1e9, -1e9 })
        {
            Assert.That(motion.At(longest).Position, Is.EqualTo(new Vector3d(longest, 0, 0)));
            Assert.That(() => motion.At(longest * (1 + 1e-15)), Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains("time"));
        }
    }
}
