using RigidBodyDynamics.Lab.Languages;
using ScottPlot;
using SkiaSharp;

namespace RigidBodyDynamics.Lab.Output;

/// <summary>The words in pictures, in the user's language where the machine has a font for it.</summary>
internal static class PictureWords
{
    // the first one installed is used
    private static readonly string[] Western =
        ["DejaVu Sans", "Liberation Sans", "Noto Sans", "Open Sans", "Segoe UI", "Helvetica Neue", "Helvetica", "Arial", "Verdana"];

    private static readonly string[] Chinese =
        ["Noto Sans CJK SC", "Source Han Sans SC", "Microsoft YaHei", "PingFang SC", "WenQuanYi Micro Hei", "WenQuanYi Zen Hei", "SimHei", "Droid Sans Fallback"];

    private const string ChineseLetter = "转";

    private static readonly Lazy<string?> ChineseFont = new(() => Installed(Chinese) ?? AnyWith(ChineseLetter[0]));

    /// <summary>True where a picture can have Chinese text.</summary>
    public static bool HasChinese => ChineseFont.Value != null;

    /// <summary>The font of all text. What a system calls its default font may have serifs.</summary>
    public static string Font => (Language.IsChinese ? ChineseFont.Value : null) ?? Installed(Western) ?? Fonts.Default;

    /// <summary>What stands in a picture in English, in the user's language.</summary>
    public static string Say(string english) => HasChinese ? Language.Say(english) : english;

    private static string? Installed(string[] names) => names.FirstOrDefault(name => SKFontManager.Default.FontFamilies.Contains(name));

    private static string? AnyWith(char letter)
    {
        using SKTypeface? face = SKFontManager.Default.MatchCharacter(letter);
        return face?.FamilyName is { Length: > 0 } name ? name : null;
    }
}
