using System.Reflection;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace RigidBodyDynamics.Scripts.Tests.Edit
{
    /// <summary>The scripts before the game plays.</summary>
    public sealed class ScriptTests
    {
        private GameObject _cube;

        [SetUp]
        public void Make() => _cube = GameObject.CreatePrimitive(PrimitiveType.Cube);

        [TearDown]
        public void Destroy() => Object.DestroyImmediate(_cube);

        [Test]
        public void A_new_body_is_the_labs()
        {
            MyRigidbody body = _cube.AddComponent<MyRigidbody>();

            Assert.That(body.mass, Is.EqualTo(1));
            Assert.That(body.integrator, Is.EqualTo("LabEuler"));
            Assert.That(body.inertia, Is.EqualTo(InertiaKind.LabVertices));
            Assert.That(body.damping, Is.EqualTo(DampingKind.FactorPerStep));
            Assert.That(body.linearDecay, Is.EqualTo(0.98));
            Assert.That(body.angularDecay, Is.EqualTo(0.98));
            Assert.That(body.useGravity, Is.False);
            Assert.That(body.readsKeys, Is.True);
        }

        [Test]
        public void In_the_editor_no_body_moves()
        {
            MyRigidbody body = _cube.AddComponent<MyRigidbody>();

            Assert.That(body.IsReady, Is.False);
            Assert.That(body.Explain(), Is.Empty);
        }

        [Test]
        public void A_DefaultRigidbody_brings_its_Rigidbody()
        {
            DefaultRigidbody body = _cube.AddComponent<DefaultRigidbody>();

            Assert.That(body.GetComponent<Rigidbody>() != null, Is.True);
            Assert.That(body.angularDrag, Is.EqualTo(0.05f));
            Assert.That(body.limitsSpin, Is.True);
        }

        [Test]
        public void A_Panel_brings_its_Experiment() =>
            Assert.That(_cube.AddComponent<Panel>().GetComponent<Experiment>() != null, Is.True);

        [TestCase("mass")]
        [TestCase("inertia")]
        [TestCase("startVelocity")]
        [TestCase("startSpin")]
        [TestCase("integrator")]
        [TestCase("damping")]
        [TestCase("linearDecay")]
        [TestCase("angularDecay")]
        [TestCase("linearRate")]
        [TestCase("angularRate")]
        [TestCase("useGravity")]
        [TestCase("readsKeys")]
        [TestCase("comparedWith")]
        public void A_setting_is_saved_and_explained(string field)
        {
            using (SerializedObject saved = new SerializedObject(_cube.AddComponent<MyRigidbody>()))
                Assert.That(saved.FindProperty(field), Is.Not.Null);

            // in English and, in a second line, in Chinese
            TooltipAttribute tooltip = typeof(MyRigidbody).GetField(field).GetCustomAttribute<TooltipAttribute>();
            Assert.That(tooltip.tooltip.Split('\n').Length, Is.EqualTo(2));
        }

        [Test]
        public void A_setting_made_in_the_inspector_arrives()
        {
            MyRigidbody body = _cube.AddComponent<MyRigidbody>();
            using (SerializedObject saved = new SerializedObject(body))
            {
                saved.FindProperty("mass").doubleValue = 2.5;
                saved.FindProperty("integrator").stringValue = "Exact";
                saved.ApplyModifiedProperties();
            }

            Assert.That(body.mass, Is.EqualTo(2.5));
            Assert.That(body.integrator, Is.EqualTo("Exact"));
        }
    }
}
