using System;
using UnityStubs;

namespace UnityEngine
{
    /// <summary>The console.</summary>
    public static class Debug
    {
        public static void Log(object message) => Log(message, null);

        public static void Log(object message, Object context) => UnityConsole.Write(LogType.Log, message);

        public static void LogWarning(object message) => LogWarning(message, null);

        public static void LogWarning(object message, Object context) => UnityConsole.Write(LogType.Warning, message);

        public static void LogError(object message) => LogError(message, null);

        public static void LogError(object message, Object context) => UnityConsole.Write(LogType.Error, message);

        public static void LogException(Exception exception) => LogException(exception, null);

        public static void LogException(Exception exception, Object context) => UnityConsole.Write(LogType.Exception, exception);
    }

    /// <summary>What a line of the console is.</summary>
    public enum LogType
    {
        Error,
        Assert,
        Warning,
        Log,
        Exception,
    }
}
