using System.Text;

namespace RigidBodyDynamics.StudentScripts;

/// <summary>Text in the encodings of editors on Windows, Chinese and others.</summary>
public static class SourceText
{
    private static readonly UTF8Encoding StrictUtf8 = new(encoderShouldEmitUTF8Identifier: false, throwOnInvalidBytes: true);

    static SourceText() => Encoding.RegisterProvider(CodePagesEncodingProvider.Instance);

    /// <summary>GB18030, of which GBK and GB2312 are parts.</summary>
    public static Encoding Gbk => Encoding.GetEncoding("GB18030");

    /// <summary>The text, and the name of its encoding: by its byte order mark, else UTF-8 where it is valid, else GBK.</summary>
    public static (string Text, string Encoding) Decode(byte[] bytes)
    {
        if (bytes is [0xEF, 0xBB, 0xBF, ..])
            return (Encoding.UTF8.GetString(bytes, 3, bytes.Length - 3), "UTF-8");
        if (bytes is [0xFF, 0xFE, ..])
            return (Encoding.Unicode.GetString(bytes, 2, bytes.Length - 2), "UTF-16");
        if (bytes is [0xFE, 0xFF, ..])
            return (Encoding.BigEndianUnicode.GetString(bytes, 2, bytes.Length - 2), "UTF-16");
        if (Zeros(bytes, 1) > bytes.Length / 8)
            return (Encoding.Unicode.GetString(bytes), "UTF-16");
        if (Zeros(bytes, 0) > bytes.Length / 8)
            return (Encoding.BigEndianUnicode.GetString(bytes), "UTF-16");

        try
        {
            return (StrictUtf8.GetString(bytes), "UTF-8");
        }
        catch (DecoderFallbackException)
        {
            return (Gbk.GetString(bytes), "GBK");
        }
    }

    // without a mark: in UTF-16 every other byte of a program's ASCII is zero
    private static int Zeros(byte[] bytes, int from)
    {
        int zeros = 0;
        for (int i = from; i < bytes.Length; i += 2)
        {
            if (bytes[i] == 0)
                zeros++;
        }

        return zeros;
    }
}
