using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;

namespace UnityEngine
{
    /// <summary>A script's public fields as JSON and back; here numbers and switches alone.</summary>
    public static class JsonUtility
    {
        public static string ToJson(object obj) => "{" + string.Join(",", Fields(obj).Select(field =>
            "\"" + field.Name + "\":" + Convert.ToString(field.GetValue(obj), CultureInfo.InvariantCulture).ToLowerInvariant())) + "}";

        public static void FromJsonOverwrite(string json, object objectToOverwrite)
        {
            foreach (FieldInfo field in Fields(objectToOverwrite))
            {
                Match found = Regex.Match(json, "\"" + field.Name + "\":([^,}]*)");
                if (found.Success)
                    field.SetValue(objectToOverwrite, Convert.ChangeType(found.Groups[1].Value, field.FieldType, CultureInfo.InvariantCulture));
            }
        }

        private static IEnumerable<FieldInfo> Fields(object obj) => obj.GetType().GetFields(BindingFlags.Instance | BindingFlags.Public)
            .Where(field => field.FieldType.IsPrimitive);
    }
}
