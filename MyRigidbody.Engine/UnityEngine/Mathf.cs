using System;
using System.Linq;

namespace UnityEngine
{
    /// <summary>Functions of floats; Unity computes them in double and rounds.</summary>
    public partial struct Mathf
    {
        public const float PI = (float)Math.PI;
        public const float Infinity = float.PositiveInfinity;
        public const float NegativeInfinity = float.NegativeInfinity;
        public const float Deg2Rad = PI * 2 / 360;
        public const float Rad2Deg = 1 / Deg2Rad;

        /// <summary>The smallest number above zero.</summary>
        public static readonly float Epsilon = float.Epsilon;

        public static float Sin(float f) => (float)Math.Sin(f);

        public static float Cos(float f) => (float)Math.Cos(f);

        public static float Tan(float f) => (float)Math.Tan(f);

        public static float Asin(float f) => (float)Math.Asin(f);

        public static float Acos(float f) => (float)Math.Acos(f);

        public static float Atan(float f) => (float)Math.Atan(f);

        public static float Atan2(float y, float x) => (float)Math.Atan2(y, x);

        public static float Sqrt(float f) => (float)Math.Sqrt(f);

        public static float Pow(float f, float p) => (float)Math.Pow(f, p);

        public static float Exp(float power) => (float)Math.Exp(power);

        public static float Log(float f) => (float)Math.Log(f);

        public static float Log(float f, float p) => (float)Math.Log(f, p);

        public static float Log10(float f) => (float)Math.Log10(f);

        public static float Abs(float f) => Math.Abs(f);

        public static int Abs(int value) => Math.Abs(value);

        public static float Min(float a, float b) => a < b ? a : b;

        public static int Min(int a, int b) => a < b ? a : b;

        public static float Min(params float[] values) => values.Length == 0 ? 0 : values.Aggregate(Min);

        public static int Min(params int[] values) => values.Length == 0 ? 0 : values.Aggregate(Min);

        public static float Max(float a, float b) => a > b ? a : b;

        public static int Max(int a, int b) => a > b ? a : b;

        public static float Max(params float[] values) => values.Length == 0 ? 0 : values.Aggregate(Max);

        public static int Max(params int[] values) => values.Length == 0 ? 0 : values.Aggregate(Max);

        public static float Ceil(float f) => (float)Math.Ceiling(f);

        public static float Floor(float f) => (float)Math.Floor(f);

        /// <summary>Halves are rounded to the even neighbour.</summary>
        public static float Round(float f) => (float)Math.Round(f);

        public static int CeilToInt(float f) => (int)Math.Ceiling(f);

        public static int FloorToInt(float f) => (int)Math.Floor(f);

        public static int RoundToInt(float f) => (int)Math.Round(f);

        /// <summary>1 for zero, too.</summary>
        public static float Sign(float f) => f >= 0 ? 1 : -1;

        public static float Clamp(float value, float min, float max) => value < min ? min : value > max ? max : value;

        public static int Clamp(int value, int min, int max) => value < min ? min : value > max ? max : value;

        public static float Clamp01(float value) => Clamp(value, 0, 1);

        /// <summary>Equal within a millionth of the larger one, or within eight of the smallest numbers.</summary>
        public static bool Approximately(float a, float b) => Abs(b - a) < Max(0.000001f * Max(Abs(a), Abs(b)), Epsilon * 8);

        public static bool IsPowerOfTwo(int value) => (value & (value - 1)) == 0;

        /// <summary>The smallest power of two that is not below the value; where there is none, Unity's result.</summary>
        public static int NextPowerOfTwo(int value)
        {
            // every bit below the highest of value − 1 is set
            int bits = value - 1;
            for (int shift = 1; shift < 32; shift *= 2)
                bits |= bits >> shift;

            return bits + 1;
        }

        public static int ClosestPowerOfTwo(int value)
        {
            int above = NextPowerOfTwo(value), below = above / 2;
            return value - below < above - value ? below : above;
        }
    }
}
