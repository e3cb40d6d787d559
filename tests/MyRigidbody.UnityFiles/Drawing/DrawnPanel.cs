using SkiaSharp;

namespace RigidBodyDynamics.UnityFiles.Drawing;

/// <summary>The panel's rows as the stand-in for the engine drew them, in the manner of Unity's own skin.</summary>
internal static class DrawnPanel
{
    private const float RowHeight = 22, NameWidth = 110, Margin = 5, Gap = 4, TextSize = 13, Box = 12, Baseline = 15;

    private static readonly SKColor Ink = new(0xe4, 0xe6, 0xea), Face = new(0x4a, 0x50, 0x5c), Back = new(0, 0, 0, 0x60);

    // the first that is installed is taken
    private static readonly SKTypeface Plain = Installed("DejaVu Sans", "Liberation Sans", "Segoe UI", "Helvetica", "Arial");
    private static readonly SKTypeface Chinese = Installed("WenQuanYi Micro Hei", "Noto Sans CJK SC", "Microsoft YaHei", "PingFang SC");

    /// <summary>Draws as many rows as there is room for; the rest is scrolled to.</summary>
    public static void Draw(SKCanvas canvas, SKRect panel, IReadOnlyList<string> rows)
    {
        using SKPaint fill = new() { IsAntialias = true };
        canvas.Save();
        canvas.ClipRect(panel);
        fill.Color = Back;
        canvas.DrawRect(panel, fill);
        float y = panel.Top + Margin;
        foreach (string row in rows)
        {
            string[][] controls = [.. row.Split('\t').Select(control => control.Split(':', 2))];
            bool isValue = controls.Length == 2 && controls.All(control => control[0] == "label");
            float width = (panel.Width - 2 * Margin + Gap) / controls.Length - Gap;
            for (int i = 0; i < controls.Length; i++)
            {
                float left = panel.Left + Margin + i * (isValue ? NameWidth : width + Gap);
                Control(canvas, fill, controls[i][0], controls[i][1], SKRect.Create(left, y, width, RowHeight - 2));
            }

            y += RowHeight;
        }

        canvas.Restore();
    }

    private static SKTypeface Installed(params string[] names) =>
        SKTypeface.FromFamilyName(names.FirstOrDefault(name => SKFontManager.Default.FontFamilies.Contains(name)));

    private static void Control(SKCanvas canvas, SKPaint fill, string kind, string text, SKRect place)
    {
        using SKFont font = new(text.Any(letter => letter >= 0x2e80) ? Chinese : Plain, TextSize);
        bool isButton = kind.EndsWith("button", StringComparison.Ordinal);
        if (isButton)
        {
            fill.Color = Face;
            canvas.DrawRoundRect(place, 3, 3, fill);
        }
        else if (kind == "toggle")
        {
            fill.Color = Face;
            canvas.DrawRoundRect(SKRect.Create(place.Left, place.Top + 4, Box, Box), 2, 2, fill);
        }

        fill.Color = Ink;
        canvas.DrawText(
            text, isButton ? place.MidX : place.Left + (kind == "toggle" ? Box + Gap : 0), place.Top + Baseline,
            isButton ? SKTextAlign.Center : SKTextAlign.Left, font, fill);
    }
}
