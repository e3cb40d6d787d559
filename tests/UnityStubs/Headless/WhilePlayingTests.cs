using System.Linq;
using NUnit.Framework;
using RigidBodyDynamics.Engine;
using UnityEngine;

namespace RigidBodyDynamics.Scripts.Tests.Headless
{
    /// <summary>Changes by students while the game plays, and what a Unity user expects then.</summary>
    public sealed class WhilePlayingTests
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
        public void LetGo() => LabInput.Keyboard = null;

        [Test]
        public void A_script_is_saved_and_everything_goes_on()
        {
            Hold(LabKey.RightArrow, LabKey.R);
            Frames(20);
            double[] before = Laboratory.Numbers(_mine.State), theirs = Laboratory.Numbers(_theirs.State);

            EditorPlays.Recompile();

            Assert.That(Laboratory.Numbers(_mine.State), Is.EqualTo(before));
            Assert.That(Laboratory.Numbers(_theirs.State), Is.EqualTo(theirs));
            Hold(LabKey.R);
            double spin = _mine.State.AngularVelocity.X;
            Frames(1);
            // t of the torque is that of the 26th step, on 1/2 kg m², then 0.98
            Assert.That(_mine.State.AngularVelocity.X, Is.EqualTo(0.98 * (spin + System.Math.Sin(25 * 0.02) * 0.02 / 0.5)).Within(1e-14)); // measured 0
            Assert.That(_experiment.Steps, Is.EqualTo(26));
            Assert.That(_experiment.Seconds, Is.EqualTo(0.52).Within(1e-12));
            Assert.That(Gui.Texts, Has.Member("— My cube —").And.Member("— Default cube —").And.Member("0.52 s"));

            Hold();
            Gui.Click("reset");
            Assert.That(_mine.State.Position.Length + _theirs.State.Position.Length, Is.Zero);
            Assert.That(_experiment.Steps, Is.Zero);
        }

        [Test]
        public void A_script_is_saved_while_paused_and_it_stays_paused()
        {
            _experiment.IsPaused = true;
            EditorPlays.Recompile();
            Frames(5);

            Assert.That(_experiment.Steps, Is.EqualTo(5));
            Gui.Click("run");
            Frames(5);
            Assert.That(_experiment.Steps, Is.EqualTo(10));
        }

#if !ENABLE_LEGACY_INPUT_MANAGER
        [Test]
        public void A_script_is_saved_and_the_keyboard_is_heard()
        {
            EditorPlays.Recompile();
            Keys.Hold(KeyCode.R, true);

            Assert.That(LabInput.IsHeld(LabKey.R), Is.True);
        }
#endif

        [Test]
        public void A_speed_of_time_that_a_script_has_set_holds()
        {
            Time.timeScale = 0.5f;
            Frames(10);
            Assert.That(Time.timeScale, Is.EqualTo(0.5f));
            Assert.That(_experiment.Steps, Is.EqualTo(10));

            Gui.Click("slow");
            Assert.That(Time.timeScale, Is.EqualTo(0.05f));
            Gui.Click("pause");
            Assert.That(Time.timeScale, Is.Zero);
            Gui.Click("run");
            Gui.Click("slow");
            Assert.That(Time.timeScale, Is.EqualTo(0.5f));
        }

        [Test]
        public void A_script_that_stops_time_stops_everything()
        {
            Time.timeScale = 0;
            double[] before = Laboratory.Numbers(_mine.State);
            Hold(LabKey.RightArrow);
            for (int frame = 0; frame < 500; frame++)
                Player.Frame(0.02);

            Assert.That(Laboratory.Numbers(_mine.State), Is.EqualTo(before));
            Assert.That(_theirs.State.Position.Length, Is.Zero);
        }

        [Test]
        public void An_object_is_dragged_and_the_body_goes_on_from_there()
        {
            Hold(LabKey.RightArrow);
            Frames(10);
            Hold();
            Vector3d velocity = _mine.State.Velocity;
            _mine.transform.position = new Vector3(0, 3, 0);
            _mine.transform.rotation = Quaternion.Euler(0, 90, 0);
            Frames(1);

            Assert.That(_mine.State.Position.Y, Is.EqualTo(3));
            Assert.That(_mine.State.Position.X, Is.EqualTo(velocity.X * 0.02).Within(1e-12));
            Assert.That(_mine.State.Orientation.Y, Is.EqualTo(System.Math.Sqrt(0.5)).Within(1e-7));
            Assert.That(_mine.State.Velocity.X, Is.EqualTo(0.98 * velocity.X).Within(1e-15));
        }

        [Test]
        public void A_body_switched_off_stands_and_goes_on_when_switched_on()
        {
            Hold(LabKey.RightArrow);
            Frames(10);
            double[] before = Laboratory.Numbers(_mine.State);
            _mine.enabled = false;
            Frames(10);
            Assert.That(Laboratory.Numbers(_mine.State), Is.EqualTo(before));
            Assert.That(Gui.Texts, Has.Member("— My cube —"));

            _mine.enabled = true;
            Hold();
            Frames(1);
            Assert.That(_mine.State.Velocity.X, Is.EqualTo(0.98 * before[7]).Within(1e-15));
        }

