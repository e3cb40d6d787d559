using System;

namespace UnityEngine
{
    /// <summary>A 4 × 4 matrix of floats. A single index goes down the columns: m00, m10, m20, m30, m01 …</summary>
    public struct Matrix4x4 : IEquatable<Matrix4x4>
    {
        public float m00, m10, m20, m30;
        public float m01, m11, m21, m31;
        public float m02, m12, m22, m32;
        public float m03, m13, m23, m33;

        public Matrix4x4(Vector4 column0, Vector4 column1, Vector4 column2, Vector4 column3)
        {
            m00 = column0.x; m10 = column0.y; m20 = column0.z; m30 = column0.w;
            m01 = column1.x; m11 = column1.y; m21 = column1.z; m31 = column1.w;
            m02 = column2.x; m12 = column2.y; m22 = column2.z; m32 = column2.w;
            m03 = column3.x; m13 = column3.y; m23 = column3.z; m33 = column3.w;
        }

        public static Matrix4x4 zero => default(Matrix4x4);

        public static Matrix4x4 identity => Scale(Vector3.one);

        public Matrix4x4 transpose => new Matrix4x4(
            new Vector4(m00, m01, m02, m03), new Vector4(m10, m11, m12, m13), new Vector4(m20, m21, m22, m23), new Vector4(m30, m31, m32, m33));

        /// <summary>The zero matrix where there is no inverse.</summary>
        public Matrix4x4 inverse => Elimination.Inverse(this);

        public float determinant => (float)Elimination.Determinant(this);

        public bool isIdentity => this == identity;

        /// <summary>Its rotation.</summary>
        public Quaternion rotation
        {
            get
            {
                Vector3 x = GetColumn(0), y = GetColumn(1), z = GetColumn(2);
                return Turns.OfAxes(x.normalized * Mathf.Sign(determinant), y.normalized, z.normalized);
            }
        }

        /// <summary>Its scale.</summary>
        public Vector3 lossyScale =>
            new Vector3(((Vector3)GetColumn(0)).magnitude * Mathf.Sign(determinant), ((Vector3)GetColumn(1)).magnitude, ((Vector3)GetColumn(2)).magnitude);

        public float this[int row, int column]
        {
            get => this[Place(row, column)];
            set => this[Place(row, column)] = value;
        }

        public float this[int index]
        {
            get
            {
                switch (index)
                {
                    case 0: return m00;
                    case 1: return m10;
                    case 2: return m20;
                    case 3: return m30;
                    case 4: return m01;
                    case 5: return m11;
                    case 6: return m21;
                    case 7: return m31;
                    case 8: return m02;
                    case 9: return m12;
                    case 10: return m22;
                    case 11: return m32;
                    case 12: return m03;
                    case 13: return m13;
                    case 14: return m23;
                    case 15: return m33;
                    default: throw NoSuchIndex();
                }
            }

            set
            {
                switch (index)
                {
                    case 0: m00 = value; break;
                    case 1: m10 = value; break;
                    case 2: m20 = value; break;
                    case 3: m30 = value; break;
                    case 4: m01 = value; break;
                    case 5: m11 = value; break;
                    case 6: m21 = value; break;
                    case 7: m31 = value; break;
                    case 8: m02 = value; break;
                    case 9: m12 = value; break;
                    case 10: m22 = value; break;
                    case 11: m32 = value; break;
                    case 12: m03 = value; break;
                    case 13: m13 = value; break;
                    case 14: m23 = value; break;
                    case 15: m33 = value; break;
                    default: throw NoSuchIndex();
                }
            }
        }

