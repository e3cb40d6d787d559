using System;
using System.Collections.Generic;
using System.Linq;

namespace UnityEditor
{
    /// <summary>An inspector.</summary>
    public class Editor
    {
        public UnityEngine.Object target { get; private set; }

        public SerializedObject serializedObject { get; private set; }

        /// <summary>The inspector of an object: the one that names its class.</summary>
        public static Editor CreateEditor(UnityEngine.Object targetObject)
        {
            IEnumerable<Type> inspectors =
                from type in typeof(Editor).Assembly.GetTypes()
                from CustomEditor found in type.GetCustomAttributes(typeof(CustomEditor), false)
                where found.InspectedType == targetObject.GetType()
                select type;
            Editor editor = (Editor)Activator.CreateInstance(inspectors.Single());
            editor.target = targetObject;
            editor.serializedObject = new SerializedObject(targetObject);
            return editor;
        }

        public virtual void OnInspectorGUI() { }
    }

    /// <summary>Whose inspector it is.</summary>
    [AttributeUsage(AttributeTargets.Class, AllowMultiple = true)]
    public sealed class CustomEditor : Attribute
    {
        public CustomEditor(Type inspectedType) => InspectedType = inspectedType;

        internal Type InspectedType { get; }
    }

    /// <summary>An inspector of several objects at once.</summary>
    [AttributeUsage(AttributeTargets.Class)]
    public sealed class CanEditMultipleObjects : Attribute { }
}
