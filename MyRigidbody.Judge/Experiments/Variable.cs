using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;

namespace RigidBodyDynamics.Judging
{
    /// <summary>The shape of a variable, by its numbers.</summary>
    internal enum Shape
    {
        Number,
        Vector,
        Quaternion,
        Matrix,
    }

    /// <summary>A variable of the script as a list of numbers: 1; x y z; x y z w; or nine, row by row.</summary>
    internal sealed class Variable
    {
        public const string ScalarFirstPrefix = "scalar first: ";

        private readonly Func<double[]> _read;
        private readonly Action<double[]> _write;

        public Variable(string name, Shape shape, bool isStatic, Func<double[]> read, Action<double[]> write)
        {
            Name = name;
            Shape = shape;
            IsStatic = isStatic;
            _read = read;
            _write = write;
        }

        /// <summary>The name in the script, with points between a struct and its members.</summary>
        public string Name { get; }

        public Shape Shape { get; }

        public bool IsStatic { get; }

        public double Number
        {
            get => _read()[0];
            set => Write(new[] { value });
        }

        public Vector Vector
        {
            get
            {
                double[] v = _read();
                return new Vector(v[0], v[1], v[2]);
            }
            set => Write(new[] { value.X, value.Y, value.Z });
        }

        public Orientation Orientation
        {
            get
            {
                double[] q = _read();
                return new Orientation(q[0], q[1], q[2], q[3]);
            }
            set => Write(new[] { value.X, value.Y, value.Z, value.W });
        }

        public Matrix Matrix
        {
            get
            {
                double[] m = _read();
                return new Matrix(new Vector(m[0], m[1], m[2]), new Vector(m[3], m[4], m[5]), new Vector(m[6], m[7], m[8]));
            }
            set => Write(new[]
            {
                value.Row0.X, value.Row0.Y, value.Row0.Z, value.Row1.X, value.Row1.Y, value.Row1.Z, value.Row2.X, value.Row2.Y, value.Row2.Z,
            });
        }

        public double[] Numbers => _read();

        /// <summary>Returns whether the numbers could be written: constants and read-only fields cannot.</summary>
        public bool Write(double[] numbers)
        {
            try
            {
                _write(numbers);
                return true;
            }
            catch (Exception e) when (e is FieldAccessException || e is TargetException || e is NotSupportedException)
            {
                return false;
            }
        }

        /// <summary>The same numbers in another order: <c>w x y z</c> read as <c>x y z w</c>.</summary>
        public Variable ScalarFirst() => new Variable(
            ScalarFirstPrefix + Name,
            Shape,
            IsStatic,
            () => { double[] q = _read(); return new[] { q[1], q[2], q[3], q[0] }; },
            q => _write(new[] { q[3], q[0], q[1], q[2] }));

        /// <summary>Several numbers as one vector: vx, vy, vz.</summary>
        public static Variable Together(string name, Shape shape, IReadOnlyList<Variable> parts) => new Variable(
            name,
            shape,
            parts[0].IsStatic,
            () => parts.Select(p => p.Number).ToArray(),
            values =>
            {
                for (int i = 0; i < parts.Count; i++)
                    parts[i].Number = values[i];
            });
    }
}
