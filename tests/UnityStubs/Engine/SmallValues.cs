namespace UnityEngine
{
    /// <summary>Two floats.</summary>
    public struct Vector2
    {
        public float x;
        public float y;

        public Vector2(float x, float y)
        {
            this.x = x;
            this.y = y;
        }

        public static Vector2 zero => new Vector2(0, 0);
    }

    /// <summary>A rectangle of the screen, from its upper left corner.</summary>
    public struct Rect
    {
        public Rect(float x, float y, float width, float height)
        {
            this.x = x;
            this.y = y;
            this.width = width;
            this.height = height;
        }

        public float x { get; set; }

        public float y { get; set; }

        public float width { get; set; }

        public float height { get; set; }
    }

    /// <summary>Red, green, blue and opacity, 0 to 1.</summary>
    public struct Color
    {
        public float r;
        public float g;
        public float b;
        public float a;

        public Color(float r, float g, float b, float a)
        {
            this.r = r;
            this.g = g;
            this.b = b;
            this.a = a;
        }

        public Color(float r, float g, float b) : this(r, g, b, 1) { }

        public static Color white => new Color(1, 1, 1);

        public static Color red => new Color(1, 0, 0);

        public static Color green => new Color(0, 1, 0);

        public static Color blue => new Color(0, 0, 1);

        public static Color magenta => new Color(1, 0, 1);

        // as Unity has it
        public static Color yellow => new Color(1, 0.92156863f, 0.015686275f);
    }

    /// <summary>Of a 4 × 4 matrix what a scaling needs.</summary>
    public struct Matrix4x4
    {
        public float m00;
        public float m11;
        public float m22;
        public float m33;

        public static Matrix4x4 identity => Scale(Vector3.one);

        public static Matrix4x4 Scale(Vector3 vector) => new Matrix4x4 { m00 = vector.x, m11 = vector.y, m22 = vector.z, m33 = 1 };
    }

    /// <summary>Functions of floats; Unity computes them in double.</summary>
    public static class Mathf
    {
        public const float PI = (float)System.Math.PI;

        public static float Abs(float f) => System.Math.Abs(f);

        public static float Cos(float f) => (float)System.Math.Cos(f);

        public static float Max(float a, float b) => a > b ? a : b;

        public static float Min(float a, float b) => a < b ? a : b;

        public static float Sin(float f) => (float)System.Math.Sin(f);

        public static float Sqrt(float f) => (float)System.Math.Sqrt(f);
    }
}
