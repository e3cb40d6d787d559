using System;

namespace UnityEngine
{
    /// <summary>Rotations from and to other forms than an angle about an axis.</summary>
    internal static class Turns
    {
        private const float Degrees = 180 / (float)Math.PI;

        /// <summary>From R = R_y R_x R_z: sin x = −R₁₂; at the poles z is zero.</summary>
        public static Vector3 ToEuler(Quaternion turn)
        {
            Quaternion q = turn.normalized;
            double sine = 2.0 * ((double)q.w * q.x - (double)q.y * q.z);
            if (Math.Abs(sine) > 0.999999)
                return Positive(Math.Sign(sine) * Math.PI / 2, 2 * Math.Atan2(q.y, q.w), 0);

            return Positive(
                Math.Asin(sine),
                Math.Atan2(2.0 * ((double)q.x * q.z + (double)q.w * q.y), 1 - 2.0 * ((double)q.x * q.x + (double)q.y * q.y)),
                Math.Atan2(2.0 * ((double)q.x * q.y + (double)q.w * q.z), 1 - 2.0 * ((double)q.x * q.x + (double)q.z * q.z)));
        }

        /// <summary>z along the first direction, y in the plane of both; the identity where there is no such rotation.</summary>
        public static Quaternion LookRotation(Vector3 forward, Vector3 upwards)
        {
            if (forward.magnitude < Vector3.kEpsilon)
                return Quaternion.identity;

            Vector3 z = forward / forward.magnitude, x = Vector3.Cross(upwards, z);
            if (x.magnitude < Vector3.kEpsilon)
                return Between(Vector3.forward, z);

            x /= x.magnitude;
            return OfAxes(x, Vector3.Cross(z, x), z);
        }

        /// <summary>The shortest rotation from one direction to another.</summary>
        public static Quaternion Between(Vector3 from, Vector3 to)
        {
            float lengths = Mathf.Sqrt(from.sqrMagnitude * to.sqrMagnitude);
            if (lengths < Vector3.kEpsilonNormalSqrt)
                return Quaternion.identity;

            Vector3 axis = Vector3.Cross(from, to) / lengths;
            float cosine = Vector3.Dot(from, to) / lengths;
            if (cosine > -1 + Quaternion.kEpsilon)
                return new Quaternion(axis.x, axis.y, axis.z, 1 + cosine).normalized;

            Vector3 across = Vector3.Cross(Vector3.right, from);
            return Quaternion.AngleAxis(180, across.sqrMagnitude > 1e-6f * from.sqrMagnitude ? across : Vector3.Cross(Vector3.up, from));
        }

        /// <summary>Along the shorter arc at a constant rate.</summary>
        public static Quaternion Slerp(Quaternion a, Quaternion b, float t)
        {
            double cosine = Quaternion.Dot(a, b), sign = cosine < 0 ? -1 : 1, angle = Math.Acos(Math.Min(Math.Abs(cosine), 1)), sine = Math.Sin(angle);
            return sine < 1e-6
                ? Mix(a, b, 1 - t, (float)(sign * t))
                : Mix(a, b, (float)(Math.Sin((1 - t) * angle) / sine), (float)(sign * Math.Sin(t * angle) / sine));
        }

        /// <summary>The normalised weighted sum.</summary>
        public static Quaternion Mix(Quaternion a, Quaternion b, float ofA, float ofB) =>
            new Quaternion(ofA * a.x + ofB * b.x, ofA * a.y + ofB * b.y, ofA * a.z + ofB * b.z, ofA * a.w + ofB * b.w).normalized;

        /// <summary>The rotation whose axes are these orthogonal unit vectors.</summary>
        public static Quaternion OfAxes(Vector3 x, Vector3 y, Vector3 z)
        {
            // 4 times the square of a component is one plus or minus the diagonal; divides by the largest of the four
            float trace = x.x + y.y + z.z;
            Quaternion fourTimes =
                trace > 0 ? new Quaternion(y.z - z.y, z.x - x.z, x.y - y.x, 1 + trace)
                : x.x > y.y && x.x > z.z ? new Quaternion(1 + x.x - y.y - z.z, y.x + x.y, z.x + x.z, y.z - z.y)
                : y.y > z.z ? new Quaternion(y.x + x.y, 1 + y.y - x.x - z.z, z.y + y.z, z.x - x.z)
                : new Quaternion(z.x + x.z, z.y + y.z, 1 + z.z - x.x - y.y, x.y - y.x);
            return fourTimes.normalized;
        }

        private static Vector3 Positive(double x, double y, double z) => new Vector3(Positive(x), Positive(y), Positive(z));

        private static float Positive(double radians)
        {
            float degrees = (float)radians * Degrees;
            return degrees < 0 ? degrees + 360 : degrees;
        }
    }
}
