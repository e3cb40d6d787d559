using System;
using System.IO;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using RigidBodyDynamics.Engine;
using UnityEditor.Compilation;
using UnityEngine;

namespace RigidBodyDynamics.Scripts.Tests.Headless
{
    /// <summary>A student's own script beside ours and Unity's: its motion is in the panel, in a recording and in a comparison.</summary>
    public sealed class StudentBodyTests
    {
        private const int TenSeconds = 500;
        private static readonly Type Right = Compiled(StarterTests.Right);
        private static readonly Type TwiceTheForce = Compiled(Changed("force / mass", "2 * force / mass"));
        private static readonly Type TwiceTheTurn = Compiled(Changed("dt / 2, w.y * dt / 2, w.z * dt / 2", "dt, w.y * dt, w.z * dt"));

        private Experiment _experiment;
        private StudentBody _student;

        [TearDown]
        public void LetGo() => LabInput.LetGo();

        [Test]
        public void A_right_script_stays_beside_ours_by_LabEuler()
        {
            Build(Right);
            double farthest = 0;
            for (int frame = 0; frame < TenSeconds; frame++)
            {
                Keys.Hold(KeyCode.RightArrow, frame < 100);
                Keys.Hold(KeyCode.UpArrow, frame >= 50 && frame < 150);
                Player.Frame(0.02);
                farthest = Math.Max(farthest, _student.DistanceTo(_student.Mine.StartState(), _student.Mine.State));
            }

            Assert.That(_student.State.Position.Length, Is.GreaterThan(1));
            Assert.That(farthest, Is.LessThan(2e-5)); // measured 1.2e-5, a float at 14 m is 1e-6 apart
            Assert.That(Shown("to My cube"), Does.StartWith("0.000 m"));
            Assert.That(Shown("frames a step"), Is.EqualTo("1.00"));
        }

        [Test]
        public void A_wrong_script_parts_and_the_panel_says_by_how_much()
        {
            Build(TwiceTheForce);
            Keys.Hold(KeyCode.RightArrow, true);
            Frames(50);

            // twice the force is twice the way, so they part by the way of ours: Σ v Δt with v = 0.1 (1 − 0.98ᵏ) / 0.02
            double way = Enumerable.Range(1, 50).Sum(k => 0.02 * 0.1 * (1 - Math.Pow(0.98, k)) / 0.02);
            Assert.That(_student.DistanceTo(_student.Mine.StartState(), _student.Mine.State), Is.EqualTo(way).Within(1e-5)); // measured 3.8e-7
            Assert.That(Shown("to My cube"), Does.StartWith(way.ToString("0.000", System.Globalization.CultureInfo.InvariantCulture) + " m"));
            Assert.That(Shown("to Default cube"), Does.EndWith("°"));
        }

        [Test]
        public void Speed_and_spin_are_what_the_pose_changed_by()
        {
            Build(Right);
            Keys.Hold(KeyCode.RightArrow, true);
            Frames(50);

            double speed = 0.1 * (1 - Math.Pow(0.98, 50)) / 0.02; // of the step, before it was damped
            Assert.That(_student.State.Velocity.X, Is.EqualTo(speed).Within(1e-4)); // measured 7.1e-7
            Assert.That(Gui.Texts, Has.Member("— Script —").And.Member(speed.ToString("0.00", System.Globalization.CultureInfo.InvariantCulture) + " m/s"));
            Keys.Hold(KeyCode.R, true);
            Frames(50);
            Assert.That(_student.State.AngularVelocity.Length, Is.EqualTo(SpinOfScript() / 0.98).Within(1e-3)); // measured 3.2e-4: the step turns by 2 atan(½Δt ω)
        }

        [Test]
        public void A_script_that_is_stepped_in_Update_goes_ahead_where_frames_are_shorter_and_the_panel_says_so()
        {
            Build(Right);
            Keys.Hold(KeyCode.RightArrow, true);
            for (int frame = 0; frame < 100; frame++)
                Player.Frame(0.01);

            Assert.That(_student.State.Position.X, Is.GreaterThan(2 * _student.Mine.State.Position.X));
            Assert.That(double.Parse(Shown("frames a step"), System.Globalization.CultureInfo.InvariantCulture), Is.EqualTo(2).Within(0.05));
        }

        [Test]
        public void Reset_puts_back_the_pose_the_script_and_what_the_inspector_had_set()
        {
            Build(Right, script => script.GetType().GetField("mass").SetValue(script, 2f));
            Vector3 start = _student.Transform.position;
            float[] first = Way(), again = null;
            _experiment.StartAgain();
            Assert.That(_student.Transform.position.Equals(start), Is.True);
            Assert.That(_student.State.Velocity.Length, Is.Zero);
            again = Way();

            Assert.That(again, Is.EqualTo(first));
            Assert.That(first.Last(), Is.GreaterThan(0.5f));
            Assert.That(Script().GetType().GetField("mass").GetValue(Script()), Is.EqualTo(2f));
        }

