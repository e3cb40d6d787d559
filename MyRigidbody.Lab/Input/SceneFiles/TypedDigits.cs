using System.Globalization;

namespace RigidBodyDynamics.Lab;

/// <summary>
/// The rounding error of numbers in a file. Programs write the numbers of a set with equally many decimals (%.6f) or digits (%g),
/// and some omit zeros at the end: 0.25 beside 0.333333 is 0.250000.
/// </summary>
internal static class TypedDigits
{
    // a set with fewer digits was typed and not computed
    private const int Fewest = 3;

    /// <summary>Half a unit of the last decimal of each number; zeros for a set of few digits.</summary>
    /// <param name="texts">The numbers as they are written; an empty one is not there.</param>
    public static double[] HalfUnits(params IReadOnlyList<string> texts)
    {
        Typed[] typed = [.. texts.Select(Typed.Of)];
        int digits = typed.Max(number => number.Digits), last = typed.Min(number => number.Last);
        return [.. typed.Select(number => number.Last == int.MaxValue || digits < Fewest ? 0 : 0.5 * Math.Pow(10, number.LastOf(digits, last)))];
    }

    /// <summary>The error of the moments about the axes of a frame, to first order.</summary>
    /// <param name="halfUnits">Of a tensor's elements, in its axes.</param>
    /// <param name="frame">The frame in those axes.</param>
    public static Vector3d OfMoments(SymmetricMatrix3 halfUnits, Quaterniond frame)
    {
        return new Vector3d(Off(new Vector3d(1, 0, 0)), Off(new Vector3d(0, 1, 0)), Off(new Vector3d(0, 0, 1)));

        double Off(Vector3d axis)
        {
            Vector3d f = frame.Rotate(axis), size = new(Math.Abs(f.X), Math.Abs(f.Y), Math.Abs(f.Z));
            return Vector3d.Dot(size, halfUnits * size);
        }
    }

    /// <summary>A number as written: the count of its digits from the first that is not zero, and the powers of ten of the first and the last.</summary>
    private readonly record struct Typed(int Digits, int First, int Last)
    {
        public static Typed Of(string text)
        {
            string[] parts = text.Split('e', 'E');
            int exponent = parts.Length > 1 && int.TryParse(parts[1], NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int power) ? Math.Clamp(power, -400, 400) : 0;
            string mantissa = parts[0].TrimStart('-', '+');
            int point = mantissa.IndexOf('.', StringComparison.Ordinal), decimals = point < 0 ? 0 : mantissa.Length - point - 1;
            string digits = mantissa.Replace(".", string.Empty, StringComparison.Ordinal).TrimStart('0');
            int last = exponent - decimals;
            // a zero does not show where its digits would begin, and an empty text has none
            return digits.Length > 0 ? new Typed(digits.Length, last + digits.Length - 1, last) : new Typed(0, int.MinValue / 2, text.Length > 0 ? last : int.MaxValue);
        }

        /// <summary>The power of ten of the last digit, with omitted zeros at the end, in a set with that many digits and decimals.</summary>
        public int LastOf(int digits, int last) => Math.Min(Last, Math.Max(last, First - digits + 1));
    }
}
