using NUnit.Framework;
using UnityEngine;

namespace RigidBodyDynamics.Scripts.Tests.Edit
{
    /// <summary>Conversions between double and float.</summary>
    public sealed class ToUnityTests
    {
        [TestCase(0.02f, 0.02)]
        [TestCase(0.015f, 0.015)]
        [TestCase(0.01666667f, 0.01666667)]
        [TestCase(0.5f, 0.5)]
        public void A_float_is_taken_for_what_a_person_meant(float written, double meant) =>
            Assert.That(ToUnity.Meant(written), Is.EqualTo(meant));

        [Test]
        public void A_vector_is_rounded_to_float()
        {
            Vector3 rounded = new Vector3d(0.1, -0.2, 1e10 / 3).Float();

            Assert.That(new[] { rounded.x, rounded.y, rounded.z }, Is.EqualTo(new[] { 0.1f, -0.2f, (float)(1e10 / 3) }));
        }

        [Test]
        public void An_orientation_keeps_its_w()
        {
            Quaternion unity = new Quaterniond(0.1, 0.2, 0.3, 0.4).Float();
            Quaterniond back = new Quaternion(0.25f, 0.5f, 0.75f, 1).Double();

            Assert.That(new[] { unity.w, unity.x, unity.y, unity.z }, Is.EqualTo(new[] { 0.1f, 0.2f, 0.3f, 0.4f }));
            Assert.That(new[] { back.W, back.X, back.Y, back.Z }, Is.EqualTo(new[] { 1, 0.25, 0.5, 0.75 }));
        }

        [Test]
        public void A_vector_of_the_engine_is_taken_as_it_is()
        {
            Vector3d exact = new Vector3(0.1f, 0.2f, 0.3f).Double();

            Assert.That(new[] { exact.X, exact.Y, exact.Z }, Is.EqualTo(new double[] { 0.1f, 0.2f, 0.3f }));
        }
    }
}
