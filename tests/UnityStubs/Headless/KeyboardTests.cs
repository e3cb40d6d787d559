using NUnit.Framework;
using RigidBodyDynamics.Engine;
using UnityEngine;

namespace RigidBodyDynamics.Scripts.Tests.Headless
{
    /// <summary>A real keyboard: by the old input where there is one, else by the Input System, else by the events of the GUI.</summary>
    public sealed class KeyboardTests
    {
        [TearDown]
        public void LetGo() => LabInput.LetGo();

        [TestCase(KeyCode.LeftArrow, LabKey.LeftArrow)]
        [TestCase(KeyCode.RightArrow, LabKey.RightArrow)]
        [TestCase(KeyCode.UpArrow, LabKey.UpArrow)]
        [TestCase(KeyCode.DownArrow, LabKey.DownArrow)]
        [TestCase(KeyCode.R, LabKey.R)]
        public void A_key_is_heard_in_every_version(KeyCode code, LabKey key)
        {
            Keys.Hold(code, true);
            Player.Frame(0.02);
            Assert.That(LabInput.IsHeld(key), Is.True);
            Player.Frame(0.02);
            Assert.That(LabInput.IsHeld(key), Is.True);

            Keys.Hold(code, false);
            Player.Frame(0.02);
            Assert.That(LabInput.IsHeld(key), Is.False);
        }

#if !ENABLE_LEGACY_INPUT_MANAGER
        [Test]
        public void Without_the_Input_System_a_key_is_heard_by_the_events_of_the_GUI_and_not_twice()
        {
            Keys.Hold(KeyCode.UpArrow, true);
            Player.Frame(0.02);
            LabInput.Keyboard = null;
            Assert.That(LabInput.IsHeld(LabKey.UpArrow), Is.False, "whoever can ask the keyboard does not listen");

            Keys.Hold(KeyCode.R, true);
            Player.Frame(0.02);
            Assert.That(LabInput.IsHeld(LabKey.R), Is.True);
            Keys.Hold(KeyCode.R, false);
            Player.Frame(0.02);
            Assert.That(LabInput.IsHeld(LabKey.R), Is.False);
        }

        [Test]
        public void A_machine_without_a_keyboard_holds_nothing()
        {
            Keys.Hold(KeyCode.R, true);
            UnityEngine.InputSystem.Keyboard present = UnityEngine.InputSystem.Keyboard.current;
            UnityEngine.InputSystem.Keyboard.current = null;
            bool isHeld = LabInput.IsHeld(LabKey.R);
            UnityEngine.InputSystem.Keyboard.current = present;

            Assert.That(isHeld, Is.False);
            Assert.That(LabInput.IsHeld(LabKey.R), Is.True);
        }

        [Test]
        public void A_key_that_went_down_before_a_pause_of_the_editor_is_let_go()
        {
            System.Runtime.CompilerServices.RuntimeHelpers.RunClassConstructor(typeof(Editing.PausedEditor).TypeHandle);
            LabInput.Keyboard = null;
            Keys.Hold(KeyCode.R, true);
            Player.Frame(0.02);
            UnityEditor.EditorApplication.Pause(true);

            Assert.That(LabInput.IsHeld(LabKey.R), Is.False);
        }
#endif

        // in a project whose domain is not reloaded what is static outlives Stop
        [Test]
        public void The_next_play_begins_with_no_key_held()
        {
            LabInput.HoldOnScreen(LabKey.R, true);
            LabInput.Keyboard = key => true;
            World.Begin(isPlaying: true);

            Assert.That(LabInput.IsHeld(LabKey.R), Is.False);
            Assert.That(LabInput.IsHeld(LabKey.UpArrow), Is.False);
        }

        [Test]
        public void A_game_that_the_system_pauses_holds_no_key_afterwards()
        {
            Laboratory.Build();
            LabInput.HoldOnScreen(LabKey.R, true);
            Player.Pause(isPaused: true);
            Player.Pause(isPaused: false);

            Assert.That(LabInput.IsHeld(LabKey.R), Is.False);
        }

        [Test]
        public void Another_key_is_nobodys()
        {
            Keys.Hold(KeyCode.A, true);
            Player.Frame(0.02);

            for (LabKey key = LabKey.LeftArrow; key <= LabKey.R; key++)
                Assert.That(LabInput.IsHeld(key), Is.False);
        }

        [Test]
        public void A_window_without_the_keyboard_holds_no_key_that_it_would_not_hear_go_up()
        {
            Laboratory.Build();
            LabInput.HoldOnScreen(LabKey.R, true);
#if !ENABLE_LEGACY_INPUT_MANAGER
            LabInput.Keyboard = null;
            Keys.Hold(KeyCode.UpArrow, true);
            Player.Frame(0.02);
            Assert.That(LabInput.IsHeld(LabKey.UpArrow), Is.True);
#endif
            Player.Focus(hasFocus: false);

            Assert.That(LabInput.IsHeld(LabKey.R), Is.False);
            Assert.That(LabInput.IsHeld(LabKey.UpArrow), Is.False);
        }
    }
}
