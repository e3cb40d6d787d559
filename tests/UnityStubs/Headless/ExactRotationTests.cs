using NUnit.Framework;
using RigidBodyDynamics.Engine;
using UnityEngine;

namespace RigidBodyDynamics.Scripts.Tests.Headless
{
    /// <summary>A Rigidbody with ExactRotation, against the library's own motion of a free top.</summary>
    public sealed class ExactRotationTests : ThrownSlab
    {
        [Test]
        public void For_a_minute_and_twenty_flips_it_is_where_the_free_top_is()
        {
            FreeMotion free = Free();
            double worst = 0, energy = Exact.RotationalEnergy;
            int flips = 0;
            bool isUp = true;
            for (int step = 1; step <= 3000; step++)
            {
                Player.Frame(Dt);
                worst = System.Math.Max(worst, Angle(free.At(step * Dt)));
                bool wasUp = isUp;
                isUp = Exact.Orientation.RotateInverse(Exact.AngularVelocity).Y > 0;
                flips += isUp != wasUp ? 1 : 0;
            }

            Assert.That(flips, Is.EqualTo(20));
            Assert.That(worst, Is.LessThan(5e-7)); // measured 1.8e-7
            Assert.That(Exact.RotationalEnergy, Is.EqualTo(energy).Within(1e-13).Percent);
        }

        [Test]
        public void Without_it_theBody_never_flips()
        {
            Rigidbody other = Thrown(AboutTheMiddleAxis).GetComponent<Rigidbody>();
            for (int step = 0; step < 500; step++)
                Player.Frame(Dt);

            Assert.That(other.angularVelocity.Equals(AboutTheMiddleAxis), Is.True);
        }

        [Test]
        public void Between_steps_the_Rigidbody_has_the_true_angular_velocity()
        {
            FreeMotion free = Free();
            Frames(100);
            Vector3d expected = free.At(100 * Dt).AngularVelocity;

            Assert.That((Exact.AngularVelocity - expected).Length, Is.LessThan(1e-12)); // measured 1.5e-14
            Assert.That(Body.angularVelocity.Equals(expected.Float()), Is.True);
        }

        [Test]
        public void A_torque_of_another_script_adds_what_it_should_to_the_angular_momentum()
        {
            Vector3d start = Exact.AngularMomentum;
            Vector3 torque = new Vector3(0.01f, -0.02f, 0.03f);
            for (int step = 0; step < 500; step++)
            {
                Body.AddTorque(torque);
                Player.Frame(Dt);
            }

            Vector3d given = 500 * Dt * torque.Double();
            Assert.That((Exact.AngularMomentum - start - given).Length, Is.LessThan(1e-6 * given.Length)); // measured 3.8e-7 of it
        }

        [Test]
        public void A_torque_turns_it_as_the_library_does_the_better_the_shorter_the_step()
        {
            double coarse = TurnedFromTheLibrary(0.02), fine = TurnedFromTheLibrary(0.01);

            Assert.That(coarse, Is.LessThan(0.1)); // measured 0.048
            Assert.That(fine, Is.LessThan(0.5 * coarse)); // measured 0.018
        }

        [Test]
        public void Principal_axes_may_lie_across_the_body_and_change_while_it_turns()
        {
            Frames(20);
            Body.inertiaTensorRotation = new Quaternion(0.3f, -0.2f, 0.5f, 0.76f);
            Body.inertiaTensor = new Vector3(0.09f, 0.05f, 0.07f);
            MassProperties across = MassProperties.FromPrincipal(
                1, Body.inertiaTensor.Double(), Body.inertiaTensorRotation.Double().Normalized, Vector3d.Zero);
            FreeMotion free = new FreeMotion(new BodyDescription("slab", across)
            {
                Start = new BodyState(Vector3d.Zero, Exact.Orientation, Vector3d.Zero, Exact.AngularVelocity),
            });
            Frames(500);

            Assert.That(Angle(free.At(500 * Dt)), Is.LessThan(5e-7)); // measured 1.2e-7
        }

        [Test]
        public void What_a_script_sets_is_the_true_angular_velocity_from_then_on()
        {
            Frames(77);
            Body.angularVelocity = AboutTheMiddleAxis;
            FreeMotion free = Free();
            Frames(500);

            Assert.That(Angle(free.At(500 * Dt)), Is.LessThan(1e-6)); // measured 4.5e-7, from an orientation of floats
        }

        [Test]
        public void So_it_is_where_the_script_sets_it_in_its_FixedUpdate()
        {
            Spinner spinner = Body.gameObject.AddComponent<Spinner>();
            Frames(77);
            spinner.Set = AboutTheMiddleAxis;
            FreeMotion free = Free(AboutTheMiddleAxis);
            Frames(500);

            Assert.That(Angle(free.At(500 * Dt)), Is.LessThan(1e-6)); // measured 4.5e-7
        }

        [TestCase(true)]
        [TestCase(false)]
        public void Set_elsewhere_it_goes_on_from_there(bool isByTheBody)
        {
            Frames(77);
            Quaternion elsewhere = new Quaternion(0.1f, 0.7f, -0.1f, 0.7f);
            if (isByTheBody)
                Body.rotation = elsewhere;
            else
                Body.transform.rotation = elsewhere;

            // a transform is read only in the engine's step
            Player.Frame(Dt);
            FreeMotion free = Free();
            Frames(500);
            Assert.That(Angle(free.At(500 * Dt)), Is.LessThan(1e-5)); // measured 1.8e-6, from a state of floats
        }

        [Test]
        public void Steps_of_another_length_follow_the_same_motion()
        {
            FreeMotion free = Free();
            Frames(50);
            Time.fixedDeltaTime = 0.005f;
            for (int step = 0; step < 400; step++)
                Player.Frame(0.005);

            Assert.That(Angle(free.At(3)), Is.LessThan(5e-7)); // measured 5.1e-8
        }

        [Test]
        public void The_drag_of_the_Rigidbody_acts_as_the_librarys_damping()
        {
            EngineVersions.SetDrag(Body, 0, 0.5f);
            BodyDescription damped = Described(AboutTheMiddleAxis.Double()).With(new AngularDamping(-System.Math.Log(1 - 0.5f * 0.02f) / Dt));
            Frames(200);

            Assert.That(Angle(new FreeMotion(damped).At(200 * Dt)), Is.LessThan(5e-7)); // measured 2.4e-8
        }

        private double TurnedFromTheLibrary(double step)
        {
            World.Begin(isPlaying: true);
            Make();
            Time.fixedDeltaTime = (float)step;
            Vector3 torque = new Vector3(0.1f, 0.2f, -0.1f);
            BodyDescription pushed = Described(AboutTheMiddleAxis.Double()).With(Torque.Constant(torque.Double()));
            pushed.Rule = Rules.Exact6;
            Simulation library = new Simulation(TimeSteps.Every(0.005), pushed);
            library.Step(200);
            for (int i = 0; i < System.Math.Round(1 / step); i++)
            {
                Body.AddTorque(torque);
                Player.Frame(step);
            }

            return Angle(library.Bodies[0].State);
        }

        private sealed class Spinner : MonoBehaviour
        {
            public Vector3? Set { get; set; }

            private void FixedUpdate()
            {
                if (Set != null)
                    GetComponent<Rigidbody>().angularVelocity = Set.Value;

                Set = null;
            }
        }
    }
}
