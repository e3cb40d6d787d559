using System.Collections.Generic;
using UnityEngine;

namespace UnityStubs
{
    /// <summary>The keyboard. Who holds it may change its mind between frames.</summary>
    public static class Keys
    {
        private static readonly HashSet<KeyCode> Down = new HashSet<KeyCode>();
        private static readonly List<(KeyCode Key, bool IsDown)> Changes = new List<(KeyCode, bool)>();

        /// <summary>Presses a key, or lets it go.</summary>
        public static void Hold(KeyCode key, bool isDown)
        {
            if (isDown ? Down.Add(key) : Down.Remove(key))
                Changes.Add((key, isDown));
        }

        internal static bool IsDown(KeyCode key) => Down.Contains(key);

        internal static void Reset()
        {
            Down.Clear();
            Changes.Clear();
        }

        /// <summary>What happened since this was asked last.</summary>
        internal static (KeyCode Key, bool IsDown)[] TakeChanges()
        {
            (KeyCode, bool)[] taken = Changes.ToArray();
            Changes.Clear();
            return taken;
        }
    }
}
