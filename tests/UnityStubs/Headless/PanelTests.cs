using System.Linq;
using NUnit.Framework;
using RigidBodyDynamics.Engine;
using UnityEngine;

namespace RigidBodyDynamics.Scripts.Tests.Headless
{
    /// <summary>The panel draws without a complaint, and its buttons do what they say.</summary>
    public sealed class PanelTests
    {
        private Experiment _experiment;
        private MyRigidbody _mine;
        private DefaultRigidbody _theirs;

        [SetUp]
        public void Build()
        {
            _experiment = Laboratory.Build();
            Frames(5);
            _mine = _experiment.Mine.Single();
            _theirs = _experiment.Theirs.Single();
        }

        [TearDown]
        public void LetGo() => LabInput.LetGo();

        [Test]
        public void It_shows_every_body_its_integrator_and_the_time()
        {
            string[] texts = Gui.Texts.ToArray();

            Assert.That(texts, Has.Member("— My cube —").And.Member("— Default cube —").And.Member("LabEuler  ▼").And.Member("0.10 s"));
            Assert.That(texts.Count(text => text.EndsWith(" J")), Is.EqualTo(2));
            Assert.That(texts.Count(text => text.EndsWith(" ns")), Is.EqualTo(1));
        }

        [Test]
        public void Names_stand_at_the_bodies_that_the_camera_sees_and_at_no_others()
        {
            GameObject eye = new GameObject("Main Camera") { tag = "MainCamera" };
            eye.AddComponent<Camera>();
            eye.transform.position = new Vector3(0, 0, -10);
            Frames(1);
            Assert.That(Tags(), Is.EqualTo(new[] { "My cube", "Default cube" }));

            eye.transform.position = new Vector3(0, 0, 10);
            Frames(1);
            Assert.That(Tags(), Is.Empty);
        }

        [Test]
        public void Pause_and_run_stop_and_go_on()
        {
            Gui.Click("pause");
            Frames(5);
            Assert.That(_experiment.Steps, Is.EqualTo(5));
            Gui.Click("run");
            Frames(5);
            Assert.That(_experiment.Steps, Is.EqualTo(10));
        }

        [Test]
        public void One_step_is_one_step_and_pauses()
        {
            Gui.HoldDown("→");
            Frames(1);
            Gui.Click("one step");
            Frames(5);

            Assert.That(_experiment.Steps, Is.EqualTo(7));
            Assert.That(_experiment.IsPaused, Is.True);
            Assert.That(_mine.State.Position.X, Is.GreaterThan(0));
            Assert.That(_theirs.State.Position.X, Is.GreaterThan(0));
            Assert.That(_theirs.transform.position.x, Is.EqualTo((float)_theirs.State.Position.X));
        }

        [Test]
        public void Pushes_of_Update_do_not_pile_up_while_paused()
        {
            Gui.Click("pushed in Update");
            Gui.Click("pause");
            Gui.HoldDown("→");
            Frames(20);
            Gui.Click("one step");

            Assert.That(_theirs.State.Velocity.X, Is.EqualTo(5 * 0.02).Within(1e-6));
        }

        [Test]
        public void Reset_goes_back()
        {
            Gui.HoldDown("→");
            Frames(5);
            Assert.That(_mine.State.Velocity.X, Is.GreaterThan(0));
            Gui.HoldDown(null);
            Gui.Click("reset");

            Assert.That(_experiment.Steps, Is.Zero);
            Assert.That(_mine.State.Position.Length, Is.Zero);
            Assert.That(_theirs.State.Position.Length, Is.Zero);
        }

        [Test]
        public void Slow_takes_ten_times_as_long()
        {
            Gui.Click("slow");
            Frames(50);

            Assert.That(_experiment.IsSlow, Is.True);
            Assert.That(_experiment.Steps, Is.EqualTo(10).Within(1));
            Gui.Click("slow");
            Assert.That(Time.timeScale, Is.EqualTo(1));
        }

        [TestCase("←", LabKey.LeftArrow)]
        [TestCase("→", LabKey.RightArrow)]
        [TestCase("↑", LabKey.UpArrow)]
        [TestCase("↓", LabKey.DownArrow)]
        [TestCase("R", LabKey.R)]
        public void A_key_on_the_screen_is_held_as_long_as_the_mouse_is_down(string button, LabKey key)
        {
            Gui.HoldDown(button);
            Frames(1);
            Assert.That(LabInput.IsHeld(key), Is.True);
            Gui.HoldDown(null);
            Frames(1);
            Assert.That(LabInput.IsHeld(key), Is.False);
        }

        [Test]
        public void Each_integrator_of_the_catalogue_can_be_chosen()
        {
            foreach (Rule rule in Rules.All)
            {
                Gui.Click(_mine.integrator + "  ▼");
                Frames(1);
                Gui.Click(rule.Name);
                Frames(3);
                Assert.That(_mine.Body.Rule.Name, Is.EqualTo(rule.Name));
                Assert.That(_experiment.Steps, Is.EqualTo(3));
                Assert.That(Gui.Texts, Has.Member(rule.Name + "  ▼"));
            }
        }

