namespace RigidBodyDynamics.Starter
{
    /// <summary>
    /// The source of two classes without a namespace, Input and Time, which a script that is compiled together with them finds before the
    /// engine's: so keys and clock can be set while the game is not playing.
    /// </summary>
    internal static class KeysAndClock
    {
        public const string Source = @"
using UnityEngine;

public static class Input
{
    public static int Held, Before;
    public static System.Action<int> Asked;
    static readonly KeyCode[] codes = { KeyCode.LeftArrow, KeyCode.RightArrow, KeyCode.UpArrow, KeyCode.DownArrow, KeyCode.R };
    static readonly string[] names = { ""left"", ""right"", ""up"", ""down"", ""r"" };

    static int Bit(KeyCode key) { int i = System.Array.IndexOf(codes, key); return i < 0 ? 0 : 1 << i; }
    static int Bit(string key) { int i = System.Array.IndexOf(names, key); return i < 0 ? 0 : 1 << i; }
    static bool Is(int bit, bool held, bool before)
    {
        if (bit == 0) return false;
        if (Asked != null) Asked(bit);
        return held == ((Held & bit) != 0) && before == ((Before & bit) != 0);
    }
    static bool Has(int bit)
    {
        if (bit != 0 && Asked != null) Asked(bit);
        return (Held & bit) != 0;
    }

    public static bool GetKey(KeyCode key) { return Has(Bit(key)); }
    public static bool GetKey(string name) { return Has(Bit(name)); }
    public static bool GetKeyDown(KeyCode key) { return Is(Bit(key), true, false); }
    public static bool GetKeyDown(string name) { return Is(Bit(name), true, false); }
    public static bool GetKeyUp(KeyCode key) { return Is(Bit(key), false, true); }
    public static bool GetKeyUp(string name) { return Is(Bit(name), false, true); }
    public static float GetAxisRaw(string axis)
    {
        if (axis == ""Horizontal"") return (Has(2) ? 1 : 0) - (Has(1) ? 1 : 0);
        if (axis == ""Vertical"") return (Has(4) ? 1 : 0) - (Has(8) ? 1 : 0);
        return 0;
    }
    public static float GetAxis(string axis) { return GetAxisRaw(axis); }
    public static bool GetButton(string name) { return false; }
    public static bool GetButtonDown(string name) { return false; }
    public static bool GetMouseButton(int button) { return false; }
    public static bool GetMouseButtonDown(int button) { return false; }
    public static bool anyKey { get { return Held != 0; } }
    public static bool anyKeyDown { get { return (Held & ~Before) != 0; } }
    public static Vector3 mousePosition { get { return Vector3.zero; } }
}

public static class Time
{
    public static float time, fixedTime, timeSinceLevelLoad, unscaledTime, realtimeSinceStartup;
    public static float deltaTime, unscaledDeltaTime, smoothDeltaTime, fixedDeltaTime = 0.02f, timeScale = 1;
    public static int frameCount;
}
";
    }
}