        public static Matrix4x4 operator *(Matrix4x4 lhs, Matrix4x4 rhs) => new Matrix4x4
        {
            m00 = lhs.m00 * rhs.m00 + lhs.m01 * rhs.m10 + lhs.m02 * rhs.m20 + lhs.m03 * rhs.m30,
            m01 = lhs.m00 * rhs.m01 + lhs.m01 * rhs.m11 + lhs.m02 * rhs.m21 + lhs.m03 * rhs.m31,
            m02 = lhs.m00 * rhs.m02 + lhs.m01 * rhs.m12 + lhs.m02 * rhs.m22 + lhs.m03 * rhs.m32,
            m03 = lhs.m00 * rhs.m03 + lhs.m01 * rhs.m13 + lhs.m02 * rhs.m23 + lhs.m03 * rhs.m33,
            m10 = lhs.m10 * rhs.m00 + lhs.m11 * rhs.m10 + lhs.m12 * rhs.m20 + lhs.m13 * rhs.m30,
            m11 = lhs.m10 * rhs.m01 + lhs.m11 * rhs.m11 + lhs.m12 * rhs.m21 + lhs.m13 * rhs.m31,
            m12 = lhs.m10 * rhs.m02 + lhs.m11 * rhs.m12 + lhs.m12 * rhs.m22 + lhs.m13 * rhs.m32,
            m13 = lhs.m10 * rhs.m03 + lhs.m11 * rhs.m13 + lhs.m12 * rhs.m23 + lhs.m13 * rhs.m33,
            m20 = lhs.m20 * rhs.m00 + lhs.m21 * rhs.m10 + lhs.m22 * rhs.m20 + lhs.m23 * rhs.m30,
            m21 = lhs.m20 * rhs.m01 + lhs.m21 * rhs.m11 + lhs.m22 * rhs.m21 + lhs.m23 * rhs.m31,
            m22 = lhs.m20 * rhs.m02 + lhs.m21 * rhs.m12 + lhs.m22 * rhs.m22 + lhs.m23 * rhs.m32,
            m23 = lhs.m20 * rhs.m03 + lhs.m21 * rhs.m13 + lhs.m22 * rhs.m23 + lhs.m23 * rhs.m33,
            m30 = lhs.m30 * rhs.m00 + lhs.m31 * rhs.m10 + lhs.m32 * rhs.m20 + lhs.m33 * rhs.m30,
            m31 = lhs.m30 * rhs.m01 + lhs.m31 * rhs.m11 + lhs.m32 * rhs.m21 + lhs.m33 * rhs.m31,
            m32 = lhs.m30 * rhs.m02 + lhs.m31 * rhs.m12 + lhs.m32 * rhs.m22 + lhs.m33 * rhs.m32,
            m33 = lhs.m30 * rhs.m03 + lhs.m31 * rhs.m13 + lhs.m32 * rhs.m23 + lhs.m33 * rhs.m33,
        };

        public static Vector4 operator *(Matrix4x4 lhs, Vector4 vector) => new Vector4(
            lhs.m00 * vector.x + lhs.m01 * vector.y + lhs.m02 * vector.z + lhs.m03 * vector.w,
            lhs.m10 * vector.x + lhs.m11 * vector.y + lhs.m12 * vector.z + lhs.m13 * vector.w,
            lhs.m20 * vector.x + lhs.m21 * vector.y + lhs.m22 * vector.z + lhs.m23 * vector.w,
            lhs.m30 * vector.x + lhs.m31 * vector.y + lhs.m32 * vector.z + lhs.m33 * vector.w);

        public static bool operator ==(Matrix4x4 lhs, Matrix4x4 rhs) =>
            lhs.GetColumn(0) == rhs.GetColumn(0) && lhs.GetColumn(1) == rhs.GetColumn(1) && lhs.GetColumn(2) == rhs.GetColumn(2) && lhs.GetColumn(3) == rhs.GetColumn(3);

        public static bool operator !=(Matrix4x4 lhs, Matrix4x4 rhs) => !(lhs == rhs);

        public static Matrix4x4 Scale(Vector3 vector) => new Matrix4x4 { m00 = vector.x, m11 = vector.y, m22 = vector.z, m33 = 1 };

        public static Matrix4x4 Translate(Vector3 vector) => TRS(vector, Quaternion.identity, Vector3.one);