        [Test]
        public void An_object_that_is_duplicated_is_a_body_of_its_own_that_starts_where_it_stands()
        {
            Hold(LabKey.RightArrow);
            Frames(10);
            Hold();
            MyRigidbody copy = EditorPlays.Duplicate(_mine.gameObject).GetComponent<MyRigidbody>();
            EditorPlays.Duplicate(_theirs.gameObject);
            Frames(2);

            Assert.That(_experiment.Mine.Select(body => body.name), Is.EqualTo(new[] { "My cube", "My cube (1)" }));
            Assert.That(_experiment.Theirs.Select(body => body.name), Is.EqualTo(new[] { "Default cube", "Default cube (1)" }));
            Assert.That(Gui.Texts, Has.Member("— My cube (1) —").And.Member("— Default cube (1) —"));
            Assert.That(copy.State.Velocity.Length, Is.Zero);
            Assert.That(copy.State.Position.X, Is.GreaterThan(0));
            Gui.Click("reset");
            Assert.That(copy.State.Position.X, Is.GreaterThan(0));
            Assert.That(_mine.State.Position.X, Is.Zero);
        }

        [Test]
        public void A_body_that_is_destroyed_is_shown_no_more()
        {
            Object.Destroy(_mine.gameObject);
            Object.Destroy(_theirs);
            Frames(3);

            Assert.That(_experiment.Mine.Count + _experiment.Theirs.Count, Is.Zero);
            Assert.That(Gui.Texts, Has.No.Member("— My cube —").And.No.Member("— Default cube —"));
            Gui.Click("reset");
            Gui.Click("one step");
        }

        // as with two scenes, each with an experiment of its own
        [Test]
        public void Two_experiments_pause_each_by_itself_and_time_runs_when_none_is_paused()
        {
            Experiment other = new GameObject("Other").AddComponent<Experiment>();
            Frames(1);
            _experiment.IsPaused = true;
            Object.Destroy(other.gameObject);
            Frames(2);
            Assert.That(Time.timeScale, Is.Zero);

            _experiment.IsPaused = false;
            Assert.That(Time.timeScale, Is.EqualTo(1));
        }

        [TestCase(RigidbodyConstraints.FreezeRotation)]
        [TestCase(RigidbodyConstraints.FreezeRotationX)]
        [TestCase(RigidbodyConstraints.FreezePosition)]
        [TestCase(RigidbodyConstraints.FreezeAll)]
        public void A_frozen_Rigidbody_is_shown_and_recorded(RigidbodyConstraints frozen)
        {
            _theirs.GetComponent<Rigidbody>().constraints = frozen;
            Gui.Click("record");
            Hold(LabKey.UpArrow, LabKey.R);
            Frames(10);
            Gui.Click("stop");

            Assert.That(Gui.Texts, Has.Member("— Default cube —"));
            Assert.That(_theirs.Mass.Mass, Is.EqualTo(1));
            Assert.That(System.IO.File.ReadAllText(_experiment.LastRecording), Does.Contain("\"lock\": {\"move\":"));
            bool moves = (frozen & RigidbodyConstraints.FreezePositionY) == 0, turns = (frozen & RigidbodyConstraints.FreezeRotationX) == 0;
            Assert.That(_theirs.State.Position.Y > 0, Is.EqualTo(moves));
            // Unity freezes the body's own axes
            Assert.That(_theirs.State.Orientation.Conjugate.Rotate(_theirs.State.AngularVelocity).X > 1e-6, Is.EqualTo(turns));
        }

        [TestCase(LabKey.UpArrow)]
        [TestCase(LabKey.LeftArrow)]
        [TestCase(LabKey.RightArrow)]
        [TestCase(LabKey.DownArrow)]
        public void Bodies_of_the_lab_go_through_each_other(LabKey key)
        {
            foreach (DefaultRigidbody body in Laboratory.Load("Lab").Theirs)
            {
                body.drag = body.name == "Default cube" ? 1 : 0;
                body.StartAgain();
            }

            Hold(key, LabKey.R);
            Frames(250);

            Assert.That(Touching.Pairs, Is.Empty);
        }

        [Test]
        public void Bodies_that_would_touch_are_found_out()
        {
            Touching.IsExpected = true;
            GameObject floor = GameObject.CreatePrimitive(PrimitiveType.Cube);
            floor.name = "Floor";
            floor.transform.position = new Vector3(0, -2, 0);
            Hold(LabKey.DownArrow);
            Frames(20);
            Assert.That(Touching.Pairs, Is.Empty);
            Frames(80);

            Assert.That(Touching.Pairs, Is.EqualTo(new[] { "Default cube and Floor" }));
        }

        // on the keyboard: a button of the panel is held as long as the mouse is down
        private static void Hold(params LabKey[] keys) => LabInput.Keyboard = key => keys.Contains(key);

        private static void Frames(int count)
        {
            for (int i = 0; i < count; i++)
                Player.Frame(0.02);
        }
    }
}
