using System;
using NUnit.Framework;
using UnityEngine;

namespace RigidBodyDynamics.Scripts.Tests.Play
{
    /// <summary>The keys reach the library.</summary>
    public sealed class KeyTests : PlayTest
    {
        [TestCase(LabKey.LeftArrow, -1, 0)]
        [TestCase(LabKey.RightArrow, 1, 0)]
        [TestCase(LabKey.UpArrow, 0, 1)]
        [TestCase(LabKey.DownArrow, 0, -1)]
        public void An_arrow_pushes_with_five_newtons(LabKey key, int x, int y)
        {
            MyRigidbody body = MakeStill(b =>
            {
                b.mass = 2;
                b.damping = DampingKind.None;
            });
            LabInput.HoldOnScreen(key, true);

            body.Step();

            double speed = StepLength * 5 / 2;
            Assert.That(body.State.Velocity.X, Is.EqualTo(x * speed).Within(1e-15));
            Assert.That(body.State.Velocity.Y, Is.EqualTo(y * speed).Within(1e-15));
            Assert.That(body.State.Velocity.Z, Is.Zero);
            Assert.That(body.Keyboard[key], Is.True);
        }

        [Test]
        public void R_turns_with_the_sine_of_the_time()
        {
            MyRigidbody body = MakeStill(b => b.damping = DampingKind.None);
            LabInput.HoldOnScreen(LabKey.R, true);

            body.Step();
            Assert.That(body.State.AngularVelocity.Length, Is.Zero);
            body.Step();

            // I of eight vertices of 1 kg on a cube of 1 m is 1/2 kg m²
            double spin = StepLength * Math.Sin(StepLength) / 0.5;
            Assert.That(body.State.AngularVelocity.X, Is.EqualTo(spin).Within(1e-15));
            Assert.That(body.State.AngularVelocity.Y, Is.EqualTo(spin).Within(1e-15));
            Assert.That(body.State.AngularVelocity.Z, Is.EqualTo(spin).Within(1e-15));
        }

        [Test]
        public void A_key_let_go_pushes_no_more()
        {
            MyRigidbody body = MakeStill(b => b.damping = DampingKind.None);
            LabInput.HoldOnScreen(LabKey.RightArrow, true);
            body.Step();
            double speed = body.State.Velocity.X;

            LabInput.LetGo();
            body.Step();

            Assert.That(speed, Is.GreaterThan(0));
            Assert.That(body.State.Velocity.X, Is.EqualTo(speed));
        }

        [Test]
        public void A_body_that_reads_no_keys_feels_none()
        {
            MyRigidbody body = MakeStill(b => b.readsKeys = false);
            LabInput.HoldOnScreen(LabKey.RightArrow, true);
            LabInput.HoldOnScreen(LabKey.R, true);

            body.Step();
            body.Step();

            Assert.That(body.State.Velocity.Length, Is.Zero);
            Assert.That(body.State.AngularVelocity.Length, Is.Zero);
            Assert.That(body.transform.position, Is.EqualTo(Vector3.zero));
            Assert.That(body.Keyboard[LabKey.RightArrow], Is.False);
        }
    }
}
