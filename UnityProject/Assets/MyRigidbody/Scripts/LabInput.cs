using System;
using UnityEngine;

namespace RigidBodyDynamics.Scripts
{
    /// <summary>
    /// The lab's keys that are held: on the keyboard, by Unity's Input where the project has it, else by the Input System if present,
    /// else by the events of the immediate-mode GUI; or on the buttons of the panel.
    /// </summary>
    public static class LabInput
    {
#if ENABLE_LEGACY_INPUT_MANAGER || !UNITY_2019_3_OR_NEWER
        private static readonly KeyCode[] Codes =
            { KeyCode.LeftArrow, KeyCode.RightArrow, KeyCode.UpArrow, KeyCode.DownArrow, KeyCode.R };
#endif
        private static readonly bool[] InEvents = new bool[5];
        private static readonly bool[] OnScreen = new bool[5];

        /// <summary>
        /// Reads the keyboard where there is no Input; null where nothing can. The assembly MyRigidbody.InputSystem, which exists where the
        /// Input System does, sets it before the first scene is loaded.
        /// </summary>
        public static Func<LabKey, bool> Keyboard { get; set; }

        /// <summary>True while a key is held on the keyboard or on the screen.</summary>
        public static bool IsHeld(LabKey key) => OnScreen[(int)key] || InEvents[(int)key] || IsDown((int)key) || (Keyboard != null && Keyboard(key));

        /// <summary>True while a key is held on the keyboard, as for a script that reads Unity's Input.</summary>
        internal static bool IsOnKeyboard(LabKey key) => IsDown((int)key);

        /// <summary>Sets whether a button of the panel is held.</summary>
        public static void HoldOnScreen(LabKey key, bool isHeld) => OnScreen[(int)key] = isHeld;

        /// <summary>
        /// Releases all keys: the window has lost the keyboard or the game is paused, so that releases are not reported. A key that is still
        /// down is reported again.
        /// </summary>
        public static void LetGo()
        {
            Array.Clear(InEvents, 0, InEvents.Length);
            Array.Clear(OnScreen, 0, OnScreen.Length);
        }

        // where the domain is not reloaded, the default from Unity 6.6 on, static variables keep their values after Stop
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Begin()
        {
            LetGo();
            Keyboard = null;
        }

#if ENABLE_LEGACY_INPUT_MANAGER || !UNITY_2019_3_OR_NEWER
        private static bool IsDown(int key) => Input.GetKey(Codes[key]);
#else
        private static bool IsDown(int key) => false;

        // the project has no Input: an object of our own receives the events of OnGUI
        [RuntimeInitializeOnLoadMethod]
        private static void Listen()
        {
            GameObject listener = new GameObject("Keys of the lab") { hideFlags = HideFlags.HideInHierarchy };
            listener.AddComponent<KeyListener>();
            UnityEngine.Object.DontDestroyOnLoad(listener);
        }

        private static int KeyOf(KeyCode code)
        {
            switch (code)
            {
                case KeyCode.LeftArrow: return (int)LabKey.LeftArrow;
                case KeyCode.RightArrow: return (int)LabKey.RightArrow;
                case KeyCode.UpArrow: return (int)LabKey.UpArrow;
                case KeyCode.DownArrow: return (int)LabKey.DownArrow;
                case KeyCode.R: return (int)LabKey.R;
                default: return -1;
            }
        }

        /// <summary>Receives key events where the keyboard cannot be read.</summary>
        private sealed class KeyListener : MonoBehaviour
        {
            private void OnGUI()
            {
                int key = KeyOf(Event.current.keyCode);
                if (Keyboard == null && key >= 0 && (Event.current.type == EventType.KeyDown || Event.current.type == EventType.KeyUp))
                    InEvents[key] = Event.current.type == EventType.KeyDown;
            }

            private void OnApplicationFocus(bool hasFocus)
            {
                if (!hasFocus)
                    LetGo();
            }

            private void OnApplicationPause(bool isPaused)
            {
                if (isPaused)
                    LetGo();
            }
        }
#endif
    }
}
