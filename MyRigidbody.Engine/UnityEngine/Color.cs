namespace UnityEngine
{
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

        public static Color black => new Color(0, 0, 0);

        public static Color red => new Color(1, 0, 0);

        public static Color green => new Color(0, 1, 0);

        public static Color blue => new Color(0, 0, 1);

        public static Color cyan => new Color(0, 1, 1);

        public static Color magenta => new Color(1, 0, 1);

        public static Color gray => new Color(0.5f, 0.5f, 0.5f);

        public static Color grey => gray;

        public static Color clear => new Color(0, 0, 0, 0);

        // as Unity has it
        public static Color yellow => new Color(1, 0.92156863f, 0.015686275f);

        public static Color operator *(Color a, float b) => new Color(a.r * b, a.g * b, a.b * b, a.a * b);

        public static Color Lerp(Color a, Color b, float t)
        {
            float part = Mathf.Clamp01(t);
            return new Color(a.r + (b.r - a.r) * part, a.g + (b.g - a.g) * part, a.b + (b.b - a.b) * part, a.a + (b.a - a.a) * part);
        }
    }
}
