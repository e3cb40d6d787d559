using System.Text;

namespace RigidBodyDynamics.Lab.Grading.Reading;

/// <summary>Text of a file in UTF-8, UTF-16 or GBK, with a byte order mark or without.</summary>
internal static class Decoded
{
    private static readonly UTF8Encoding Strict = new(false, throwOnInvalidBytes: true);

    static Decoded() => Encoding.RegisterProvider(CodePagesEncodingProvider.Instance);

    /// <summary>GBK and what is newer of it.</summary>
    public static Encoding Gbk => Encoding.GetEncoding("GB18030");

    /// <summary>The text.</summary>
    public static string Text(byte[] bytes)
    {
        // a Latin letter in UTF-16 has a zero beside it, and no text has one
        bool wide = bytes.Length > 1 && !bytes.AsSpan().StartsWith(Encoding.UTF8.Preamble);
        Encoding encoding = wide && (bytes[0], bytes[1]) is (0xff, 0xfe) || (wide && bytes[0] != 0 && bytes[1] == 0) ? Encoding.Unicode
            : wide && (bytes[0], bytes[1]) is (0xfe, 0xff) || (wide && bytes[0] == 0 && bytes[1] != 0) ? Encoding.BigEndianUnicode
            : IsUtf8(bytes) ? Strict : Gbk;
        return encoding.GetString(bytes).TrimStart('\ufeff');
    }

    /// <summary>True for what can only be read as UTF-8, or is plain ASCII.</summary>
    public static bool IsUtf8(ReadOnlySpan<byte> bytes)
    {
        try
        {
            Strict.GetCharCount(bytes);
            return true;
        }
        catch (DecoderFallbackException)
        {
            return false;
        }
    }
}