        [Test]
        public void The_menu_of_integrators_closes_again()
        {
            Gui.Click("LabEuler  ▼");
            Frames(1);
            Assert.That(Gui.Texts, Has.Member("Exact6"));
            Gui.Click("LabEuler  ▲");
            Frames(1);
            Assert.That(Gui.Texts, Has.No.Member("Exact6"));
        }

        [Test]
        public void The_switches_of_the_engines_body_set_it_and_start_again()
        {
            Gui.Click("the lab's inertia, × 3");
            Assert.That(_experiment.Steps, Is.Zero);
            Gui.Click("drag 1, as 0.98 a step");
            Gui.Click("at most 7 rad/s");
            Gui.Click("pushed in Update");
            Frames(2);

            Rigidbody body = _theirs.GetComponent<Rigidbody>();
            Assert.That(body.inertiaTensor.x, Is.EqualTo(0.5f));
            Assert.That(EngineVersions.Drag(body), Is.EqualTo(1));
            Assert.That(EngineVersions.AngularDrag(body), Is.EqualTo(1));
            Assert.That(body.maxAngularVelocity, Is.GreaterThan(1000));
            Assert.That(_theirs.pushesInUpdate, Is.True);

            Gui.Click("the lab's inertia, × 3");
            Gui.Click("drag 1, as 0.98 a step");
            Assert.That(body.inertiaTensor.x, Is.EqualTo(1f / 6).Within(1e-7f));
            Assert.That(EngineVersions.AngularDrag(body), Is.EqualTo(0.05f));
        }

        [Test]
        public void Record_and_stop_write_a_recording_and_say_where()
        {
            Gui.Click("record");
            Frames(5);
            Gui.Click("stop");
            Frames(1);

            Assert.That(_experiment.LastRecording, Does.StartWith(Application.persistentDataPath).And.EndWith(".json"));
            Assert.That(System.IO.File.Exists(_experiment.LastRecording), Is.True);
            Assert.That(Gui.Texts, Has.Member(_experiment.LastRecording));
            Assert.That(UnityConsole.Lines.Last().Text, Does.Contain(_experiment.LastRecording));
        }

        [Test]
        public void A_body_that_cannot_move_is_said_to_be_explained_in_the_console()
        {
            UnityConsole.IgnoresErrors = true;
            _mine.mass = 0;
            Gui.Click("reset");
            Frames(2);

            Assert.That(Gui.Texts, Has.Member("see the console"));
        }

        [Test]
        public void It_speaks_one_language_at_a_time()
        {
            Assert.That(Gui.Texts.Where(text => text.Any(IsChinese)), Is.EqualTo(new[] { "中文" }));
            Gui.Click("中文");
            Frames(1);
            Assert.That(Gui.Texts, Has.Member("暂停").And.Member("角速度").And.Member("English").And.No.Member("pause").And.No.Member("spin"));
            Gui.Click("English");
            Frames(1);
            Assert.That(Gui.Texts, Has.Member("pause").And.No.Member("暂停"));
        }

        [Test]
        public void It_begins_in_the_language_of_the_system()
        {
            World.Language = SystemLanguage.ChineseSimplified;
            EditorPlays.Recompile();
            Frames(1);
            World.Language = SystemLanguage.English;
            string[] texts = Gui.Texts.ToArray();
            EditorPlays.Recompile();

            Assert.That(texts, Has.Member("重置").And.No.Member("reset"));
        }

        // a Game view at 720p, at 4K, on a laptop with the editor round it, and upright
        [TestCase(1280, 720, 1)]
        [TestCase(3840, 2160, 3)]
        [TestCase(640, 360, 1)]
        [TestCase(1080, 1920, 1)]
        public void It_is_as_large_as_its_text_needs_and_can_be_folded(int width, int height, float scale)
        {
            World.ScreenWidth = width;
            World.ScreenHeight = height;
            Frames(1);
            Assert.That(Gui.DrawnArea.width, Is.EqualTo(250 * scale));
            Assert.That(Gui.DrawnArea.x + Gui.DrawnArea.width, Is.LessThan(0.5f * width));
            Assert.That(Gui.DrawnArea.y + Gui.DrawnArea.height, Is.LessThanOrEqualTo(height));

            Gui.Click("hide");
            Frames(1);
            Assert.That(Gui.DrawnArea.height, Is.EqualTo(40 * scale));
            Assert.That(Gui.Texts, Has.No.Member("pause").And.Member("show"));
            Gui.Click("show");
            Frames(1);
            Assert.That(Gui.Texts, Has.Member("pause"));
        }

        private static bool IsChinese(char c) => c >= '\u4e00' && c <= '\u9fff';

        private static string[] Tags() => Gui.Drawn.Where(control => control.Kind == "tag").Select(control => control.Text).ToArray();

        private static void Frames(int count)
        {
            for (int i = 0; i < count; i++)
                Player.Frame(0.02f);
        }
    }
}
