using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using RigidBodyDynamics.Engine;
using UnityEngine;
using UnityEngine.TestTools;

namespace RigidBodyDynamics.Scripts.Tests.Headless
{
    /// <summary>The stand-in keeps Unity's order and Unity's time.</summary>
    public sealed class PlayerTests
    {
        [Test]
        public void Messages_come_in_the_order_of_the_engine()
        {
            Probe probe = new GameObject("probe").AddComponent<Probe>();
            Player.Frame(0.02);
            probe.enabled = false;
            Object.DestroyImmediate(probe.gameObject);

            string[] expected = { "Awake", "OnEnable", "Start", "FixedUpdate", "Update", "LateUpdate", "OnGUI Layout", "OnGUI Repaint", "OnDisable", "OnDestroy" };
            Assert.That(probe.Heard, Is.EqualTo(expected));
        }

        [Test]
        public void A_script_on_a_sleeping_object_wakes_with_it()
        {
            GameObject holder = new GameObject("probe");
            holder.SetActive(false);
            Probe probe = holder.AddComponent<Probe>();
            Player.Frame(0.02);
            Assert.That(probe.Heard, Is.Empty);

            holder.SetActive(true);

            Assert.That(probe.Heard, Is.EqualTo(new[] { "Awake", "OnEnable" }));
        }

        [TestCase(0.01, 100, 50)]
        [TestCase(1.0 / 60, 60, 50)]
        [TestCase(0.1, 10, 50)]
        [TestCase(0.5, 2, 33)] // a frame counts for a third of a second at most: 33.3 steps
        public void A_second_of_frames_has_its_fixed_steps(double frame, int frames, int steps)
        {
            Probe probe = new GameObject("probe").AddComponent<Probe>();
            for (int i = 0; i < frames; i++)
                Player.Frame(frame);

            Assert.That(probe.Heard.Count(message => message == "FixedUpdate"), Is.EqualTo(steps));
            Assert.That(probe.Heard.Count(message => message == "Update"), Is.EqualTo(frames));
            Assert.That(probe.DeltaTimes, Is.All.EqualTo(Time.fixedDeltaTime));
        }

        [Test]
        public void Where_time_stands_still_frames_go_on_and_steps_do_not()
        {
            Probe probe = new GameObject("probe").AddComponent<Probe>();
            Time.timeScale = 0;
            for (int i = 0; i < 10; i++)
                Player.Frame(0.1);

            Assert.That(probe.Heard, Has.None.EqualTo("FixedUpdate"));
            Assert.That(probe.Heard.Count(message => message == "Update"), Is.EqualTo(10));
            Assert.That(Time.time, Is.Zero);
            Assert.That(Time.unscaledTime, Is.EqualTo(1).Within(1e-6));
        }

        [Test]
        public void An_exception_in_a_script_goes_to_the_console()
        {
            LogAssert.Expect(LogType.Exception, new System.Text.RegularExpressions.Regex("broken"));
            new GameObject("broken").AddComponent<Broken>();
        }

        [Test]
        public void An_error_that_nobody_expects_is_a_fault()
        {
            Debug.LogError("wrong");
            string fault = UnityConsole.Fault();
            LogAssert.Expect(LogType.Error, "wrong");

            Assert.That(fault, Does.Contain("wrong"));
            Assert.That(UnityConsole.Fault(), Is.Null);
        }

        [Test]
        public void The_old_input_throws_where_a_project_has_the_new_one_alone()
        {
#if ENABLE_LEGACY_INPUT_MANAGER
            Keys.Hold(KeyCode.R, true);
            Assert.That(Input.GetKey(KeyCode.R), Is.True);
#else
            Assert.That(() => Input.GetKey(KeyCode.R), Throws.InvalidOperationException);
#endif
        }

        [Test]
        public void Vectors_are_compared_as_the_engine_does()
        {
            Assert.That(new Vector3(1, 2, 3) == new Vector3(1.000001f, 2, 3), Is.True);
            Assert.That(new Vector3(1, 2, 3) == new Vector3(1.0001f, 2, 3), Is.False);
            Assert.That(new Vector3(1, 2, 3).Equals(new Vector3(1.000001f, 2, 3)), Is.False);
        }

        private sealed class Probe : MonoBehaviour
        {
            public List<string> Heard { get; } = new List<string>();

            public List<float> DeltaTimes { get; } = new List<float>();

            private void Awake() => Heard.Add("Awake");

            private void OnEnable() => Heard.Add("OnEnable");

            private void Start() => Heard.Add("Start");

            private void FixedUpdate()
            {
                Heard.Add("FixedUpdate");
                DeltaTimes.Add(Time.deltaTime);
            }

            private void Update() => Heard.Add("Update");

            private void LateUpdate() => Heard.Add("LateUpdate");

            private void OnGUI() => Heard.Add("OnGUI " + Event.current.type);

            private void OnDisable() => Heard.Add("OnDisable");

            private void OnDestroy() => Heard.Add("OnDestroy");
        }

        private sealed class Broken : MonoBehaviour
        {
            private void Awake() => throw new System.InvalidOperationException("broken");
        }
    }
}
