using System;
using NUnit.Framework;
using UnityEngine;

namespace RigidBodyDynamics.Scripts.Tests.Play
{
    /// <summary>Inertia, damping, gravity, and the result of changing them during the motion.</summary>
    public sealed class SettingTests : PlayTest
    {
        [Test]
        public void Inertia_of_the_labs_vertices_is_three_times_the_solid_box()
        {
            Vector3d lab = Moments(InertiaKind.LabVertices), solid = Moments(InertiaKind.SolidBox);

            // m/12 (b² + c²) of a box of 1 × 2 × 3 m and 2 kg
            Assert.That(Sorted(solid), Is.EqualTo(new[] { 5.0 / 6, 10.0 / 6, 13.0 / 6 }).Within(1e-14));
            Assert.That(Sorted(lab), Is.EqualTo(new[] { 5.0 / 2, 10.0 / 2, 13.0 / 2 }).Within(1e-14));
        }

        [Test]
        public void Mesh_of_a_cube_has_the_inertia_of_the_labs_vertices() =>
            Assert.That(Sorted(Moments(InertiaKind.MeshVertices)), Is.EqualTo(Sorted(Moments(InertiaKind.LabVertices))).Within(1e-14));

        [Test]
        public void A_mirrored_object_has_the_same_inertia()
        {
            MyRigidbody body = MakeStill(b => b.mass = 2, cube => cube.transform.localScale = new Vector3(1, -2, 3));

            Assert.That(Sorted(body.Body.Mass.PrincipalMoments), Is.EqualTo(Sorted(Moments(InertiaKind.LabVertices))).Within(1e-14));
        }

        [TestCase(DampingKind.FactorPerStep)]
        [TestCase(DampingKind.Rate)]
        [TestCase(DampingKind.None)]
        public void A_damping_takes_its_share_in_every_step(DampingKind damping)
        {
            MyRigidbody body = MakeStill(b =>
            {
                b.damping = damping;
                b.startVelocity = Vector3.one;
                b.startSpin = Vector3.one;
                b.linearDecay = 0.9;
                b.angularDecay = 0.8;
                b.linearRate = 2;
                b.angularRate = 3;
            });

            body.Step();
            body.Step();

            bool perStep = damping == DampingKind.FactorPerStep, never = damping == DampingKind.None;
            double keptV = perStep ? 0.9 : never ? 1 : Math.Exp(-2 * StepLength), keptW = perStep ? 0.8 : never ? 1 : Math.Exp(-3 * StepLength);
            Assert.That(body.State.Velocity.Y, Is.EqualTo(keptV * keptV).Within(1e-14));
            Assert.That(body.State.AngularVelocity.Y, Is.EqualTo(keptW * keptW).Within(1e-14));
        }

        [Test]
        public void Gravity_is_that_of_the_project()
        {
            MyRigidbody body = MakeStill(b =>
            {
                b.useGravity = true;
                b.damping = DampingKind.None;
            });

            body.Step();

            Assert.That(body.State.Velocity.Y, Is.EqualTo(Physics.gravity.y * StepLength).Within(1e-15));
        }

        [Test]
        public void A_setting_changed_while_playing_goes_on_from_where_the_body_is()
        {
            MyRigidbody body = MakeStill(b =>
            {
                b.startVelocity = new Vector3(1, 2, 3);
                b.startSpin = new Vector3(3, 1, 2);
            });
            for (int step = 0; step < 50; step++)
                body.Step();

            BodyState here = body.State;
            body.integrator = "Exact";
            body.damping = DampingKind.None;
            body.SendMessage("OnValidate");
            Assert.That(Numbers(body.State), Is.EqualTo(Numbers(here)));
            LabInput.HoldOnScreen(LabKey.R, true);
            body.Step();

            // the same body is added to a simulation that has run as long: the torque of R is the present one
            Simulation library = new Simulation(TimeSteps.Every(StepLength));
            library.Step(50);
            Body same = library.Add(new BodyDescription("cube", PointMasses.BoxVertices(1, new Vector3d(1, 1, 1))) { Start = here }
                .With(new HeldKeys(new LabKeyboard { [LabKey.R] = true })));
            library.Step();
            Assert.That(Numbers(body.State), Is.EqualTo(Numbers(same.State)));
            Assert.That(body.Body.Rule.Name, Is.EqualTo("Exact"));
        }

        [Test]
        public void A_fixed_step_changed_while_playing_goes_on_in_time()
        {
            MyRigidbody body = MakeStill(b =>
            {
                b.startVelocity = new Vector3(1, 2, 3);
                b.damping = DampingKind.None;
            });
            float before = Time.fixedDeltaTime;
            try
            {
                for (int step = 0; step < 50; step++)
                    body.Step();

                double passed = 50 * StepLength;
                Time.fixedDeltaTime = 0.01f;
                for (int step = 0; step < 50; step++)
                    body.Step();

                Assert.That(body.State.Position.X, Is.EqualTo(passed + 50 * 0.01).Within(1e-14));
                LabInput.HoldOnScreen(LabKey.R, true);
                body.Step();
                // sin t N m on 2/4 m² of 1 kg, by LabEuler at the start of the step
                Assert.That(body.State.AngularVelocity.X, Is.EqualTo(Math.Sin(passed + 0.5) * 0.01 / 0.5).Within(1e-14));
            }
            finally
            {
                Time.fixedDeltaTime = before;
            }
        }

        private Vector3d Moments(InertiaKind inertia) => MakeStill(
            b =>
            {
                b.mass = 2;
                b.inertia = inertia;
            },
            cube => cube.transform.localScale = new Vector3(1, 2, 3)).Body.Mass.PrincipalMoments;

        private static double[] Sorted(Vector3d moments)
        {
            double[] sorted = { moments.X, moments.Y, moments.Z };
            Array.Sort(sorted);
            return sorted;
        }
    }
}
