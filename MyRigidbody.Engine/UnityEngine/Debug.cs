using System;
using RigidBodyDynamics.Engine;

namespace UnityEngine
{
    /// <summary>The console.</summary>
    public static class Debug
    {
        public static bool isDebugBuild => true;

        public static ILogger unityLogger { get; } = new Logger();

        public static void DrawRay(Vector3 start, Vector3 dir) { }

        public static void DrawRay(Vector3 start, Vector3 dir, Color color) { }

        public static void DrawRay(Vector3 start, Vector3 dir, Color color, float duration) { }

        public static void DrawLine(Vector3 start, Vector3 end) { }

        public static void DrawLine(Vector3 start, Vector3 end, Color color) { }

        public static void DrawLine(Vector3 start, Vector3 end, Color color, float duration) { }

        public static void LogFormat(string format, params object[] args) =>
            UnityConsole.Write(LogType.Log, string.Format(System.Globalization.CultureInfo.InvariantCulture, format, args));

        public static void LogWarningFormat(string format, params object[] args) =>
            UnityConsole.Write(LogType.Warning, string.Format(System.Globalization.CultureInfo.InvariantCulture, format, args));

        public static void LogErrorFormat(string format, params object[] args) =>
            UnityConsole.Write(LogType.Error, string.Format(System.Globalization.CultureInfo.InvariantCulture, format, args));

        public static void Assert(bool condition) => Assert(condition, "Assertion failed");

        public static void Assert(bool condition, string message)
        {
            if (!condition)
                UnityConsole.Write(LogType.Assert, message);
        }

        public static void Break() { }

        public static void Log(object message) => Log(message, null);

        public static void Log(object message, Object context) => UnityConsole.Write(LogType.Log, message);

        public static void LogWarning(object message) => LogWarning(message, null);

        public static void LogWarning(object message, Object context) => UnityConsole.Write(LogType.Warning, message);

        public static void LogError(object message) => LogError(message, null);

        public static void LogError(object message, Object context) => UnityConsole.Write(LogType.Error, message);

        public static void LogException(Exception exception) => LogException(exception, null);

        public static void LogException(Exception exception, Object context) => UnityConsole.Write(LogType.Exception, exception);
    }

    /// <summary>The kind of a line of the console.</summary>
    public enum LogType
    {
        Error,
        Assert,
        Warning,
        Log,
        Exception,
    }

    /// <summary>Decides whether a line is written to the console.</summary>
    public interface ILogger
    {
        bool logEnabled { get; set; }
    }

    internal sealed class Logger : ILogger
    {
        public bool logEnabled { get; set; } = true;
    }
}
