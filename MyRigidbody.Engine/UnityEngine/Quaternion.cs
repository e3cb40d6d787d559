using System;

namespace UnityEngine
{
    /// <summary>An orientation, w last. Only those members keep its length at one that say so.</summary>
    public struct Quaternion : IEquatable<Quaternion>
    {
        public const float kEpsilon = 1e-6f;

        public float x;
        public float y;
        public float z;
        public float w;

        public Quaternion(float x, float y, float z, float w)
        {
            this.x = x;
            this.y = y;
            this.z = z;
            this.w = w;
        }

        public static Quaternion identity => new Quaternion(0, 0, 0, 1);

        public Quaternion normalized => Normalize(this);

        /// <summary>Degrees about z, then x, then y, each from 0 to 360.</summary>
        public Vector3 eulerAngles
        {
            get => Turns.ToEuler(this);
            set => this = Euler(value);
        }

        public float this[int index]
        {
            get
            {
                switch (index)
                {
                    case 0: return x;
                    case 1: return y;
                    case 2: return z;
                    case 3: return w;
                    default: throw new IndexOutOfRangeException("Invalid Quaternion index!");
                }
            }

            set
            {
                switch (index)
                {
                    case 0: x = value; break;
                    case 1: y = value; break;
                    case 2: z = value; break;
                    case 3: w = value; break;
                    default: throw new IndexOutOfRangeException("Invalid Quaternion index!");
                }
            }
        }

        public static Quaternion operator *(Quaternion lhs, Quaternion rhs) => new Quaternion(
            lhs.w * rhs.x + lhs.x * rhs.w + lhs.y * rhs.z - lhs.z * rhs.y,
            lhs.w * rhs.y + lhs.y * rhs.w + lhs.z * rhs.x - lhs.x * rhs.z,
            lhs.w * rhs.z + lhs.z * rhs.w + lhs.x * rhs.y - lhs.y * rhs.x,
            lhs.w * rhs.w - lhs.x * rhs.x - lhs.y * rhs.y - lhs.z * rhs.z);

        public static Vector3 operator *(Quaternion rotation, Vector3 point)
        {
            Vector3 axis = new Vector3(rotation.x, rotation.y, rotation.z);
            Vector3 twice = 2 * Vector3.Cross(axis, point);
            return point + rotation.w * twice + Vector3.Cross(axis, twice);
        }

        /// <summary>Approximate, as Unity's is; q and −q differ.</summary>
        public static bool operator ==(Quaternion lhs, Quaternion rhs) => Dot(lhs, rhs) > 0.999999f;

        public static bool operator !=(Quaternion lhs, Quaternion rhs) => !(lhs == rhs);

        public static float Dot(Quaternion a, Quaternion b) => a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;

        /// <summary>Scales to length one; the identity for length zero.</summary>
        public static Quaternion Normalize(Quaternion q)
        {
            float length = (float)Math.Sqrt(Dot(q, q));
            return length < Mathf.Epsilon ? identity : new Quaternion(q.x / length, q.y / length, q.z / length, q.w / length);
        }

        /// <summary>The inverse of a rotation of length one.</summary>
        public static Quaternion Inverse(Quaternion rotation) => new Quaternion(-rotation.x, -rotation.y, -rotation.z, rotation.w);

        /// <summary>The rotation by an angle in degrees; the identity where the axis has no length.</summary>
        public static Quaternion AngleAxis(float angle, Vector3 axis)
        {
            double half = angle * Math.PI / 360, length = Math.Sqrt((double)axis.x * axis.x + (double)axis.y * axis.y + (double)axis.z * axis.z);
            if (length == 0)
                return identity;

            double sine = Math.Sin(half) / length;
            return new Quaternion((float)(axis.x * sine), (float)(axis.y * sine), (float)(axis.z * sine), (float)Math.Cos(half));
        }

        /// <summary>Degrees: about z first, then x, then y, all axes of the world.</summary>
        public static Quaternion Euler(float x, float y, float z) => AngleAxis(y, Vector3.up) * AngleAxis(x, Vector3.right) * AngleAxis(z, Vector3.forward);

        public static Quaternion Euler(Vector3 euler) => Euler(euler.x, euler.y, euler.z);

        public static Quaternion LookRotation(Vector3 forward) => LookRotation(forward, Vector3.up);

        public static Quaternion LookRotation(Vector3 forward, Vector3 upwards) => Turns.LookRotation(forward, upwards);

        public static Quaternion FromToRotation(Vector3 fromDirection, Vector3 toDirection) => Turns.Between(fromDirection, toDirection);

        public static Quaternion Slerp(Quaternion a, Quaternion b, float t) => SlerpUnclamped(a, b, Mathf.Clamp01(t));

        public static Quaternion SlerpUnclamped(Quaternion a, Quaternion b, float t) => Turns.Slerp(a, b, t);

        public static Quaternion Lerp(Quaternion a, Quaternion b, float t) => LerpUnclamped(a, b, Mathf.Clamp01(t));

        public static Quaternion LerpUnclamped(Quaternion a, Quaternion b, float t) => Turns.Mix(a, b, 1 - t, Dot(a, b) < 0 ? -t : t);

        public static Quaternion RotateTowards(Quaternion from, Quaternion to, float maxDegreesDelta)
        {
            float angle = Angle(from, to);
            return angle == 0 ? to : SlerpUnclamped(from, to, Mathf.Min(1, maxDegreesDelta / angle));
        }

        /// <summary>The angle between two orientations, degrees; 0 where == holds.</summary>
        public static float Angle(Quaternion a, Quaternion b)
        {
            float cosine = Mathf.Min(Mathf.Abs(Dot(a, b)), 1);
            return cosine > 1 - kEpsilon ? 0 : Mathf.Acos(cosine) * 2 * Mathf.Rad2Deg;
        }

        public void ToAngleAxis(out float angle, out Vector3 axis)
        {
            Quaternion q = normalized;
            angle = 2 * Mathf.Acos(Mathf.Clamp(q.w, -1, 1)) * Mathf.Rad2Deg;
            Vector3 part = new Vector3(q.x, q.y, q.z);
            axis = part.magnitude > kEpsilon ? part / part.magnitude : Vector3.right;
        }

        public void Set(float newX, float newY, float newZ, float newW) => this = new Quaternion(newX, newY, newZ, newW);

        public void SetFromToRotation(Vector3 fromDirection, Vector3 toDirection) => this = FromToRotation(fromDirection, toDirection);

        public void SetLookRotation(Vector3 view) => this = LookRotation(view);

        public void Normalize() => this = Normalize(this);

        public bool Equals(Quaternion other) => x == other.x && y == other.y && z == other.z && w == other.w;

        public override bool Equals(object other) => other is Quaternion quaternion && Equals(quaternion);

        public override int GetHashCode() => x.GetHashCode() ^ (y.GetHashCode() << 2) ^ (z.GetHashCode() >> 2) ^ (w.GetHashCode() >> 1);

        public override string ToString() => ToString(null);

        public string ToString(string format) => Numbers.List(format, Numbers.OfQuaternion, x, y, z, w);
    }
}
