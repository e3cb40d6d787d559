using System;
using System.Globalization;

namespace RigidBodyDynamics
{
    /// <summary>Refuses invalid values, by name and value, before anything has been changed.</summary>
    internal static class Guard
    {
        /// <summary>True for every number but NaN and the infinities.</summary>
        public static bool IsFinite(double value) => value - value == 0;

        /// <summary>Returns the value if it is finite.</summary>
        public static double Finite(double value, string name) =>
            IsFinite(value) ? value : throw Refused(name, value, "must be a finite number");

        /// <summary>Returns the vector if it is finite.</summary>
        public static Vector3d Finite(Vector3d value, string name) =>
            value.IsFinite ? value : throw Refused(name, value, "must have finite components");

        /// <summary>Returns the value if it is finite and above zero.</summary>
        public static double Positive(double value, string name) =>
            value > 0 && IsFinite(value) ? value : throw Refused(name, value, "must be finite and above zero");

        /// <summary>Returns the vector if all its components are finite and above zero.</summary>
        public static Vector3d Positive(Vector3d value, string name) =>
            value.IsFinite && value.X > 0 && value.Y > 0 && value.Z > 0
                ? value
                : throw Refused(name, value, "must have finite components above zero");

        /// <summary>Returns the value if it is finite and not below zero.</summary>
        public static double NotNegative(double value, string name) =>
            value >= 0 && IsFinite(value) ? value : throw Refused(name, value, "must be finite and not below zero");

        /// <summary>Returns the quaternion if it can be scaled to length 1.</summary>
        public static Quaterniond Turn(Quaterniond value, string name)
        {
            double square = value.LengthSquared;
            return square > 1e-200 && square < 1e200
                ? value
                : throw Refused(name, value, "must be a quaternion [w, x, y, z] of length 1 or one that can be scaled to it");
        }

        /// <summary>Returns an item of a list if it is finite. The name is built only for the error: one for every item would cost more than the list.</summary>
        internal static Vector3d Finite(Vector3d value, string list, int index) =>
            value.IsFinite ? value : Finite(value, list + "[" + index + "]");

        /// <summary>Returns an item of a list if it is finite and above zero.</summary>
        internal static double Positive(double value, string list, int index) =>
            value > 0 && IsFinite(value) ? value : Positive(value, list + "[" + index + "]");

        /// <summary>Returns the reference if it is not null.</summary>
        public static T NotNull<T>(T value, string name) where T : class => value ?? throw new ArgumentNullException(name);

        /// <summary>The exception that names the argument, the requirement and the value.</summary>
        public static ArgumentOutOfRangeException Refused(string name, object value, string rule)
        {
            // "R" is for floating-point numbers: an enum, and on older runtimes an integer, refuses it
            string found = value is double number
                ? number.ToString("R", CultureInfo.InvariantCulture)
                : Convert.ToString(value, CultureInfo.InvariantCulture);
            return new RefusedException(name, value, rule + ", found " + found);
        }

        /// <summary>A number in digits. A float in those digits that a user would write: 0.05, not 0.05000000074505806.</summary>
        internal static string AsGiven(double value) =>
            (value == (float)value ? (float)value : (IFormattable)value).ToString("R", CultureInfo.InvariantCulture);

        /// <summary>A message in one line, whatever names and effects it contains.</summary>
        internal static string OneLine(string message) => message.Replace('\r', ' ').Replace('\n', ' ');

        /// <summary>The message alone, without the lines that the runtime would add.</summary>
        private sealed class RefusedException : ArgumentOutOfRangeException
        {
            private readonly string _line;

            public RefusedException(string name, object value, string rule) : base(name, value, rule) =>
                _line = OneLine(name + ": " + rule);

            public override string Message => _line;
        }
    }
}
