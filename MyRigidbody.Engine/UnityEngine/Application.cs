using System.IO;
using RigidBodyDynamics.Engine;

namespace UnityEngine
{
    /// <summary>The program.</summary>
    public static class Application
    {
        public static int targetFrameRate { get; set; } = -1;

        public static bool isPlaying => World.IsPlaying;

        public static bool isEditor => true;

        public static SystemLanguage systemLanguage => World.Language;

        /// <summary>Does nothing: the caller of the player ends the game.</summary>
        public static void Quit() { }

        public static string unityVersion =>
#if EVERY_UNITY
            "2022.3.62f1";
#elif UNITY_6000_0_OR_NEWER
            "6000.0.23f1";
#elif UNITY_2022_3_OR_NEWER
            "2022.3.62f1";
#else
            "2019.4.17f1";
#endif

        public static string dataPath => World.InProject("Assets");

        public static string persistentDataPath => Path.Combine(World.Folder, "persistent");

        public static string temporaryCachePath => Path.Combine(World.Folder, "temporary");
    }

    /// <summary>Languages of a system, as far as they matter here.</summary>
    public enum SystemLanguage
    {
        Chinese = 6,
        English = 10,
        ChineseSimplified = 40,
        ChineseTraditional = 41,
        Unknown = 42,
    }

    /// <summary>The window.</summary>
    public static class Screen
    {
        public static int width => World.ScreenWidth;

        public static int height => World.ScreenHeight;
    }
}
