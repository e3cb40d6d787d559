namespace UnityEngine
{
    /// <summary>The old input, which throws where a project has the Input System alone.</summary>
    public static class Input
    {
        public static bool GetKey(KeyCode key)
        {
#if ENABLE_LEGACY_INPUT_MANAGER
            return UnityStubs.Keys.IsDown(key);
#else
            throw new System.InvalidOperationException("You are trying to read Input using the UnityEngine.Input class, but you have switched active Input handling to Input System package in Player Settings.");
#endif
        }
    }

    /// <summary>The keys that matter here, with Unity's numbers.</summary>
    public enum KeyCode
    {
        None = 0,
        Space = 32,
        A = 97,
        R = 114,
        UpArrow = 273,
        DownArrow = 274,
        RightArrow = 275,
        LeftArrow = 276,
    }
}
