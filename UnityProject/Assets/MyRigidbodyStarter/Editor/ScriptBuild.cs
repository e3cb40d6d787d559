using System;
using System.IO;
using System.Linq;
using System.Reflection;
using UnityEditor.Compilation;
using UnityEngine;
using Assembly = System.Reflection.Assembly;

namespace RigidBodyDynamics.Starter
{
    /// <summary>Compiles one script a second time, beside the project's own assemblies, with keys and a clock that can be set.</summary>
    internal static class ScriptBuild
    {
        private const string Folder = "Temp/MyRigidbodyCheck", Own = "Library/ScriptAssemblies/Assembly-CSharp.dll";

        /// <summary>Compiles in the background, and calls one of the two functions at the end.</summary>
        /// <param name="script">The path of the script in the project.</param>
        /// <param name="built">Gets the assembly, and the class to judge.</param>
        /// <param name="failed">Gets the compiler's messages, one line each.</param>
        public static void Begin(string script, Action<Assembly, Type> built, Action<string> failed)
        {
            Directory.CreateDirectory(Folder);
            string name = Folder + "/Check" + Guid.NewGuid().ToString("N"), keys = Folder + "/KeysAndClock.cs";
            File.WriteAllText(keys, KeysAndClock.Source);
#pragma warning disable CS0618 // obsolete since Unity 2023.1, and no other member of the editor compiles beside the project
            AssemblyBuilder builder = new AssemblyBuilder(name + ".dll", script, keys);
#pragma warning restore CS0618
            // other scripts of the student; of two classes with one name the compiler uses the one in the source
            if (File.Exists(Own))
                builder.additionalReferences = new[] { Own };

            builder.buildFinished += (path, messages) => End(path, script, messages, built, failed);
            if (!builder.Build())
                failed("Unity 正在编译，请稍后再试。 Unity is compiling; try again in a moment.");
        }

        private static void End(string path, string script, CompilerMessage[] messages, Action<Assembly, Type> built, Action<string> failed)
        {
            string[] errors = messages.Where(message => message.type == CompilerMessageType.Error)
                .Select(message => Path.GetFileName(script) + " (" + message.line + "): " + message.message).ToArray();
            if (errors.Length > 0)
            {
                failed(string.Join("\n", errors));
                return;
            }

            // loaded from bytes, so that the file is not locked
            Assembly assembly = Assembly.Load(File.ReadAllBytes(path));
            Type type = assembly.GetType(Path.GetFileNameWithoutExtension(script))
                ?? assembly.GetTypes().FirstOrDefault(found => typeof(MonoBehaviour).IsAssignableFrom(found));
            if (type == null || !typeof(MonoBehaviour).IsAssignableFrom(type))
                failed("没有 MonoBehaviour 类。 There is no class that is a MonoBehaviour.");
            else
                built(assembly, type);
        }
    }
}
