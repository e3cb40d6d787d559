using System;
using System.Reflection;

namespace UnityEditor
{
    /// <summary>A window of the editor.</summary>
    public class EditorWindow : UnityEngine.ScriptableObject
    {
        /// <summary>Opens a window, as Unity does: its OnEnable runs.</summary>
        public static T GetWindow<T>(string title) where T : EditorWindow, new()
        {
            T window = new T { name = title };
            typeof(T).GetMethod("OnEnable", BindingFlags.Instance | BindingFlags.NonPublic)?.Invoke(window, null);
            return window;
        }

        public void Repaint() { }
    }

    /// <summary>Puts a static method into a menu.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    public sealed class MenuItem : Attribute
    {
        public MenuItem(string itemName) => Path = itemName;

        internal string Path { get; }
    }

    /// <summary>What the editor does for windows.</summary>
    public class EditorUtility
    {
        /// <summary>The file that was shown last.</summary>
        internal static string Shown { get; private set; }

        public static void RevealInFinder(string path) => Shown = path;
    }
}
