using System.Globalization;
using System.Linq;

namespace UnityEngine
{
    /// <summary>The engine's text of the numbers of a value.</summary>
    internal static class Numbers
    {
#if UNITY_2021_2_OR_NEWER || EVERY_UNITY
        public const string OfVector = "F2", OfQuaternion = "F5";
#else
        public const string OfVector = "F1", OfQuaternion = "F1";
#endif

        /// <summary>In brackets, separated by commas.</summary>
        public static string List(string format, string usual, params float[] numbers) =>
            "(" + string.Join(", ", numbers.Select(number => number.ToString(string.IsNullOrEmpty(format) ? usual : format, CultureInfo.InvariantCulture))) + ")";
    }
}