        [Test]
        public void Pause_holds_the_script_and_one_step_is_one_of_its_frames()
        {
            Build(Right);
            Keys.Hold(KeyCode.RightArrow, true);
            Frames(5);
            Gui.Click("pause");
            float paused = _student.Transform.position.x;
            Frames(5);
            Assert.That(_student.Transform.position.x, Is.EqualTo(paused));

            Gui.Click("one step");
            Frames(5);
            Assert.That(_student.Frames, Is.EqualTo(6));
            Assert.That(_student.DistanceTo(_student.Mine.StartState(), _student.Mine.State), Is.LessThan(1e-6));

            Gui.Click("reset");
            Gui.Click("one step");
            Frames(5);
            Assert.That(_student.Transform.position.x, Is.EqualTo(5 * 0.02f * 0.02f).Within(1e-8f));
            Gui.Click("run");
            Frames(5);
            Assert.That(_student.Frames, Is.EqualTo(6));
        }

        [TestCase(1.0 / 50)]
        [TestCase(1.0 / 144)]
        public void Compare_finds_a_right_script_where_the_labs_integrator_is_at_any_frame_rate(double frame)
        {
            Build(Right);
            string output = RecordAndCompare(frame, out int exitCode);

            Assert.That(exitCode, Is.Zero, output);
            Assert.That(output, Does.Contain("LabEuler first differs").And.Not.Contain("velocity"));
            Assert.That(output, Does.Match(@"position\W+\d(\.\d+)?E-06 m").And.Match(@"orientation\W+\d(\.\d+)?E-0[67] ")); // measured 5.8e-6 m, 1.1e-6
        }

        [Test]
        public void Compare_says_how_far_a_wrong_script_is_from_the_labs_integrator()
        {
            Build(TwiceTheTurn);
            string output = RecordAndCompare(1.0 / 60, out int exitCode);

            Assert.That(exitCode, Is.EqualTo(1), output);
            Assert.That(output, Does.Match(@"position\W+\d(\.\d+)?E-0[5-9] m"));
            Assert.That(output, Does.Match(@"orientation\W+1\.\d+ ")); // measured 1.13
        }

        private static string RecordAndCompare(double frame, out int exitCode)
        {
            Frames(1);
            Gui.Click("record");
            for (int i = 0; i < 400; i++)
            {
                Keys.Hold(KeyCode.R, i >= 20 && i < 250);
                Keys.Hold(KeyCode.LeftArrow, i >= 50 && i < 120);
                Keys.Hold(KeyCode.UpArrow, i >= 100 && i < 130);
                Player.Frame(frame);
            }

            Gui.Click("stop");
            string json = Directory.GetFiles(Path.Combine(Application.persistentDataPath, "recordings"), "Script-script-*.json").Single();
            return RecordingCompareTests.Compare(json, out exitCode);
        }

        private void Build(Type script, Action<Component> set = null)
        {
            _experiment = Laboratory.Build();
            GameObject cube = GameObject.CreatePrimitive(PrimitiveType.Cube);
            cube.name = "Script";
            cube.transform.position = new Vector3(0, 0, 3);
            cube.SetActive(false);
            Component added = cube.AddComponent(script);
            set?.Invoke(added);
            cube.SetActive(true);
            _student = _experiment.Students.Single();
        }

        private float[] Way()
        {
            Keys.Hold(KeyCode.RightArrow, true);
            return Enumerable.Range(0, 50).Select(frame =>
            {
                Player.Frame(0.02);
                return _student.Transform.position.x;
            }).ToArray();
        }

        private MonoBehaviour Script() => _student.Transform.GetComponents<MonoBehaviour>().Single(StudentBody.Is);

        private float SpinOfScript() =>
            ((Vector3)Script().GetType().GetField("w", BindingFlags.Instance | BindingFlags.NonPublic).GetValue(Script())).magnitude;

        // what stands beside a label of the panel
        private static string Shown(string label) => Gui.Texts.SkipWhile(text => text != label).Skip(1).First();

        private static void Frames(int count)
        {
            for (int i = 0; i < count; i++)
                Player.Frame(0.02);
        }

        private static string Changed(string right, string wrong)
        {
            Assert.That(StarterTests.Right, Does.Contain(right));
            return StarterTests.Right.Replace(right, wrong);
        }

        private static Type Compiled(string script)
        {
            string path = Path.Combine(Path.GetTempPath(), "student-" + Guid.NewGuid().ToString("N"));
            File.WriteAllText(path + ".cs", script);
            AssemblyBuilder builder = new AssemblyBuilder(path + ".dll", path + ".cs");
            builder.buildFinished += (built, messages) => Assert.That(messages.Select(message => message.message), Is.Empty);
            builder.Build();
            Type type = System.Reflection.Assembly.Load(File.ReadAllBytes(path + ".dll")).GetType("MyRigidbody", throwOnError: true);
            File.Delete(path + ".cs");
            File.Delete(path + ".dll");
            return type;
        }
    }
}
