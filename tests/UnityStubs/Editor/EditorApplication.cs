using System;

namespace UnityEditor
{
    /// <summary>The editor itself.</summary>
    public sealed class EditorApplication
    {
        public delegate void CallbackFunction();

        /// <summary>What is called once, after the present event.</summary>
        public static CallbackFunction delayCall;

        public static event Action<PauseState> pauseStateChanged;

        /// <summary>What the button does that pauses the game.</summary>
        internal static void Pause(bool isPaused) => pauseStateChanged?.Invoke(isPaused ? PauseState.Paused : PauseState.Unpaused);
    }

    /// <summary>Whether the game stands still.</summary>
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
