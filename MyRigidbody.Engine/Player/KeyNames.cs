using System;
using System.Collections.Generic;
using UnityEngine;

namespace RigidBodyDynamics.Engine
{
    /// <summary>Keys by the engine's names: "r", "left", "space", "left shift" …</summary>
    internal static class KeyNames
    {
        private static readonly Dictionary<string, KeyCode> Special = new Dictionary<string, KeyCode>
        {
            { "up", KeyCode.UpArrow },
            { "down", KeyCode.DownArrow },
            { "right", KeyCode.RightArrow },
            { "left", KeyCode.LeftArrow },
            { "space", KeyCode.Space },
            { "return", KeyCode.Return },
            { "enter", KeyCode.KeypadEnter },
            { "escape", KeyCode.Escape },
            { "tab", KeyCode.Tab },
            { "backspace", KeyCode.Backspace },
            { "delete", KeyCode.Delete },
            { "left shift", KeyCode.LeftShift },
            { "right shift", KeyCode.RightShift },
            { "left ctrl", KeyCode.LeftControl },
            { "right ctrl", KeyCode.RightControl },
            { "left alt", KeyCode.LeftAlt },
            { "right alt", KeyCode.RightAlt },
        };

        public static KeyCode Find(string name)
        {
            if (Special.TryGetValue(name ?? string.Empty, out KeyCode special))
                return special;

            // letters and digits have the numbers of their characters
            if (name != null && name.Length == 1 && (char.IsDigit(name[0]) || (name[0] >= 'a' && name[0] <= 'z')))
                return (KeyCode)name[0];

            throw new ArgumentException("Input Key named: " + name + " is unknown");
        }
    }
}
