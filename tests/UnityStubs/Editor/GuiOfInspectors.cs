using System.Collections.Generic;
using UnityEngine;

namespace RigidBodyDynamics.Engine
{
    // inspectors are drawn as OnGUI is
    public static partial class Gui
    {
        /// <summary>Draws an inspector.</summary>
        public static void Draw(UnityEditor.Editor inspector)
        {
            _drawn = new List<(string, string)>();
            Send(new Event { type = EventType.Repaint }, inspector, inspector.OnInspectorGUI);
        }

        /// <summary>Clicks, or chooses from a menu, in an inspector.</summary>
        public static void Choose(UnityEditor.Editor inspector, string label, int entry)
        {
            Aim(label, entry);
            Send(new Event { type = EventType.MouseUp }, inspector, inspector.OnInspectorGUI);
            MustHaveHit();
        }
    }
}
