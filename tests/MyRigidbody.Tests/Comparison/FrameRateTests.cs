using NUnit.Framework;
using RigidBodyDynamics.Lab.Comparison;

namespace RigidBodyDynamics.Tests.Comparison;

/// <summary>AddForce in Update: the push grows with the frame rate.</summary>
public sealed class FrameRateTests
{
    private static readonly TimeSteps Steps = TimeSteps.Until(10, 0.02);

    [TestCase(30, 0.6)]
    [TestCase(60, 1.2)]
    [TestCase(144, 2.88)]
    [TestCase(240, 4.8)]
    public void Impulse_of_a_held_key_is_the_frame_rate_over_the_rate_of_steps(int framesPerSecond, double expected)
    {
        FrameRate found = FrameRate.Of(Scenes.Lab(new Vector3d(1, 1, 1)).Default, Steps, framesPerSecond);

        // windows of 1 s hold a whole number of frames at all these rates; 1.5 s and 2.5 s too
        Assert.That(found.Impulse, Is.EqualTo(expected).Within(1e-14)); // measured 2.7e-15
    }

    [Test]
    public void At_the_rate_of_the_steps_every_push_comes_once_and_a_step_late()
    {
        BodyDescription body = new("body", Solids.Sphere(1, 1)) { Rule = Rules.UnityRigidbody };
        body.With(new KeyPush(LabKey.RightArrow), 1, 2);

        FrameRate found = FrameRate.Of(body, Steps, 50);

        Assert.That(found.Impulse, Is.EqualTo(1).Within(1e-15)); // measured 0
        // the same 5 m/s, reached a step of 0.02 s later
        Assert.That(found.Apart.Last.Distance, Is.EqualTo(5 * 0.02).Within(1e-5)); // measured 1.5e-6: single precision, 40 m from the origin
    }

    [Test]
    public void Frames_slower_than_steps_leave_steps_without_a_push()
    {
        BodyDescription body = new("body", Solids.Sphere(1, 1)) { Rule = Rules.UnityRigidbody };
        body.With(new KeyPush(LabKey.RightArrow), 0, 1);

        FrameRate found = FrameRate.Of(body, Steps, 25);

        Assert.That(found.Impulse, Is.EqualTo(0.5).Within(2e-15)); // measured 3.3e-16
    }

    [Test]
    public void Without_keys_there_is_nothing_to_show()
    {
        Assert.That(FrameRate.Matters(new BodyDescription("body", Solids.Sphere(1, 1)), Steps), Is.False);
    }
}
