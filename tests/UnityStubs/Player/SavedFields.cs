using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using UnityEngine;

namespace RigidBodyDynamics.Engine
{
    /// <summary>The fields of a script that Unity saves.</summary>
    internal static class SavedFields
    {
        private static readonly Type[] Plain = { typeof(bool), typeof(int), typeof(float), typeof(double), typeof(string), typeof(Vector3) };

        /// <summary>In the order of the source; those of a base class first.</summary>
        public static List<FieldInfo> Of(Type script)
        {
            List<FieldInfo> fields = script.BaseType == null || script.BaseType == typeof(MonoBehaviour) ? new List<FieldInfo>() : Of(script.BaseType);
            fields.AddRange(script.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly)
                .Where(IsSaved));
            return fields;
        }

        private static bool IsSaved(FieldInfo field) =>
            !field.IsInitOnly
            && (field.IsPublic || field.IsDefined(typeof(SerializeField)))
            && (Plain.Contains(field.FieldType) || field.FieldType.IsEnum || typeof(UnityEngine.Object).IsAssignableFrom(field.FieldType));
    }
}
