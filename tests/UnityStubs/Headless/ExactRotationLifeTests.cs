using NUnit.Framework;
using RigidBodyDynamics.Engine;
using UnityEngine;
using UnityEngine.TestTools;

namespace RigidBodyDynamics.Scripts.Tests.Headless
{
    /// <summary>When ExactRotation leaves a body to the engine, and its continuation after the body was disabled, asleep or the game paused.</summary>
    public sealed class ExactRotationLifeTests : ThrownSlab
    {
        [TestCase(RigidbodyConstraints.FreezeRotationX)]
        [TestCase(RigidbodyConstraints.FreezeRotationY | RigidbodyConstraints.FreezeRotationZ)]
        [TestCase(RigidbodyConstraints.FreezeRotation)]
        public void With_an_axis_frozen_it_leaves_the_engine_alone(RigidbodyConstraints frozen)
        {
            Rigidbody other = Thrown(AboutTheMiddleAxis).GetComponent<Rigidbody>();
            other.constraints = Body.constraints = frozen;
            Frames(100);

            Assert.That(Exact.IsTurning, Is.False);
            Assert.That(Body.rotation.Equals(other.rotation), Is.True);
            Assert.That(Body.angularVelocity.Equals(other.angularVelocity), Is.True);
        }

        [Test]
        public void A_cube_needs_nothing()
        {
            Body.transform.localScale = Vector3.one;
            Frames(100);

            Assert.That(Exact.IsTurning, Is.False);
            Assert.That(Body.angularVelocity.Equals(AboutTheMiddleAxis), Is.True);
        }

        [Test]
        public void Switched_off_the_engine_goes_on_with_the_true_angular_velocity_and_its_own_limit()
        {
            Frames(20);
            Vector3 last = Exact.AngularVelocity.Float();
            Exact.enabled = false;
            Frames(10);
            Assert.That(Body.angularVelocity.Equals(last), Is.True);
            Assert.That(Body.maxAngularVelocity, Is.EqualTo(7));

            Exact.enabled = true;
            FreeMotion free = Free();
            Frames(500);
            Assert.That(Angle(free.At(500 * Dt)), Is.LessThan(5e-7)); // measured 1.2e-8
        }

        [Test]
        public void A_sleeping_object_is_not_turned_and_goes_on_when_it_wakes()
        {
            Frames(77);
            Body.gameObject.SetActive(false);
            Frames(10);
            Body.gameObject.SetActive(true);
            FreeMotion free = Free();
            Frames(500);

            Assert.That(Angle(free.At(500 * Dt)), Is.LessThan(5e-7)); // measured 1.1e-7
        }

        [Test]
        public void While_time_stands_still_so_does_it()
        {
            Frames(50);
            Quaternion before = Body.rotation;
            FreeMotion free = Free(Exact.AngularVelocity);
            Time.timeScale = 0;
            Frames(50);
            Assert.That(Body.rotation.Equals(before), Is.True);

            Time.timeScale = 0.5f;
            Frames(100);
            Assert.That(Angle(free.At(50 * Dt)), Is.LessThan(5e-7)); // measured 1.9e-8
        }

        [Test]
        public void It_falls_asleep_a_fifth_of_a_second_after_the_engine_would_let_it_and_wakes()
        {
            Body.angularVelocity = new Vector3(0.005f, 0.01f, 0.02f);
            Rigidbody other = Thrown(Body.angularVelocity).GetComponent<Rigidbody>();
            int step = 0;
            for (; step < 100 && !other.IsSleeping(); step++)
            {
                Assert.That(Body.IsSleeping(), Is.False);
                Player.Frame(Dt);
            }

            Assert.That(step, Is.LessThan(30));
            Frames(12);
            Assert.That(Body.IsSleeping(), Is.True);
            Quaternion asleep = Body.rotation;
            Frames(10);
            Assert.That(Body.rotation.Equals(asleep) && Body.IsSleeping(), Is.True);

            Body.AddTorque(new Vector3(0, 5, 0));
            Frames(2);
            Assert.That(Exact.IsTurning, Is.True);
        }

        [Test]
        public void One_step_of_the_experiment_is_one_of_the_exact_motion()
        {
            Experiment experiment = new GameObject("Experiment").AddComponent<Experiment>();
            FreeMotion free = Free();
            for (int step = 0; step < 50; step++)
                experiment.StepOnce();

            Assert.That(Angle(free.At(50 * Dt)), Is.LessThan(5e-7)); // measured 2.1e-8
        }

        [Test]
        public void Destroyed_it_leaves_theBody_to_the_engine()
        {
            Frames(10);
            Object.DestroyImmediate(Exact);
            Frames(10);
            Object.DestroyImmediate(Body.gameObject);
            Frames(10);

            Assert.That(UnityConsole.Fault(), Is.Null);
        }

        [Test]
        public void Two_that_are_alike_move_alike()
        {
            Rigidbody other = Thrown(AboutTheMiddleAxis).GetComponent<Rigidbody>();
            other.gameObject.AddComponent<ExactRotation>();
            Frames(500);

            Assert.That(other.rotation.Equals(Body.rotation), Is.True);
        }

        [Test]
        public void Above_its_limit_it_loses_what_the_engine_takes()
        {
            Exact.maxAngularVelocity = 3;
            Frames(100);

            Assert.That(Exact.AngularVelocity.Length, Is.LessThan(3.01));
        }

        [Test]
        public void A_body_that_cannot_be_is_refused_with_its_moments()
        {
            LogAssert.Expect(LogType.Error, new System.Text.RegularExpressions.Regex("ExactRotation on 'Cube': principal: no moment can exceed the sum of the other two.* found .1, 1, 5."));
            Body.isKinematic = true;
            Body.inertiaTensor = new Vector3(1, 1, 5);
            Frames(1);

            Assert.That(Exact.enabled, Is.False);
        }

        [Test]
        public void Of_a_thin_plate_the_engines_rounding_is_forgiven()
        {
            Body.isKinematic = true;
            Body.inertiaTensor = new Vector3(1, 2, 3.000001f);
            Frames(1);

            Assert.That(Exact.enabled, Is.True);
        }

        [Test]
        public void A_kinematicBody_is_not_touched()
        {
            Body.isKinematic = true;
            Frames(10);

            Assert.That(Exact.IsTurning, Is.False);
            Assert.That(Body.rotation.Equals(Quaternion.identity), Is.True);
        }
    }
}
