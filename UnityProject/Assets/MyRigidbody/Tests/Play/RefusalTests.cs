using System;
using System.Collections;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace RigidBodyDynamics.Scripts.Tests.Play
{
    /// <summary>An impossible body is refused, in one line of the console.</summary>
    public sealed class RefusalTests : PlayTest
    {
        private static readonly Regex OneLine = new Regex("^MyRigidbody on 'Cube': .");

        [UnityTest]
        public IEnumerator A_Rigidbody_on_the_same_object_is_refused_and_nothing_moves()
        {
            LogAssert.Expect(LogType.Error, "MyRigidbody on 'Cube': a Rigidbody on the same object would move it too; remove one of them");
            MyRigidbody body = Make<MyRigidbody>(
                b => b.startVelocity = Vector3.one,
                cube => cube.AddComponent<Rigidbody>().useGravity = false);
            LabInput.HoldOnScreen(LabKey.RightArrow, true);
            yield return new WaitForFixedUpdate();
            yield return new WaitForFixedUpdate();

            Assert.That(body.IsReady, Is.False);
            Assert.That(body.enabled, Is.False);
            Assert.That(body.transform.position.magnitude, Is.Zero);
        }

        [Test]
        public void A_mass_of_zero_is_refused() => Refused(b => b.mass = 0);

        [Test]
        public void A_mass_below_zero_is_refused() => Refused(b => b.mass = -1);

        [Test]
        public void A_mass_that_is_no_number_is_refused() => Refused(b => b.mass = double.NaN);

        [Test]
        public void An_unknown_integrator_is_refused() => Refused(b => b.integrator = "Newton");

        [Test]
        public void No_integrator_is_refused() => Refused(b => b.integrator = string.Empty);

        [Test]
        public void A_decay_above_one_is_refused() => Refused(b => b.linearDecay = 1.5);

        [Test]
        public void A_rate_below_zero_is_refused() => Refused(b =>
        {
            b.damping = DampingKind.Rate;
            b.angularRate = -1;
        });

        [Test]
        public void A_start_that_is_no_number_is_refused() => Refused(b => b.startSpin = new Vector3(0, float.NaN, 0));

        [Test]
        public void An_object_without_size_is_refused() => Refused(b => b.transform.localScale = Vector3.zero);

        [Test]
        public void A_mesh_that_is_not_there_is_refused() => Refused(b =>
        {
            b.inertia = InertiaKind.MeshVertices;
            b.GetComponent<MeshFilter>().sharedMesh = null;
        });

        [Test]
        public void A_body_whose_settings_are_mended_moves()
        {
            LogAssert.Expect(LogType.Error, OneLine);
            MyRigidbody body = Make<MyRigidbody>(b => b.mass = 0);

            body.mass = 1;
            body.startVelocity = Vector3.right;
            body.StartAgain();
            body.Step();

            Assert.That(body.enabled, Is.True);
            Assert.That(body.State.Position.X, Is.EqualTo(StepLength).Within(1e-15));
        }

        [Test]
        public void A_refused_body_stays_refused_until_it_is_mended()
        {
            LogAssert.Expect(LogType.Error, OneLine);
            LogAssert.Expect(LogType.Error, OneLine);
            MyRigidbody body = Make<MyRigidbody>(b => { }, cube => cube.AddComponent<Rigidbody>());

            body.StartAgain();

            Assert.That(body.IsReady, Is.False);
            Assert.That(body.enabled, Is.False);
        }

        [Test]
        public void A_body_that_was_switched_off_stays_off_when_it_starts_again()
        {
            MyRigidbody body = Make<MyRigidbody>();
            body.enabled = false;

            body.StartAgain();

            Assert.That(body.enabled, Is.False);
        }

        // a second line of the console would make the test fail, and so would an exception
        private void Refused(Action<MyRigidbody> spoil)
        {
            LogAssert.Expect(LogType.Error, OneLine);
            MyRigidbody body = Make(spoil);
            body.Step();
            body.Step();

            Assert.That(body.IsReady, Is.False);
            Assert.That(body.enabled, Is.False);
            Assert.That(body.Explain(), Is.Empty);
            Assert.That(body.transform.position.magnitude, Is.Zero);
        }
    }
}
