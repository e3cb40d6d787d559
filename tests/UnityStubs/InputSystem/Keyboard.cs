using RigidBodyDynamics.Engine;
using UnityEngine.InputSystem.Controls;

namespace UnityEngine.InputSystem
{
    /// <summary>The keyboard as the Input System has it: current is null where there is none.</summary>
    public class Keyboard
    {
        public static Keyboard current { get; internal set; } = new Keyboard();

        public KeyControl leftArrowKey { get; } = new KeyControl(KeyCode.LeftArrow);

        public KeyControl rightArrowKey { get; } = new KeyControl(KeyCode.RightArrow);

        public KeyControl upArrowKey { get; } = new KeyControl(KeyCode.UpArrow);

        public KeyControl downArrowKey { get; } = new KeyControl(KeyCode.DownArrow);

        public KeyControl rKey { get; } = new KeyControl(KeyCode.R);
    }
}

namespace UnityEngine.InputSystem.Controls
{
    /// <summary>A key.</summary>
    public class KeyControl
    {
        private readonly KeyCode _key;

        internal KeyControl(KeyCode key) => _key = key;

        public bool isPressed => Keys.IsDown(_key);
    }
}
