using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;

namespace RigidBodyDynamics.Judging
{
    /// <summary>The numbers that a script stores between frames, found by reflection; types of the engine are recognised by their members' names.</summary>
    internal static class ScriptVariables
    {
        private const int Deepest = 3;

        public static IReadOnlyList<Variable> Of(object script)
        {
            List<Variable> found = new List<Variable>();
            List<Type> types = new List<Type>();
            for (Type type = script.GetType(); type != null && type.Assembly == script.GetType().Assembly; type = type.BaseType)
                types.Insert(0, type);
            foreach (Type type in types)
                AddFields(found, Place.Of(script), type, "", script.GetType().Assembly, 0);
            return Grouped(found);
        }

        private static void AddFields(List<Variable> found, Place owner, Type type, string prefix, Assembly scripts, int depth)
        {
            const BindingFlags All = BindingFlags.Instance | BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;
            foreach (FieldInfo field in type.GetFields(All).Where(f => depth == 0 || !f.IsStatic))
            {
                string name = prefix + PlainName(field.Name);
                Place place = owner.Field(field);
                Variable variable = Shapes.Of(name, place, field.FieldType, field.IsStatic);
                if (variable != null)
                    found.Add(variable);
                else if (depth < Deepest && field.FieldType.Assembly == scripts && !field.FieldType.IsEnum && place.Value != null)
                    AddFields(found, place, field.FieldType, name + ".", scripts, depth + 1);
            }
        }

        /// <summary>The property's name for a field that the compiler generated.</summary>
        private static string PlainName(string field) => field.StartsWith("<", StringComparison.Ordinal) ? field.Substring(1, field.IndexOf('>') - 1) : field;

        private static List<Variable> Grouped(List<Variable> variables)
        {
            List<Variable> result = new List<Variable>(variables);
            foreach (IGrouping<string, Variable> group in variables.Where(v => v.Shape == Shape.Number && IsPart(v.Name)).GroupBy(v => v.Name.Substring(0, v.Name.Length - 1)))
            {
                Variable[] parts = "xyzw".Select(axis => group.FirstOrDefault(v => char.ToLowerInvariant(v.Name[v.Name.Length - 1]) == axis)).ToArray();
                if (parts.Take(3).Any(p => p == null))
                    continue;
                string name = group.Key.TrimEnd('_', '.');
                result.Add(Variable.Together(name.Length > 0 ? name : "x", parts[3] == null ? Shape.Vector : Shape.Quaternion, parts.Where(p => p != null).ToArray()));
            }

            return result;
        }

        private static bool IsPart(string name) => "xyzwXYZW".IndexOf(name[name.Length - 1]) >= 0;
    }
}
