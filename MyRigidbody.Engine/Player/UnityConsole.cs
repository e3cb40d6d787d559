using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using UnityEngine;

namespace RigidBodyDynamics.Engine
{
    /// <summary>The lines of Unity's console, and those that a test expects.</summary>
    public static class UnityConsole
    {
        private const int MostLines = 100_000;

        private static readonly List<(LogType Type, string Text)> Written = new List<(LogType, string)>();
        private static readonly List<(LogType Type, Regex Text)> Expected = new List<(LogType, Regex)>();

        /// <summary>True if errors do not make a test fail.</summary>
        public static bool IgnoresErrors { get; set; }

        /// <summary>All lines, in order.</summary>
        public static IReadOnlyList<(LogType Type, string Text)> Lines => Written;

        internal static void Clear()
        {
            Written.Clear();
            Expected.Clear();
            IgnoresErrors = false;
        }

        // limited, so that a script in an endless loop does not fill the memory
        internal static void Write(LogType type, object message)
        {
            if (Written.Count < MostLines && Debug.unityLogger.logEnabled)
                Written.Add((type, message?.ToString() ?? "Null"));
        }

        internal static void Expect(LogType type, Regex text) => Expected.Add((type, text));

        /// <summary>The reason why a test fails: unexpected errors, or expected lines that did not come; null if there is none.</summary>
        internal static string Fault()
        {
            List<(LogType Type, string Text)> left = Written.ToList();
            foreach ((LogType type, Regex text) in Expected)
            {
                int found = left.FindIndex(line => line.Type == type && text.IsMatch(line.Text));
                if (found < 0)
                    return "Expected log did not appear: [" + type + "] " + text;

                left.RemoveAt(found);
            }

            (LogType Type, string Text) error = left.Find(line => line.Type != LogType.Log && line.Type != LogType.Warning);
            return error.Text == null || IgnoresErrors ? null : "Unhandled log message: [" + error.Type + "] " + error.Text;
        }
    }
}
