using UnityEngine;

namespace RigidBodyDynamics.Scripts
{
    /// <summary>
    /// Conversions between the library, which computes in double, and the engine, which computes in float. Unity's axes are
    /// left-handed; x, y, z and the formulas are the same.
    /// </summary>
    public static class ToUnity
    {
        /// <summary>A vector for the engine, rounded to float.</summary>
        public static Vector3 Float(this Vector3d v) => new Vector3((float)v.X, (float)v.Y, (float)v.Z);

        /// <summary>An orientation for the engine, rounded to float. Unity has w last.</summary>
        public static Quaternion Float(this Quaterniond q) => new Quaternion((float)q.X, (float)q.Y, (float)q.Z, (float)q.W);

        /// <summary>A vector of the engine, without rounding.</summary>
        public static Vector3d Double(this Vector3 v) => new Vector3d(v.x, v.y, v.z);

        /// <summary>An orientation of the engine, without rounding.</summary>
        public static Quaterniond Double(this Quaternion q) => new Quaterniond(q.w, q.x, q.y, q.z);

        /// <summary>The decimal number that a user has typed as a float: 0.02 for 0.02f, which is 0.0199999996.</summary>
        public static double Meant(float number) => (double)(decimal)number;
    }
}
