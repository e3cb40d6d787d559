using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>An integrator is a struct that holds all it keeps of its body: a copy of it is a saved body.</summary>
public sealed class SavedBodyTests
{
    [Test]
    public void Copy_of_the_lab_integrator_goes_on_to_the_same_bits() => Check<LabEuler>("LabEuler");

    [Test]
    public void Copy_of_the_explicit_integrator_goes_on_to_the_same_bits() => Check<ExplicitEuler>("ExplicitEuler");

    [Test]
    public void Copy_of_the_single_precision_body_goes_on_to_the_same_bits() => Check<UnityRigidbody<ToSingle>>("UnityRigidbody");

    [Test]
    public void Copy_of_the_double_precision_body_goes_on_to_the_same_bits() => Check<UnityRigidbody<ToDouble>>("UnityRigidbody in double");

    [Test]
    public void Copy_falls_asleep_at_the_same_step()
    {
        // the clock and the sums it keeps are part of the body
        PhysxRecording recording = PhysxRecording.Read("g_slower_sleeps");
        UnityRigidbody<ToSingle> body = default;
        body.Start(new Beginning(recording.Body()));
        body.Prepare(0.02f, Coasting.Free);
        Nothing nothing = default;
        for (int n = 0; n < 15; n++)
            body.Step(new Instant(n, 0), ref nothing);
        UnityRigidbody<ToSingle> saved = body;
        int asleep = 0;
        for (int n = 15; n < 40; n++)
        {
            body.Step(new Instant(n, 0), ref nothing);
            saved.Step(new Instant(n, 0), ref nothing);
            Assert.That((saved.IsAsleep, saved.WakeCounter), Is.EqualTo((body.IsAsleep, body.WakeCounter)));
            asleep += body.IsAsleep ? 1 : 0;
        }

        Assert.That(asleep, Is.InRange(1, 24));
    }

    private static void Check<TIntegrator>(string integrator) where TIntegrator : struct, IIntegrator
    {
        TIntegrator body = default;
        body.Start(new Beginning(Scenery.Body(integrator)));
        Run(ref body, 0, 50);
        TIntegrator saved = body;
        BodyState then = body.State;
        Run(ref body, 50, 100);
        Assert.That(saved.State, Is.EqualTo(then));
        Assert.That(body.State, Is.Not.EqualTo(then));
        Run(ref saved, 50, 100);
        Assert.That(saved.State, Is.EqualTo(body.State));
    }

    private static void Run<TIntegrator>(ref TIntegrator body, int first, int end) where TIntegrator : struct, IIntegrator
    {
        Both<KeyPush, Spring> push = new(new KeyPush(LabKey.R), new Spring(new Vector3d(0, 0.5, 0), new Vector3d(0, 3, 0), 4));
        Coasting coasting = Coasting.Free;
        coasting.Acceleration = new Vector3d(0, -9.81, 0);
        coasting.LinearDampingRate = 0.1;
        if (first == 0)
            body.Prepare(0.02, coasting);
        for (int n = first; n < end; n++)
            body.Step(new Instant(n, 0.02 * n), ref push);
    }
}
