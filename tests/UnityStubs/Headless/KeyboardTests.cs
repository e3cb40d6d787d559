using NUnit.Framework;
using RigidBodyDynamics.Engine;
using UnityEngine;

namespace RigidBodyDynamics.Scripts.Tests.Headless
{
    /// <summary>A real keyboard: by the old input where there is one, else by the events of the GUI.</summary>
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
