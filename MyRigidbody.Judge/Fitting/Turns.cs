using System;

namespace RigidBodyDynamics.Judging
{
    /// <summary>A rotation as a vector, in the forms in which scripts compute one from ω.</summary>
    internal static class Turns
    {
        /// <summary>2 · vector / scalar: k ω for q + [0, ½k ω] q, for any length.</summary>
        public static Vector FirstOrder(Orientation turn) =>
            Math.Abs(turn.W) > 0.02 * turn.Imaginary.Length ? (2 / turn.W) * turn.Imaginary : new Vector(double.NaN, double.NaN, double.NaN);

        /// <summary>Angle times axis: k ω for a rotation by the angle k |ω|.</summary>
        public static Vector Exact(Orientation turn)
        {
            double sine = turn.Imaginary.Length, angle = 2 * Math.Atan2(sine, Math.Abs(turn.W));
            return sine < 1e-12 ? Vector.Zero : ((turn.W < 0 ? -angle : angle) / sine) * turn.Imaginary;
        }

        /// <summary>Unity's Euler angles, in radians, nearest to zero.</summary>
        public static Vector Euler(Orientation turn)
        {
            Orientation q = turn.Normalized;
            double sine = Math.Max(-1, Math.Min(1, 2 * (q.W * q.X - q.Y * q.Z)));
            return new Vector(
                Math.Asin(sine),
                Math.Atan2(2 * (q.W * q.Y + q.X * q.Z), 1 - 2 * (q.X * q.X + q.Y * q.Y)),
                Math.Atan2(2 * (q.W * q.Z + q.X * q.Y), 1 - 2 * (q.X * q.X + q.Z * q.Z)));
        }

        /// <summary>The effect of rounding two quaternions to single precision on the rotation between them.</summary>
        public static double Tolerance(Vector turn) => (3e-6 + 1e-5 * turn.Length) * (1 + Vector.Dot(turn, turn));
    }
}
