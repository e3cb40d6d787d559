using NUnit.Framework;
using RigidBodyDynamics.Engine;
using UnityEngine;

namespace RigidBodyDynamics.Scripts.Tests.Headless
{
    /// <summary>Scripts written for a Rigidbody find its members on MyRigidbody, and the same motion where both have one.</summary>
    public sealed class RigidbodyMembersTests
    {
        private static readonly ForceMode[] Modes = { ForceMode.Force, ForceMode.Acceleration, ForceMode.Impulse, ForceMode.VelocityChange };
        private MyRigidbody _mine;
        private Rigidbody _theirs;

        // Unity's body rounds to float and has no damping here; it moves by the same semi-implicit integrator
        [SetUp]
        public void Make()
        {
            GameObject mine = GameObject.CreatePrimitive(PrimitiveType.Cube), theirs = GameObject.CreatePrimitive(PrimitiveType.Cube);
            theirs.transform.position = mine.transform.position = new Vector3(1, 2, 3);
            theirs.transform.rotation = mine.transform.rotation = Quaternion.Euler(0, 90, 0);
            UnityEngine.Object.DestroyImmediate(mine.GetComponent<BoxCollider>());
            mine.SetActive(false);
            _mine = mine.AddComponent<MyRigidbody>();
            _mine.mass = 2;
            _mine.inertia = InertiaKind.SolidBox;
            _mine.damping = DampingKind.None;
            _mine.readsKeys = false;
            mine.SetActive(true);
            _theirs = theirs.AddComponent<Rigidbody>();
            _theirs.mass = 2;
            _theirs.useGravity = false;
            EngineVersions.SetDrag(_theirs, 0, 0);
        }

        [TestCaseSource(nameof(Modes))]
        public void A_force_moves_both_alike(ForceMode mode)
        {
            _mine.AddForce(new Vector3(1, 2, 3), mode);
            _theirs.AddForce(new Vector3(1, 2, 3), mode);
            MoveAlike();
            Assert.That(_mine.velocity.y, Is.EqualTo(2 / (mode == ForceMode.Force || mode == ForceMode.Impulse ? 2f : 1) * (mode == ForceMode.Force || mode == ForceMode.Acceleration ? 0.02f : 1)).Within(1e-6f));
        }

        // on 2/6 kg m² of a solid cube of 2 kg
        [TestCase(ForceMode.Force, 0.02 / (2.0 / 6))]
        [TestCase(ForceMode.Acceleration, 0.02)]
        [TestCase(ForceMode.Impulse, 1 / (2.0 / 6))]
        [TestCase(ForceMode.VelocityChange, 1)]
        public void A_torque_turns_by_its_mode(ForceMode mode, double spin)
        {
            _mine.AddTorque(new Vector3(0.25f, 0.5f, 1), mode);
            Player.Frame(0.02);

            Vector3d found = _mine.State.AngularVelocity;
            Assert.That(new[] { found.X, found.Y, found.Z }, Is.EqualTo(new[] { 0.25 * spin, 0.5 * spin, spin }).Within(1e-14));
        }

        [TestCaseSource(nameof(Modes))]
        public void Relative_ones_are_along_the_objects_own_axes(ForceMode mode)
        {
            _mine.AddRelativeForce(new Vector3(0, 0, 1), mode);
            _mine.AddRelativeTorque(new Vector3(0, 0, 0.1f), mode);
            Player.Frame(0.02);

            // z of a cube turned by 90 degrees about y is x of the world
            Assert.That(_mine.velocity.x, Is.GreaterThan(0.005f));
            Assert.That(_mine.velocity.z, Is.EqualTo(0).Within(1e-7f));
            Assert.That(_mine.angularVelocity.x, Is.GreaterThan(0.001f));
            Assert.That(_mine.angularVelocity.z, Is.EqualTo(0).Within(1e-7f));
        }

        [Test]
        public void A_force_at_a_point_turns_too()
        {
            _mine.AddForceAtPosition(new Vector3(0, 0, 3), new Vector3(1, 2.5f, 3), ForceMode.Impulse);

            // r × J = (0, 0.5, 0) × (0, 0, 3), on 2/6 kg m² of a solid cube of 2 kg
            Assert.That(_mine.velocity.z, Is.EqualTo(1.5f).Within(1e-6f));
            Assert.That(_mine.angularVelocity.x, Is.EqualTo(4.5f).Within(1e-6f));
            // v + ω × r of that point
            Assert.That(_mine.GetPointVelocity(new Vector3(1, 2.5f, 3)).z, Is.EqualTo(1.5f + 4.5f * 0.5f).Within(1e-6f));
            Assert.That(_mine.GetPointVelocity(_mine.worldCenterOfMass).z, Is.EqualTo(1.5f).Within(1e-6f));
        }

