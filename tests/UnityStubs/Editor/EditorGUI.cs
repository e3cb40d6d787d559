using System.Collections.Generic;
using RigidBodyDynamics.Engine;
using UnityEngine;

namespace UnityEditor
{
    /// <summary>Controls of inspectors.</summary>
    public sealed class EditorGUILayout
    {
        public static bool PropertyField(SerializedProperty property, bool includeChildren, params GUILayoutOption[] options)
        {
            Gui.Control(GUI.enabled ? "property" : "disabled property", property.displayName);
            return false;
        }

        public static void HelpBox(string message, MessageType type) => Gui.Control("help " + type, message);

        public static Object ObjectField(string label, Object obj, System.Type objType, bool allowSceneObjects, params GUILayoutOption[] options)
        {
            Gui.Control("object", label);
            return obj;
        }

        public static string TextField(string label, string text, params GUILayoutOption[] options) => Gui.Text(label, text);

        public static int Popup(GUIContent label, int selectedIndex, string[] displayedOptions, params GUILayoutOption[] options) =>
            Gui.Menu(label.text, selectedIndex);
    }

    /// <summary>Whether something has been changed.</summary>
    public sealed class EditorGUI
    {
        private static readonly Stack<bool> Outer = new Stack<bool>();

        public static void BeginChangeCheck()
        {
            Outer.Push(Gui.HasChanged);
            Gui.HasChanged = false;
        }

        public static bool EndChangeCheck()
        {
            bool hasChanged = Gui.HasChanged;
            Gui.HasChanged |= Outer.Pop();
            return hasChanged;
        }

        /// <summary>What is drawn in it cannot be changed where it is disabled.</summary>
        public class DisabledScope : GUI.Scope
        {
            private readonly bool _before = GUI.enabled;

            public DisabledScope(bool disabled) => GUI.enabled &= !disabled;

            protected override void CloseScope() => GUI.enabled = _before;
        }
    }

    /// <summary>The severity of a message.</summary>
    public enum MessageType
    {
        None,
        Info,
        Warning,
        Error,
    }
}
