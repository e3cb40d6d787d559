using NUnit.Framework;
using RigidBodyDynamics.Engine;
using UnityEngine;

namespace RigidBodyDynamics.Tests.StandIn;

/// <summary>
/// Controls of the stand-in's GUI answer in the events in which Unity's do: laid out first, clicked in the event of the mouse, painted last.
/// The world is one: nothing else runs meanwhile.
/// </summary>
[NonParallelizable]
public sealed class GuiTests
{
    private Controls _controls = null!;

    [SetUp]
    public void Begin()
    {
        World.Begin(isPlaying: true);
        _controls = new GameObject("controls").AddComponent<Controls>();
    }

    [TearDown]
    public void End() => World.End();

    [Test]
    public void All_controls_of_a_frame_are_painted_in_their_order()
    {
        Player.Frame(Second);
        Assert.That(Gui.Drawn, Is.EqualTo(new[] { ("label", "a text"), ("button", "press"), ("toggle", "switch"), ("repeat button", "hold"), ("space", ""), ("tag", "there") }));
    }

    [Test]
    public void A_button_is_true_in_the_event_that_clicks_it_and_in_no_other()
    {
        Player.Frame(Second);
        Assert.That(_controls.Pressed, Is.Zero);
        Gui.Click("press");
        Player.Frame(Second);
        Assert.That(_controls.Pressed, Is.EqualTo(1));
    }

    [Test]
    public void A_toggle_changes_with_every_click()
    {
        Gui.Click("switch");
        Assert.That(_controls.IsOn, Is.True);
        Gui.Click("switch");
        Assert.That(_controls.IsOn, Is.False);
    }

    [Test]
    public void A_repeat_button_is_true_while_it_is_held()
    {
        Gui.HoldDown("hold");
        Player.Frame(Second);
        Player.Frame(Second);
        Gui.HoldDown(null);
        Player.Frame(Second);
        Assert.That(_controls.Held, Is.EqualTo(2));
    }

    [Test]
    public void A_control_that_was_not_laid_out_is_an_error()
    {
        _controls.IsUneven = true;
        Player.Frame(Second);
        Assert.That(UnityConsole.Lines.Select(line => line.Text), Has.Some.Contains("position in a group with only"));
    }

    [Test]
    public void A_row_that_is_not_ended_is_an_error()
    {
        _controls.IsOpen = true;
        Player.Frame(Second);
        Assert.That(UnityConsole.Lines.Select(line => line.Text), Has.Some.Contains("was begun and not ended"));
    }

    [Test]
    public void Nothing_is_drawn_outside_OnGUI() => Assert.That(() => GUILayout.Label("x"), Throws.ArgumentException);

    private const double Second = 1;

    private sealed class Controls : MonoBehaviour
    {
        public int Pressed { get; private set; }

        public int Held { get; private set; }

        public bool IsOn { get; private set; }

        public bool IsUneven { get; set; }

        public bool IsOpen { get; set; }

        public void OnGUI()
        {
            GUILayout.BeginHorizontal();
            GUILayout.Label("a text");
            Pressed += GUILayout.Button("press") ? 1 : 0;
            IsOn = GUILayout.Toggle(IsOn, "switch");
            Held += GUILayout.RepeatButton("hold") ? 1 : 0;
            GUILayout.Space(4);
            if (!IsOpen)
                GUILayout.EndHorizontal();
            if (IsUneven && Event.current.type == EventType.Repaint)
                GUILayout.Label("not laid out");
            GUI.Label(new Rect(0, 0, 100, 20), "there");
        }
    }
}
