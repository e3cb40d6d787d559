using System.Text;

namespace RigidBodyDynamics.Fuzz;

/// <summary>Input that is not written by mistake: numbers, texts and values that break readers.</summary>
internal static class Hostile
{
    /// <summary>Numbers, and texts that are almost numbers.</summary>
    public static readonly string[] Numbers =
    [
        "0", "-0", "-0.0", "1", "-1", "0.5", "1e-6", "1e6", "1e9", "1.0000001e9", "1e18", "1e19", "1e100", "1e150", "1e155", "1e200", "-1e200", "1e308",
        "-1e308", "1.7976931348623157e308", "1e999", "-1e999", "1e-100", "1e-150", "1e-155", "1e-200", "1e-308", "5e-324", "-5e-324", "1e-400", "1e38",
        "1e39", "1e-45", "1e-46", "2147483647", "2147483648", "4294967296", "9223372036854775807", "9223372036854775808", "-9223372036854775808",
        "18446744073709551616", "1e99999999999999999999", "1e-99999999999999999999", new string('9', 400), "0." + new string('0', 400) + "1",
        "00", "1.", "+1", ".5", "0x10", "1e", "1e+", "--1", "1,5", "NaN", "Infinity", "-Infinity", "1_000", "١",
    ];

    /// <summary>Texts, in quotes.</summary>
    public static readonly string[] Texts =
    [
        "\"\"", "\" \"", "\"../../x\"", "\"..\\\\..\\\\x\"", "\"/etc/x\"", "\"C:\\\\x\"", "\"con\"", "\"nul.json\"", "\"a/b\"", "\"~\"", "\"\\u0000\"", "\"\\ud800\"",
        "\"\\udfff\\ud800\"", "\"\\ud83d\\ude00\"", "\"刚体\"", "\"\u202Eabc\"", "\"a\\nb\\r\\u2028c\"", "\"[red]\"", "\"</svg><script>\"", "\"%s%n{0}\"", "\"\\\"\"",
        "\"a,b\"", "\"\uFEFF\"", "\"\\x\"", "\"",
        "\"\\u001b[31m\"", "\"\\u009b2J\"", "\"a\\nerror: forged\"", "\"\\r\\u0007\"", "\"\\u2066\\u2069\\u200f\"", "\"\\udb40\\udc41\"", "\"\\ufeffa\"", "\"=1+1\"", "\"'=1\"", "\"@SUM(A1)\"",
        "\"+cmd|' /C calc'!A1\"", "\"-5\"", "\"＝1\"", "\"a;=1+1\"", "\"\\\\u0041\"", $"\"{new string('x', 1000)}\"", $"\"{new string('x', 1001)}\"",
        "'a'", "\"\\u12\"", $"\"{new string('x', 300)}\"", $"\"{new string('界', 5000)}\"",
    ];

    /// <summary>Values of the wrong shape.</summary>
    public static readonly string[] Shapes =
    [
        "null", "true", "false", "[]", "{}", "[[]]", "[{}]", "{\"\":0}", "[null]", "[1]", "[1,2]", "[1,2,3,4,5]", "[0,0,0]", "[1e200,1e200,1e200]", "[1e-200,1e-200,1e-200]",
        "[0,0,0,0]", "[[0,0,0]]", "[[1,0,0],[0,1,0],[0,0,1]]", "{\"a\":1,\"a\":2}", Nested('[', ']', 60), Nested('[', ']', 64), Nested('[', ']', 65), Nested('[', ']', 5000),
        Repeated("{\"a\":", "1", "}", 64), Repeated("{\"a\":", "1", "}", 2000), new string('[', 3000), "/* */", "//", "nul", "tru", ",", ":", "}", "]", "",
    ];

    /// <summary>Bytes that are not UTF-8, or text of another kind.</summary>
    public static readonly byte[][] Bytes =
    [
        [0], [0xFF], [0xFE, 0xFF], [0xC0, 0x80], [0xC0, 0xAF], [0xE0, 0x80, 0xAF], [0xF0, 0x80, 0x80, 0xAF], [0xED, 0xA0, 0x80], [0xF4, 0x90, 0x80, 0x80], [0xC3],
        [0xE2, 0x82], [0xEF, 0xBB, 0xBF], [0x1A], [0x0C], [0x0D], [0x85], [0xE2, 0x80, 0xA8], [0x7F],
    ];

    /// <summary>Ways to write the text so that another reader gets the same text.</summary>
    public static readonly Func<byte[], byte[]>[] Encodings =
    [
        json => Written(json, Encoding.Unicode), json => Written(json, Encoding.BigEndianUnicode), json => Written(json, Encoding.UTF32), json => Written(json, Encoding.UTF8),
        json => [.. Encoding.UTF8.Preamble, .. Encoding.UTF8.Preamble, .. json],
        json => Encoding.Unicode.GetBytes(Encoding.UTF8.GetString(json)), json => Encoding.Latin1.GetBytes(Encoding.UTF8.GetString(json)),
        json => Encoding.UTF8.GetBytes(Encoding.UTF8.GetString(json).Replace("\n", "\r\n", StringComparison.Ordinal)),
        json => Encoding.UTF8.GetBytes(Encoding.UTF8.GetString(json).Replace("\n", "\r", StringComparison.Ordinal)),
        json => [], json => [.. json, .. json], json => [.. json, 0], json => new byte[json.Length],
    ];

    private static byte[] Written(byte[] json, Encoding encoding) =>
        [.. encoding.Preamble, .. encoding.GetBytes(Encoding.UTF8.GetString(json))];

    private static string Nested(char open, char close, int depth) => new string(open, depth) + new string(close, depth);

    private static string Repeated(string open, string inside, string close, int depth) =>
        string.Concat(Enumerable.Repeat(open, depth)) + inside + string.Concat(Enumerable.Repeat(close, depth));
}
