using System;
using NUnit.Framework;
using RigidBodyDynamics.Engine;
using UnityEngine;
using UnityEngine.TestTools;

namespace RigidBodyDynamics.Scripts.Tests.Headless
{
    /// <summary>The stand-in's GUI is as strict as Unity's.</summary>
    public sealed class GuiTests
    {
        [Test]
        public void A_control_that_was_not_laid_out_is_an_error()
        {
            LogAssert.Expect(LogType.Exception, new System.Text.RegularExpressions.Regex("Getting control 1's position in a group with only 1 controls when doing Repaint"));
            Draw(() =>
            {
                GUILayout.Label("one");
                if (Event.current.type == EventType.Repaint)
                    GUILayout.Label("two");
            });
        }

        [Test]
        public void A_row_that_is_not_ended_is_an_error()
        {
            UnityConsole.IgnoresErrors = true;
            Draw(() => GUILayout.BeginHorizontal());

            Assert.That(UnityConsole.Lines.Count, Is.EqualTo(2));
        }

        [Test]
        public void After_a_click_the_layout_may_change()
        {
            bool isOpen = false;
            Draw(() =>
            {
                if (GUILayout.Button("menu"))
                    isOpen = !isOpen;

                if (isOpen)
                    GUILayout.Label("entry");
            });
            Gui.Click("menu");
            Player.Frame(0.02);

            Assert.That(Gui.Texts, Is.EqualTo(new[] { "menu", "entry" }));
        }

        [Test]
        public void What_is_not_there_cannot_be_clicked()
        {
            Draw(() => GUILayout.Label("label"));

            Assert.That(() => Gui.Click("label"), Throws.InvalidOperationException);
        }

        [Test]
        public void Outside_of_OnGUI_nothing_can_be_drawn() =>
            Assert.That(() => GUILayout.Label("label"), Throws.ArgumentException);

        private static void Draw(Action draw)
        {
            new GameObject("gui").AddComponent<Drawing>().Draw = draw;
            Player.Frame(0.02);
        }

        private sealed class Drawing : MonoBehaviour
        {
            public Action Draw { get; set; }

            private void OnGUI() => Draw();
        }
    }
}
