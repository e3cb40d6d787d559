using NUnit.Framework;
using RigidBodyDynamics.Engine;
using UnityEngine;

namespace RigidBodyDynamics.Scripts.Tests.Headless
{
    /// <summary>The stand-in's Rigidbody takes what scripts tell it.</summary>
    public sealed class RigidbodyTests
    {
        private const float Dt = 0.02f;
        private Rigidbody _body;

        [SetUp]
        public void Make()
        {
            _body = GameObject.CreatePrimitive(PrimitiveType.Cube).AddComponent<Rigidbody>();
            _body.useGravity = false;
        }

        [Test]
        public void Forces_add_up_act_once_and_are_gone()
        {
            _body.AddForce(new Vector3(1, 0, 0));
            _body.AddForce(new Vector3(2, 0, 0));
            Player.Frame(Dt);
            Player.Frame(Dt);

            Assert.That(_body.angularVelocity, Is.EqualTo(Vector3.zero));
            Assert.That(_body.position.x, Is.EqualTo(2 * 3 * Dt * Dt).Within(1e-7f));
            Assert.That(_body.transform.position.Equals(_body.position), Is.True);
        }

        [Test]
        public void Inertia_is_the_colliders_until_a_script_sets_it()
        {
            _body.mass = 2;
            _body.transform.localScale = new Vector3(1, 2, 3);
            Assert.That(_body.inertiaTensor == new Vector3(13f / 6, 10f / 6, 5f / 6), Is.True, _body.inertiaTensor.ToString());

            _body.inertiaTensor = new Vector3(7, 8, 9);
            _body.AddTorque(new Vector3(7, 0, 0));
            Player.Frame(Dt);
            Assert.That(_body.angularVelocity.x, Is.EqualTo(Dt * (1 - 0.05f * Dt)).Within(1e-7f));

            _body.ResetInertiaTensor();
            Assert.That(_body.inertiaTensor.x, Is.EqualTo(13f / 6));
        }

        [Test]
        public void A_body_at_rest_sleeps_and_a_force_of_zero_does_not_wake_it()
        {
            for (int step = 0; step < 25; step++)
                Player.Frame(Dt);

            Assert.That(_body.IsSleeping(), Is.True);
            _body.AddForce(Vector3.zero);
            Player.Frame(Dt);
            Assert.That(_body.IsSleeping(), Is.True);
            _body.AddForce(Vector3.up);
            Player.Frame(Dt);
            Assert.That(_body.IsSleeping(), Is.False);
            Assert.That(_body.position.y, Is.GreaterThan(0));
        }

        [Test]
        public void It_falls_and_goes_on_from_where_a_script_puts_it()
        {
            _body.useGravity = true;
            Player.Frame(Dt);
            Assert.That(_body.position.y, Is.EqualTo(Physics.gravity.y * Dt * Dt).Within(1e-7f));

            _body.transform.position = new Vector3(5, 6, 7);
            Assert.That(_body.position.x, Is.Zero, "before physics has looked");
            _body.useGravity = false;
            Player.Frame(Dt);
            Assert.That(_body.position.x, Is.EqualTo(5));
            Assert.That(_body.position.y, Is.LessThan(6), "it keeps its velocity");
        }

        [Test]
        public void No_faster_than_seven_radians_a_second()
        {
            _body.angularVelocity = new Vector3(0, 100, 0);
            Player.Frame(Dt);

            Assert.That(_body.angularVelocity.y, Is.EqualTo(7).Within(1e-5f));
        }

        [Test]
        public void A_script_steps_physics_only_where_it_has_said_so()
        {
            _body.angularVelocity = Vector3.one;
            Physics.Simulate(Dt);
            Assert.That(_body.rotation.Equals(Quaternion.identity), Is.True);

            EngineVersions.StepPhysics();
            Assert.That(_body.rotation.Equals(Quaternion.identity), Is.False);
        }
    }
}
