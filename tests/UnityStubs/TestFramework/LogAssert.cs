using System.Text.RegularExpressions;
using RigidBodyDynamics.Engine;

namespace UnityEngine.TestTools
{
    /// <summary>What a test expects in the console; errors that it does not expect make it fail.</summary>
    public static class LogAssert
    {
        public static bool ignoreFailingMessages
        {
            get => UnityConsole.IgnoresErrors;
            set => UnityConsole.IgnoresErrors = value;
        }

        public static void Expect(LogType type, string message) => UnityConsole.Expect(type, new Regex("^" + Regex.Escape(message) + "$"));

        public static void Expect(LogType type, Regex message) => UnityConsole.Expect(type, message);
    }
}
