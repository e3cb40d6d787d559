using System.Collections.Generic;
using UnityEngine;

namespace RigidBodyDynamics.Engine
{
    // inspectors are drawn as OnGUI is
    public static partial class Gui
    {
        private static readonly Dictionary<string, string> Typed = new Dictionary<string, string>();

        public static void Draw(UnityEditor.EditorWindow window, System.Action onGui)
        {
            _drawn = new List<(string, string)>();
            Send(new Event { type = EventType.Repaint }, window, onGui);
        }

        /// <summary>Clicks in a window of the editor; work delayed until after the event is done then.</summary>
        public static void Click(UnityEditor.EditorWindow window, System.Action onGui, string text)
        {
            Aim(text, 0);
            Send(new Event { type = EventType.MouseUp }, window, onGui);
            MustHaveHit();
            UnityEditor.EditorApplication.CallbackFunction after = UnityEditor.EditorApplication.delayCall;
            UnityEditor.EditorApplication.delayCall = null;
            after?.Invoke();
        }

        /// <summary>Types a text into the field with a label.</summary>
        public static void Type(string label, string text) => Typed[label] = text;

        internal static string Text(string label, string text)
        {
            Control("text", label);
            if (!Typed.TryGetValue(label, out string typed))
                return text;

            Typed.Remove(label);
            return typed;
        }

        public static void Draw(UnityEditor.Editor inspector)
        {
            _drawn = new List<(string, string)>();
            Send(new Event { type = EventType.Repaint }, inspector, inspector.OnInspectorGUI);
        }

        /// <summary>Clicks, or chooses from a menu, in an inspector.</summary>
        public static void Choose(UnityEditor.Editor inspector, string label, int entry)
        {
            Aim(label, entry);
            Send(new Event { type = EventType.MouseUp }, inspector, inspector.OnInspectorGUI);
            MustHaveHit();
        }
    }
}
