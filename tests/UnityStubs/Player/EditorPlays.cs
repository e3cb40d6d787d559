using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using UnityEngine;

namespace RigidBodyDynamics.Engine
{
    /// <summary>Actions in the editor while the game plays.</summary>
    internal static class EditorPlays
    {
        private const BindingFlags Own = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

        private const BindingFlags Statics = BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

        private static readonly Type[] Kept =
            { typeof(bool), typeof(int), typeof(float), typeof(double), typeof(string), typeof(Vector3), typeof(Vector2), typeof(Quaternion) };

        /// <summary>
        /// Changed scripts are loaded ("Recompile and continue"): every script hears OnDisable and OnEnable, and in between has lost what Unity
        /// does not serialize. Private fields are kept, read-only ones are not (Unity's manual, "Script serialization", hot reloading).
        /// </summary>
        public static void Recompile()
        {
            MonoBehaviour[] scripts = World.Scripts.Where(script => script.isActiveAndEnabled).ToArray();
            foreach (MonoBehaviour script in scripts)
                Messages.Send(script, "OnDisable");

            foreach (MonoBehaviour script in World.Scripts)
                Forget(script);

            Type[] types = Array.FindAll(typeof(EditorPlays).Assembly.GetTypes(), type => type.Namespace == "RigidBodyDynamics.Scripts");
            foreach (Type type in types)
                ForgetStatics(type);

            // what is called when play begins is not called again
            foreach (MethodInfo method in types.SelectMany(type => type.GetMethods(Statics)).Where(method => method.IsDefined(typeof(UnityEditor.InitializeOnLoadMethodAttribute))))
                method.Invoke(null, null);

            foreach (MonoBehaviour script in scripts)
                Messages.Send(script, "OnEnable");
        }

        /// <summary>Ctrl+D: a copy with the saved values.</summary>
        public static GameObject Duplicate(GameObject original)
        {
            GameObject copy = new GameObject(original.name + " (1)", isActive: false);
            copy.transform.SetPositionAndRotation(original.transform.position, original.transform.rotation);
            copy.transform.localScale = original.transform.localScale;
            foreach (Component part in original.Components.Where(part => !(part is Transform)))
            {
                Component copied = copy.GetComponent(part.GetType()) ?? copy.Attach(part.GetType());
                foreach (FieldInfo field in part is MonoBehaviour ? SavedFields.Of(part.GetType()) : new List<FieldInfo>())
                    field.SetValue(copied, field.GetValue(part));

                if (part is Rigidbody body)
                    ((Rigidbody)copied).useGravity = body.useGravity;
            }

            copy.SetActive(true);
            return copy;
        }

        private static void Forget(MonoBehaviour script)
        {
            object fresh = Activator.CreateInstance(script.GetType(), nonPublic: true);
            for (Type type = script.GetType(); type != typeof(MonoBehaviour); type = type.BaseType)
            {
                foreach (FieldInfo field in type.GetFields(Own).Where(field => !IsKept(field)))
                    field.SetValue(script, field.GetValue(fresh));
            }
        }

        private static bool IsKept(FieldInfo field)
        {
            Type type = field.FieldType.IsArray ? field.FieldType.GetElementType() : field.FieldType;
            return !field.IsInitOnly && !field.IsDefined(typeof(NonSerializedAttribute))
                && (Kept.Contains(type) || type.IsEnum || typeof(UnityEngine.Object).IsAssignableFrom(type));
        }

        private static void ForgetStatics(Type type)
        {
            foreach (FieldInfo field in type.GetFields(Statics).Where(field => !field.IsInitOnly && !field.IsLiteral && !field.Name.Contains("<>")))
                field.SetValue(null, field.FieldType.IsValueType ? Activator.CreateInstance(field.FieldType) : null);
        }
    }
}
