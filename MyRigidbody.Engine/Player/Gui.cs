using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace RigidBodyDynamics.Engine
{
    /// <summary>The immediate-mode GUI: sends its events to every OnGUI, records what is drawn, and clicks for a test.</summary>
    public static partial class Gui
    {
        private const string Row = "row";
        private static readonly Dictionary<object, Layout> Layouts = new Dictionary<object, Layout>();
        private static List<(string Kind, string Text)> _drawn = new List<(string, string)>();
        private static List<List<(string Kind, string Text)>> _rows = new List<List<(string, string)>>();
        private static bool _isInRow;
        private static Layout _layout;
        private static string _click, _held;
        private static int _choice;

        /// <summary>The controls of the last frame: button, toggle, label … and its text.</summary>
        public static IReadOnlyList<(string Kind, string Text)> Drawn => _drawn;

        /// <summary>The texts of the last frame.</summary>
        public static IEnumerable<string> Texts => _drawn.Select(control => control.Text);

        /// <summary>The same by rows, from top to bottom.</summary>
        public static IEnumerable<IReadOnlyList<(string Kind, string Text)>> Rows => _rows;

        /// <summary>The rectangle of the last area, in pixels of the window.</summary>
        public static Rect DrawnArea { get; private set; }

        internal static Rect Area
        {
            set => DrawnArea = new Rect(GUI.matrix.m00 * value.x, GUI.matrix.m11 * value.y, GUI.matrix.m00 * value.width, GUI.matrix.m11 * value.height);
        }

        internal static bool HasChanged { get; set; }

        /// <summary>Clicks the button or toggle with a text, at once.</summary>
        public static void Click(string text) => ClickOrChoose(text, 0);

        /// <summary>Chooses an entry of the menu with a label.</summary>
        public static void Choose(string label, int entry) => ClickOrChoose(label, entry);

        /// <summary>Holds the mouse on the button with a text; null releases it.</summary>
        public static void HoldDown(string text) => _held = text;

        internal static void Reset()
        {
            Layouts.Clear();
            _drawn = new List<(string, string)>();
            _click = _held = null;
            Event.current = null;
        }

        /// <summary>The events of a frame: keys, then the drawing.</summary>
        internal static void Frame()
        {
            foreach ((KeyCode key, bool isDown) in Keys.TakeChanges())
                SendToAll(() => new Event { type = isDown ? EventType.KeyDown : EventType.KeyUp, keyCode = key });

            _drawn = new List<(string, string)>();
            _rows = new List<List<(string, string)>>();
            SendToAll(() => new Event { type = EventType.Repaint });
        }

        /// <summary>A control that cannot be clicked.</summary>
        internal static void Control(string kind, string text)
        {
            MustBeInside().Control();
            if (Event.current.type != EventType.Repaint)
                return;

            _drawn.Add((kind, text));
            if (!_isInRow)
                _rows.Add(new List<(string, string)>());

            _rows[_rows.Count - 1].Add((kind, text));
        }

        /// <summary>A control that can be clicked; true in the event that clicks it.</summary>
        internal static bool Clickable(string kind, string text)
        {
            Control(kind, text);
            if (Event.current.type != EventType.MouseUp || text != _click)
                return false;

            _click = null;
            HasChanged = true;
            Event.current.Use();
            return true;
        }

        /// <summary>A menu: the chosen entry, or the present one.</summary>
        internal static int Menu(string text, int selected) => Clickable("menu", text) ? _choice : selected;

        /// <summary>A repeat button, which says while it is painted whether it is held.</summary>
        internal static bool Holdable(string text)
        {
            Control("repeat button", text);
            return Event.current.type == EventType.Repaint && text == _held;
        }

        internal static void Open(string kind)
        {
            MustBeInside().Open(kind);
            if (kind != Row || Event.current.type != EventType.Repaint)
                return;

            _isInRow = true;
            _rows.Add(new List<(string, string)>());
        }

        internal static void Close(string kind)
        {
            MustBeInside().Close(kind);
            _isInRow &= kind != Row;
        }

        private static Layout MustBeInside() =>
            Event.current != null ? _layout : throw new ArgumentException("You can only call GUI functions from inside OnGUI.");

        private static void ClickOrChoose(string text, int choice)
        {
            Aim(text, choice);
            SendToAll(() => new Event { type = EventType.MouseUp });
            MustHaveHit();
        }

        private static void Aim(string text, int choice)
        {
            _click = text;
            _choice = choice;
        }

        private static void MustHaveHit()
        {
            string missed = _click;
            _click = null;
            if (missed != null)
                throw new InvalidOperationException("nothing to click says: " + missed);
        }

        private static void SendToAll(Func<Event> make)
        {
            foreach (MonoBehaviour script in World.Scripts.ToArray())
            {
                if (script && script.isActiveAndEnabled && Messages.Has(script, "OnGUI"))
                    Send(make(), script, () => Messages.Send(script, "OnGUI"));
            }
        }

        // Unity sends a Layout event before every other event
        private static void Send(Event then, object owner, Action draw)
        {
            if (!Layouts.TryGetValue(owner, out _layout))
                Layouts.Add(owner, _layout = new Layout());

            foreach (Event next in new[] { new Event { type = EventType.Layout, keyCode = then.keyCode }, then })
            {
                Event.current = next;
                GUI.color = Color.white;
                GUI.enabled = true;
                GUI.matrix = Matrix4x4.identity;
                _isInRow = false;
                _layout.Begin();
                draw();
                _layout.End();
            }

            Event.current = null;
        }
    }
}
