using RigidBodyDynamics.Engine;

namespace UnityEngine
{
    /// <summary>Controls that are laid out automatically.</summary>
    public class GUILayout
    {
        public static void Label(string text, params GUILayoutOption[] options) => Gui.Control("label", text);

        public static bool Button(string text, params GUILayoutOption[] options) => Gui.Clickable("button", text);

        public static bool Button(GUIContent content, params GUILayoutOption[] options) => Gui.Clickable("button", content.text);

        public static bool RepeatButton(string text, params GUILayoutOption[] options) => Gui.Holdable(text);

        public static bool Toggle(bool value, string text, params GUILayoutOption[] options) => Gui.Clickable("toggle", text) ? !value : value;

        public static void Space(float pixels) => Gui.Control("space", string.Empty);

        public static void BeginHorizontal(params GUILayoutOption[] options) => Gui.Open("row");

        public static void EndHorizontal() => Gui.Close("row");

        public static void BeginArea(Rect screenRect, GUIStyle style)
        {
            Gui.Area = screenRect;
            Gui.Open("area");
        }

        public static void EndArea() => Gui.Close("area");

        public static Vector2 BeginScrollView(Vector2 scrollPosition, params GUILayoutOption[] options)
        {
            Gui.Open("scroll view");
            return scrollPosition;
        }

        public static void EndScrollView() => Gui.Close("scroll view");

        public static GUILayoutOption Width(float width) => new GUILayoutOption();
    }

    /// <summary>The size of a control.</summary>
    public sealed class GUILayoutOption
    {
        internal GUILayoutOption() { }
    }

    /// <summary>The text of a control.</summary>
    public class GUIContent
    {
        public GUIContent(string text, string tooltip)
        {
            this.text = text;
            this.tooltip = tooltip;
        }

        public string text { get; set; }

        public string tooltip { get; set; }
    }

    /// <summary>The style of a control.</summary>
    public sealed class GUIStyle { }

    /// <summary>The styles of all controls.</summary>
    public sealed class GUISkin
    {
        public GUIStyle box { get; } = new GUIStyle();
    }

    /// <summary>Settings for all controls drawn after it.</summary>
    public class GUI
    {
        public static Color color { get; set; }

        public static Matrix4x4 matrix { get; set; }

        public static GUISkin skin { get; } = new GUISkin();

        public static bool enabled { get; set; } = true;

        public static void Label(Rect position, string text) => Gui.Control("tag", text);

        /// <summary>A setting until the end of a using block.</summary>
        public abstract class Scope : System.IDisposable
        {
            public void Dispose() => CloseScope();

            protected abstract void CloseScope();
        }
    }
}
