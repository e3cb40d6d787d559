using System;
using System.Linq;
using NUnit.Framework;
using RigidBodyDynamics.Engine;
using UnityEditor;
using UnityEngine;
using UnityEngine.TestTools;

namespace RigidBodyDynamics.Scripts.Tests.Headless
{
    /// <summary>The inspector shows every setting, and the catalogue as a menu; the gizmos show the motion.</summary>
    public sealed class InspectorTests
    {
        private GameObject _cube;

        [SetUp]
        public void Make() => _cube = GameObject.CreatePrimitive(PrimitiveType.Cube);

        [Test]
        public void It_shows_every_setting_and_what_the_motion_consists_of()
        {
            MyRigidbody body = _cube.AddComponent<MyRigidbody>();
            Gui.Draw(Editor.CreateEditor(body));

            Assert.That(Gui.Drawn.Count(control => control.Kind == "property"), Is.EqualTo(14));
            Assert.That(Gui.Drawn[0], Is.EqualTo(("disabled property", "Script")), "a double click opens it");
            Assert.That(Gui.Drawn, Has.Member(("menu", "Integrator")).And.Member(("property", "Start Velocity")));
            Assert.That(Gui.Drawn, Has.Member(("help Info", body.Explain())));
            Assert.That(Gui.Drawn, Has.Member(("help None", Rules.All.Single(rule => rule.Name == "LabEuler").About)));
        }

        [Test]
        public void An_integrator_chosen_there_is_the_bodys_from_the_next_step_on()
        {
            MyRigidbody body = _cube.AddComponent<MyRigidbody>();
            Editor inspector = Editor.CreateEditor(body);
            string[] names = Rules.All.Select(rule => rule.Name).ToArray();

            Gui.Choose(inspector, "Integrator", Array.IndexOf(names, "Exact"));
            Player.Frame(0.02);

            Assert.That(body.integrator, Is.EqualTo("Exact"));
            Assert.That(body.Body.Rule.Name, Is.EqualTo("Exact"));
        }

        [Test]
        public void A_Rigidbody_on_the_same_object_is_said_there_too()
        {
            LogAssert.ignoreFailingMessages = true;
            _cube.AddComponent<Rigidbody>();
            Gui.Draw(Editor.CreateEditor(_cube.AddComponent<MyRigidbody>()));

            Assert.That(Gui.Drawn.Count(control => control.Kind == "help Error"), Is.EqualTo(1));
        }

        [Test]
        public void Gizmos_draw_the_spin_the_momentum_and_three_axes()
        {
            MotionGizmos gizmos = _cube.AddComponent<MotionGizmos>();
            MyRigidbody body = gizmos.GetComponent<MyRigidbody>();
            body.startSpin = new Vector3(0, 2, 0);
            body.damping = DampingKind.None;
            body.StartAgain();
            Player.Frame(0.02);

            Assert.That(Gizmos.Rays.Select(ray => ray.Color), Is.EqualTo(new[] { Color.yellow, Color.magenta, Color.red, Color.green, Color.blue }));
            Assert.That(Gizmos.Rays[0].Direction == new Vector3(0, 0.3f * 2, 0), Is.True);
            Assert.That(Gizmos.Rays[1].Direction == new Vector3(0, 0.3f * 2 * 0.5f, 0), Is.True);
            Assert.That(Gizmos.Rays[3].Direction == new Vector3(0, 0.5f * (float)Math.Sqrt(2), 0), Is.True);
        }
    }
}
