using UnityEngine;
using UnityEngine.InputSystem;
using UnityEngine.InputSystem.Controls;

namespace RigidBodyDynamics.Scripts
{
    /// <summary>The lab's keys by the Input System. An assembly of its own, which Unity leaves out where the project does not have the package.</summary>
    internal static class InputSystemKeys
    {
        // called again where changed scripts are loaded while the game plays
#if UNITY_EDITOR
        [UnityEditor.InitializeOnLoadMethod]
#endif
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.BeforeSceneLoad)]
        private static void Register() => LabInput.Keyboard = IsDown;

        private static bool IsDown(LabKey key)
        {
            // a machine may have no keyboard
            Keyboard keyboard = Keyboard.current;
            return keyboard != null && Control(keyboard, key).isPressed;
        }

        private static KeyControl Control(Keyboard keyboard, LabKey key)
        {
            switch (key)
            {
                case LabKey.LeftArrow: return keyboard.leftArrowKey;
                case LabKey.RightArrow: return keyboard.rightArrowKey;
                case LabKey.UpArrow: return keyboard.upArrowKey;
                case LabKey.DownArrow: return keyboard.downArrowKey;
                default: return keyboard.rKey;
            }
        }
    }
}
