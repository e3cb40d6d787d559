using System;

namespace UnityEditor
{
    /// <summary>The editor itself.</summary>
    public sealed class EditorApplication
    {
        public delegate void CallbackFunction();

        /// <summary>Called once, after the present event.</summary>
        public static CallbackFunction delayCall;

        public static event Action<PauseState> pauseStateChanged;

        /// <summary>Called by the pause button.</summary>
        internal static void Pause(bool isPaused) => pauseStateChanged?.Invoke(isPaused ? PauseState.Paused : PauseState.Unpaused);
    }

    /// <summary>True while the game is paused.</summary>
    public enum PauseState
    {
        Paused,
        Unpaused,
    }

    /// <summary>A class whose static constructor the editor calls when it has loaded the scripts.</summary>
    [AttributeUsage(AttributeTargets.Class)]
    public class InitializeOnLoadAttribute : Attribute { }

    /// <summary>A static method that the editor calls when it has loaded the scripts, also while the game plays.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    public class InitializeOnLoadMethodAttribute : Attribute { }
}
