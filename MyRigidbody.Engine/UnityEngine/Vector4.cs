using System;

namespace UnityEngine
{
    /// <summary>Four floats.</summary>
    public struct Vector4 : IEquatable<Vector4>
    {
        private const float SameSquare = 9.99999944E-11f;

        public float x;
        public float y;
        public float z;
        public float w;

        public Vector4(float x, float y, float z, float w)
        {
            this.x = x;
            this.y = y;
            this.z = z;
            this.w = w;
        }

        public Vector4(float x, float y, float z) : this(x, y, z, 0) { }

        public Vector4(float x, float y) : this(x, y, 0, 0) { }

        public static Vector4 zero => new Vector4(0, 0, 0, 0);

        public static Vector4 one => new Vector4(1, 1, 1, 1);

        public float sqrMagnitude => Dot(this, this);

        public float magnitude => (float)Math.Sqrt(sqrMagnitude);

        public Vector4 normalized => Normalize(this);

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
                    default: throw new IndexOutOfRangeException("Invalid Vector4 index!");
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
                    default: throw new IndexOutOfRangeException("Invalid Vector4 index!");
                }
            }
        }

        public static implicit operator Vector4(Vector3 v) => new Vector4(v.x, v.y, v.z, 0);

        public static implicit operator Vector3(Vector4 v) => new Vector3(v.x, v.y, v.z);

        public static implicit operator Vector4(Vector2 v) => new Vector4(v.x, v.y, 0, 0);

        public static implicit operator Vector2(Vector4 v) => new Vector2(v.x, v.y);

        public static Vector4 operator +(Vector4 a, Vector4 b) => new Vector4(a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w);

        public static Vector4 operator -(Vector4 a, Vector4 b) => new Vector4(a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w);

        public static Vector4 operator -(Vector4 a) => new Vector4(-a.x, -a.y, -a.z, -a.w);

        public static Vector4 operator *(Vector4 a, float d) => new Vector4(a.x * d, a.y * d, a.z * d, a.w * d);

        public static Vector4 operator *(float d, Vector4 a) => a * d;

        public static Vector4 operator /(Vector4 a, float d) => new Vector4(a.x / d, a.y / d, a.z / d, a.w / d);

        public static bool operator ==(Vector4 lhs, Vector4 rhs) => (lhs - rhs).sqrMagnitude < SameSquare;

        public static bool operator !=(Vector4 lhs, Vector4 rhs) => !(lhs == rhs);

        public static float Dot(Vector4 a, Vector4 b) => a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;

        public static float Distance(Vector4 a, Vector4 b) => (a - b).magnitude;

        public static float Magnitude(Vector4 a) => a.magnitude;

        public static Vector4 Scale(Vector4 a, Vector4 b) => new Vector4(a.x * b.x, a.y * b.y, a.z * b.z, a.w * b.w);

        public static Vector4 Lerp(Vector4 a, Vector4 b, float t) => a + (b - a) * Mathf.Clamp01(t);

        public static Vector4 Normalize(Vector4 a)
        {
            float length = a.magnitude;
            return length > Vector3.kEpsilon ? a / length : zero;
        }

        public void Set(float newX, float newY, float newZ, float newW) => this = new Vector4(newX, newY, newZ, newW);

        public void Normalize() => this = Normalize(this);

        public bool Equals(Vector4 other) => x == other.x && y == other.y && z == other.z && w == other.w;

        public override bool Equals(object other) => other is Vector4 vector && Equals(vector);

        public override int GetHashCode() => x.GetHashCode() ^ (y.GetHashCode() << 2) ^ (z.GetHashCode() >> 2) ^ (w.GetHashCode() >> 1);

        public override string ToString() => ToString(null);

        public string ToString(string format) => Numbers.List(format, Numbers.OfVector, x, y, z, w);
    }
}
