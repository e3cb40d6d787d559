using System;
using RigidBodyDynamics.Engine;

namespace UnityEngine
{
    /// <summary>The old input, which throws in a project that has only the Input System. There is no mouse and no joystick.</summary>
    public static class Input
    {
        public static bool anyKey => Asked(Keys.IsAnyDown);

        public static bool anyKeyDown => Asked(Keys.HasAnyBegun);

        public static string inputString => string.Empty;

        public static Vector3 mousePosition => Vector3.zero;

        public static bool GetKey(KeyCode key) => Asked(Keys.IsDown(key));

        public static bool GetKey(string name) => GetKey(KeyNames.Find(name));

        public static bool GetKeyDown(KeyCode key) => Asked(Keys.HasBegun(key));

        public static bool GetKeyDown(string name) => GetKeyDown(KeyNames.Find(name));

        public static bool GetKeyUp(KeyCode key) => Asked(Keys.HasEnded(key));

        public static bool GetKeyUp(string name) => GetKeyUp(KeyNames.Find(name));

        /// <summary>The arrow keys, and A, D, S, W, by Unity's default settings; not smoothed.</summary>
        public static float GetAxisRaw(string axisName)
        {
            switch (axisName)
            {
                case "Horizontal": return Axis(KeyCode.LeftArrow, KeyCode.A, KeyCode.RightArrow, KeyCode.D);
                case "Vertical": return Axis(KeyCode.DownArrow, KeyCode.S, KeyCode.UpArrow, KeyCode.W);
                case "Mouse X":
                case "Mouse Y":
                case "Mouse ScrollWheel": return 0;
                default: throw new ArgumentException("Input Axis " + axisName + " is not setup.");
            }
        }

        public static float GetAxis(string axisName) => GetAxisRaw(axisName);

        public static bool GetMouseButton(int button) => false;

        public static bool GetMouseButtonDown(int button) => false;

        public static bool GetMouseButtonUp(int button) => false;

        private static float Axis(KeyCode less, KeyCode alsoLess, KeyCode more, KeyCode alsoMore) =>
            (GetKey(more) || GetKey(alsoMore) ? 1 : 0) - (GetKey(less) || GetKey(alsoLess) ? 1 : 0);

        private static bool Asked(bool answer)
        {
#if ENABLE_LEGACY_INPUT_MANAGER
            return answer;
#else
            throw new InvalidOperationException("You are trying to read Input using the UnityEngine.Input class, but you have switched active Input handling to Input System package in Player Settings.");
#endif
        }
    }
}