        /// <summary>The matrix of a quaternion; a rotation only if the length is one.</summary>
        public static Matrix4x4 Rotate(Quaternion q)
        {
            float x = q.x * 2, y = q.y * 2, z = q.z * 2;
            float xx = q.x * x, yy = q.y * y, zz = q.z * z, xy = q.x * y, xz = q.x * z, yz = q.y * z, wx = q.w * x, wy = q.w * y, wz = q.w * z;
            return new Matrix4x4(
                new Vector4(1 - (yy + zz), xy + wz, xz - wy, 0),
                new Vector4(xy - wz, 1 - (xx + zz), yz + wx, 0),
                new Vector4(xz + wy, yz - wx, 1 - (xx + yy), 0),
                new Vector4(0, 0, 0, 1));
        }

        /// <summary>Scale, then rotation, then translation.</summary>
        public static Matrix4x4 TRS(Vector3 pos, Quaternion q, Vector3 s)
        {
            Matrix4x4 turn = Rotate(q);
            return new Matrix4x4(turn.GetColumn(0) * s.x, turn.GetColumn(1) * s.y, turn.GetColumn(2) * s.z, new Vector4(pos.x, pos.y, pos.z, 1));
        }

        public static Matrix4x4 Inverse(Matrix4x4 m) => m.inverse;

        public static Matrix4x4 Transpose(Matrix4x4 m) => m.transpose;

        public static float Determinant(Matrix4x4 m) => m.determinant;

        public Vector4 GetColumn(int index) => new Vector4(this[0, Line(index)], this[1, index], this[2, index], this[3, index]);

        public Vector4 GetRow(int index) => new Vector4(this[Line(index), 0], this[index, 1], this[index, 2], this[index, 3]);

        public void SetColumn(int index, Vector4 column)
        {
            for (int row = 0; row < 4; row++)
                this[row, Line(index)] = column[row];
        }

        public void SetRow(int index, Vector4 row)
        {
            for (int column = 0; column < 4; column++)
                this[Line(index), column] = row[column];
        }

        public void SetTRS(Vector3 pos, Quaternion q, Vector3 s) => this = TRS(pos, q, s);

        public Vector3 GetPosition() => new Vector3(m03, m13, m23);

        /// <summary>Transforms a point, with projection.</summary>
        public Vector3 MultiplyPoint(Vector3 point)
        {
            Vector4 moved = this * new Vector4(point.x, point.y, point.z, 1);
            float scale = 1 / moved.w;
            return new Vector3(moved.x * scale, moved.y * scale, moved.z * scale);
        }

        /// <summary>Transforms a point; the last row is taken as 0, 0, 0, 1.</summary>
        public Vector3 MultiplyPoint3x4(Vector3 point) => this * new Vector4(point.x, point.y, point.z, 1);

        /// <summary>Transforms a direction, without translation.</summary>
        public Vector3 MultiplyVector(Vector3 vector) => this * (Vector4)vector;

        public bool Equals(Matrix4x4 other) =>
            GetColumn(0).Equals(other.GetColumn(0)) && GetColumn(1).Equals(other.GetColumn(1)) && GetColumn(2).Equals(other.GetColumn(2)) && GetColumn(3).Equals(other.GetColumn(3));

        public override bool Equals(object other) => other is Matrix4x4 matrix && Equals(matrix);

        public override int GetHashCode() =>
            GetColumn(0).GetHashCode() ^ (GetColumn(1).GetHashCode() << 2) ^ (GetColumn(2).GetHashCode() >> 2) ^ (GetColumn(3).GetHashCode() >> 1);

        public override string ToString() => string.Join("\n", Row(0), Row(1), Row(2), Row(3)) + "\n";

        private string Row(int row) => string.Format(
            System.Globalization.CultureInfo.InvariantCulture, "{0:F5}\t{1:F5}\t{2:F5}\t{3:F5}", this[row, 0], this[row, 1], this[row, 2], this[row, 3]);

        private static int Line(int index) => index >= 0 && index < 4 ? index : throw NoSuchIndex();

        // as in Unity, where row 5 of column 0 is row 1 of column 1
        private static int Place(int row, int column) => row + column * 4;

        private static IndexOutOfRangeException NoSuchIndex() => new IndexOutOfRangeException("Invalid matrix index!");
    }
}