        [Test]
        public void A_push_of_a_script_that_comes_later_acts_in_the_same_step()
        {
            new GameObject("pusher").AddComponent<Pusher>().Pushed = _mine;
            Player.Frame(0.02);

            Assert.That(_mine.velocity.x, Is.EqualTo(0.02f * 4 / 2).Within(1e-7f));
        }

        [Test]
        public void Velocities_can_be_set_and_the_body_be_put_elsewhere()
        {
            _mine.velocity = new Vector3(1, 0, 0);
            _mine.linearVelocity += new Vector3(0, 1, 0);
            _mine.angularVelocity = new Vector3(0, 9, 0);
            _mine.MovePosition(new Vector3(5, 5, 5));
            _mine.MoveRotation(new Quaternion(0, 0, 0, 2));
            Assert.That(_mine.transform.position == new Vector3(5, 5, 5), Is.True);
            Assert.That(_mine.rotation == Quaternion.identity, Is.True);
            Player.Frame(0.02);

            Assert.That(_mine.position == new Vector3(5.02f, 5.02f, 5), Is.True);
            // no limit of 7 rad/s
            Assert.That(_mine.angularVelocity.y, Is.EqualTo(9).Within(1e-6f));
        }

        [Test]
        public void Frozen_axes_stay()
        {
            _mine.velocity = Vector3.one;
            _mine.angularVelocity = Vector3.one;
            _mine.constraints = RigidbodyConstraints.FreezePositionY | RigidbodyConstraints.FreezeRotation;
            _mine.SendMessage("OnValidate");
            Player.Frame(0.02);
            _mine.AddForce(new Vector3(1, 1, 1));
            _mine.AddTorque(new Vector3(1, 1, 1));
            _mine.velocity += new Vector3(0, 7, 0);
            Player.Frame(0.02);

            Assert.That(_mine.velocity.y, Is.Zero);
            Assert.That(_mine.velocity.x, Is.EqualTo(1.01f).Within(1e-6f));
            Assert.That(_mine.position.y, Is.EqualTo(2));
            Assert.That(_mine.angularVelocity.magnitude, Is.Zero);
        }

        [Test]
        public void A_body_that_sleeps_feels_nothing_until_it_is_pushed()
        {
            _mine.useGravity = true;
            _mine.SendMessage("OnValidate");
            _mine.velocity = Vector3.one;
            _mine.Sleep();
            Frames(10);
            Assert.That(_mine.IsSleeping(), Is.True);
            Assert.That(_mine.position == new Vector3(1, 2, 3), Is.True);

            _mine.AddForce(new Vector3(2, 0, 0));
            Player.Frame(0.02);
            Assert.That(_mine.IsSleeping(), Is.False);
            Assert.That(_mine.velocity.x, Is.EqualTo(0.02f).Within(1e-7f));
            Assert.That(_mine.velocity.y, Is.EqualTo(-9.81f * 0.02f).Within(1e-6f));
        }

        [Test]
        public void Between_two_steps_it_is_drawn_between_them_and_read_exactly()
        {
            _mine.interpolation = RigidbodyInterpolation.Interpolate;
            _mine.velocity = new Vector3(10, 0, 0);
            double before = 0;
            int steps = 0;
            for (int frame = 0; frame < 60; frame++)
            {
                foreach (Moment moment in Player.Moments(0.02 / 3))
                    steps += moment == Moment.AfterFixedStep ? 1 : 0;

                double drawn = _mine.transform.position.x;
                Assert.That(_mine.State.Position.X, Is.EqualTo(1 + 10 * 0.02 * steps).Within(1e-12));
                Assert.That(drawn, Is.InRange(_mine.State.Position.X - 0.2001, _mine.State.Position.X + 1e-6));
                // evenly, whether or not a step was in the frame
                if (frame > 6)
                    Assert.That(drawn - before, Is.EqualTo(10 * 0.02 / 3).Within(1e-4));

                before = drawn;
            }

            Assert.That(_mine.velocity.x, Is.EqualTo(10));
        }

        private void MoveAlike()
        {
            Frames(10);
            Assert.That((_mine.position - _theirs.position).magnitude, Is.LessThan(1e-5f));
            Assert.That((_mine.velocity - EngineVersions.Velocity(_theirs)).magnitude, Is.LessThan(1e-6f));
            Assert.That((_mine.angularVelocity - _theirs.angularVelocity).magnitude, Is.LessThan(2e-5f));
        }

        private static void Frames(int count)
        {
            for (int i = 0; i < count; i++)
                Player.Frame(0.02);
        }

        private sealed class Pusher : MonoBehaviour
        {
            internal MyRigidbody Pushed;

            private void FixedUpdate() => Pushed.AddForce(new Vector3(4, 0, 0));
        }
    }
}
