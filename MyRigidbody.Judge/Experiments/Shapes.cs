using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Reflection;

namespace RigidBodyDynamics.Judging
{
    /// <summary>Reads a field as a number, a vector, a quaternion or a matrix, whatever its type in the script.</summary>
    internal static class Shapes
    {
        private static readonly string[] MatrixNames = { "m00", "m01", "m02", "m10", "m11", "m12", "m20", "m21", "m22" };
        private static readonly string[][] QuaternionNames =
        {
            new[] { "x", "y", "z", "w" }, new[] { "x", "y", "z", "s" }, new[] { "i", "j", "k", "w" }, new[] { "i", "j", "k", "s" }, new[] { "b", "c", "d", "a" },
        };

        /// <summary>Null where the field is none of them.</summary>
        public static Variable Of(string name, Place place, Type type, bool isStatic)
        {
            if (IsNumber(type))
                return new Variable(name, Shape.Number, isStatic, () => new[] { ToNumber(place.Value) }, v => place.Value = FromNumber(v[0], type));
            if (type.IsArray)
                return IsNumber(Element(type)) ? OfArray(name, place, isStatic) : null;
            if (type.IsPrimitive || type.IsEnum || type == typeof(string) || type.IsPointer || place.Value == null)
                return null;
            return OfMembers(name, place, type, isStatic);
        }

        private static Variable OfMembers(string name, Place place, Type type, bool isStatic)
        {
            Dictionary<string, FieldInfo> fields = new Dictionary<string, FieldInfo>();
            foreach (FieldInfo field in type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic))
                fields[field.Name.Trim('_').ToLowerInvariant()] = field;
            if (fields.Count == 2 && ScalarAndVector(fields.Values, out FieldInfo scalar, out FieldInfo vector))
                return OfParts(name, place, new[] { "x", "y", "z" }.Select(axis => new[] { vector, vector.FieldType.GetField(axis) }).Concat(new[] { new[] { scalar } }), Shape.Quaternion, isStatic);
            string[] names = fields.Count == 3 ? new[] { "x", "y", "z" }
                : fields.Count == 4 ? QuaternionNames.FirstOrDefault(q => q.All(fields.ContainsKey))
                : fields.Count >= 9 ? MatrixNames : null;
            if (names == null || !names.All(n => fields.ContainsKey(n) && IsNumber(fields[n].FieldType)))
                return null;
            Shape shape = names.Length == 3 ? Shape.Vector : names.Length == 4 ? Shape.Quaternion : Shape.Matrix;
            FieldInfo[] parts = names.Select(n => fields[n]).ToArray();
            Func<object, double[]> read = Structures.Of(type) ?? (owner => Array.ConvertAll(parts, part => ToNumber(part.GetValue(owner))));
            return new Variable(name, shape, isStatic, () => read(place.Value), values =>
            {
                object owner = place.Value;
                for (int i = 0; i < parts.Length; i++)
                    parts[i].SetValue(owner, FromNumber(values[i], parts[i].FieldType));
                // a struct was read as a copy
                if (owner is ValueType)
                    place.Value = owner;
            });
        }

        private static bool ScalarAndVector(IEnumerable<FieldInfo> fields, out FieldInfo scalar, out FieldInfo vector)
        {
            scalar = fields.FirstOrDefault(f => IsNumber(f.FieldType));
            vector = fields.FirstOrDefault(f => new[] { "x", "y", "z" }.All(axis => f.FieldType.GetField(axis) != null && IsNumber(f.FieldType.GetField(axis).FieldType)));
            return scalar != null && vector != null;
        }

        private static Variable OfParts(string name, Place place, IEnumerable<FieldInfo[]> paths, Shape shape, bool isStatic)
        {
            Place[] places = paths.Select(path => path.Aggregate(place, (p, field) => p.Field(field))).ToArray();
            Type type = paths.First().Last().FieldType;
            return new Variable(
                name,
                shape,
                isStatic,
                () => places.Select(p => ToNumber(p.Value)).ToArray(),
                values =>
                {
                    for (int i = 0; i < places.Length; i++)
                        places[i].Value = FromNumber(values[i], type);
                });
        }

        private static Variable OfArray(string name, Place place, bool isStatic)
        {
            Array array = place.Value as Array;
            if (array == null || array.Length == 0)
                return null;
            // a jagged array has no second length before its rows are read
            Type type = Element(array.GetType());
            if (array.Rank == 1 && array.GetValue(0) is Array row)
                return array.Length >= 3 && row.Length >= 3 ? Cells(name, Shape.Matrix, isStatic, place, Grid((a, i, j) => ((Array)a.GetValue(i)).GetValue(j)), SetGrid((a, i, j, v) => ((Array)a.GetValue(i)).SetValue(v, j)), type) : null;
            if (array.Rank == 2)
                return array.GetLength(0) >= 3 && array.GetLength(1) >= 3 ? Cells(name, Shape.Matrix, isStatic, place, Grid((a, i, j) => a.GetValue(i, j)), SetGrid((a, i, j, v) => a.SetValue(v, i, j)), type) : null;
            if (array.Rank != 1)
                return null;
            int[] cells = array.Length == 16 ? new[] { 0, 1, 2, 4, 5, 6, 8, 9, 10 } : Enumerable.Range(0, array.Length).ToArray();
            Shape? shape = array.Length == 3 ? Shape.Vector : array.Length == 4 ? Shape.Quaternion : array.Length == 9 || array.Length == 16 ? Shape.Matrix : (Shape?)null;
            return shape == null ? null : Cells(name, shape.Value, isStatic, place, a => cells.Select(c => a.GetValue(c)), (a, values) =>
            {
                for (int i = 0; i < cells.Length; i++)
                    a.SetValue(values[i], cells[i]);
            }, type);
        }

        private static Func<Array, IEnumerable<object>> Grid(Func<Array, int, int, object> cell) =>
            a => Enumerable.Range(0, 9).Select(i => cell(a, i / 3, i % 3));

        private static Action<Array, object[]> SetGrid(Action<Array, int, int, object> set) => (a, values) =>
        {
            for (int i = 0; i < 9; i++)
                set(a, i / 3, i % 3, values[i]);
        };

        private static Variable Cells(string name, Shape shape, bool isStatic, Place place, Func<Array, IEnumerable<object>> read, Action<Array, object[]> write, Type type)
        {
            double[] nothing = Enumerable.Repeat(double.NaN, shape == Shape.Vector ? 3 : shape == Shape.Quaternion ? 4 : 9).ToArray();
            return new Variable(
                name,
                shape,
                isStatic,
                () => place.Value is Array array ? read(array).Select(ToNumber).ToArray() : nothing,
                values =>
                {
                    if (place.Value is Array array)
                        write(array, values.Select(v => FromNumber(v, type)).ToArray());
                });
        }

        private static Type Element(Type type) => type.IsArray ? Element(type.GetElementType()) : type;

        private static bool IsNumber(Type type) => type == typeof(float) || type == typeof(double) || type == typeof(int);

        private static double ToNumber(object value) => Convert.ToDouble(value, CultureInfo.InvariantCulture);

        private static object FromNumber(double value, Type type) =>
            type == typeof(float) ? (object)(float)value : type == typeof(int) ? (int)value : (object)value;
    }
}
