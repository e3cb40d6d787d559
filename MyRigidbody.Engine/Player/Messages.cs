using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using UnityEngine;

namespace RigidBodyDynamics.Engine
{
    /// <summary>Finds a script's messages by name, including private ones, and calls them as Unity does.</summary>
    internal static class Messages
    {
        private const BindingFlags Own = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;
        private static readonly RuntimeInitializeLoadType[] Begins =
        {
            RuntimeInitializeLoadType.SubsystemRegistration, RuntimeInitializeLoadType.AfterAssembliesLoaded,
            RuntimeInitializeLoadType.BeforeSplashScreen, RuntimeInitializeLoadType.BeforeSceneLoad, RuntimeInitializeLoadType.AfterSceneLoad,
        };

        private static readonly Lazy<MethodInfo[]> Initializers = new Lazy<MethodInfo[]>(() => typeof(Messages).Assembly.GetTypes()
            .SelectMany(type => type.GetMethods(BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly))
            .Where(method => method.IsDefined(typeof(RuntimeInitializeOnLoadMethodAttribute)))
            .OrderBy(method => Array.IndexOf(Begins, method.GetCustomAttribute<RuntimeInitializeOnLoadMethodAttribute>().loadType)).ToArray());

        private static readonly Dictionary<(Type, string), MethodInfo> Found = new Dictionary<(Type, string), MethodInfo>();

        /// <summary>True where exceptions of a script are passed to the caller.</summary>
        public static bool ExceptionsPass { get; set; }

        public static bool Has(MonoBehaviour script, string message) => Find(script.GetType(), message) != null;

        /// <summary>An exception is written to the console, and the game continues.</summary>
        public static void Send(MonoBehaviour script, string message, params object[] arguments)
        {
            try
            {
                if (arguments.Length > 0)
                    Invoke(script, Find(script.GetType(), message), arguments);
                else
                    CallOf(script, message)();
            }
            catch (Exception wrong) when (!ExceptionsPass)
            {
                Debug.LogException(wrong is TargetInvocationException ? wrong.InnerException : wrong, script);
            }
        }

        // most messages are sent in every frame: the method is looked up once, and called without reflection where possible
        private static Action CallOf(MonoBehaviour script, string message)
        {
            if (script.Calls.TryGetValue(message, out Action call))
                return call;

            MethodInfo method = Find(script.GetType(), message);
            return script.Calls[message] = method != null && method.ReturnType == typeof(void) && method.GetParameters().Length == 0 && !method.ContainsGenericParameters
                ? (Action)Delegate.CreateDelegate(typeof(Action), script, method)
                : () => Invoke(script, method, Array.Empty<object>());
        }

        private static void Invoke(MonoBehaviour script, MethodInfo method, object[] arguments) =>
            method?.Invoke(script, method.GetParameters().Length == 0 ? null : arguments);

        /// <summary>What the editor sends when a value has been set in it.</summary>
        public static void Validate(Component changed)
        {
            if (changed is MonoBehaviour script)
                Send(script, "OnValidate");
        }

        /// <summary>Calls the methods that scripts have marked for the start of the game.</summary>
        public static void CallInitializers()
        {
            foreach (MethodInfo method in Initializers.Value)
                method.Invoke(null, null);
        }

        /// <summary>Forgets the scripts of an ended world, so that their assemblies can be unloaded.</summary>
        public static void Forget() => Found.Clear();

        internal static MethodInfo Find(Type type, string message)
        {
            if (Found.TryGetValue((type, message), out MethodInfo known))
                return known;

            MethodInfo method = null;
            for (Type owner = type; method == null && owner != typeof(MonoBehaviour); owner = owner.BaseType)
                method = owner.GetMethod(message, Own);

            Found.Add((type, message), method);
            return method;
        }
    }
}
