using System.Numerics;
using SkiaSharp;

namespace RigidBodyDynamics.UnityFiles.Drawing;

/// <summary>A scene as its camera sees it, by the formula of the package's own shader.</summary>
public static class Picture
{
    /// <summary>Size of the picture, pixels.</summary>
    public const int Width = 1280, Height = 720;

    // the first that is installed is taken
    private static readonly string[] SansFonts = ["DejaVu Sans", "Liberation Sans", "Noto Sans", "Segoe UI", "Helvetica", "Arial"];
    private static readonly SKColor Ink = new(0xc8, 0xcc, 0xd4);

    /// <summary>The part of the window that the panel covers: its margin and its width, where the window is 720 pixels high.</summary>
    public static SKRect Panel { get; } = SKRect.Create(8, 8, 250, Height - 16);

    /// <summary>The bodies alone.</summary>
    public static SKBitmap Bodies(DrawnScene scene)
    {
        Canvas canvas = new(Width, Height, scene.View.Background);
        foreach (DrawnCube cube in scene.Cubes)
        {
            foreach (Vector3[] face in cube.Faces)
            {
                Vector3[] corners = [.. face.Select(corner => scene.View.Project(corner, Width, Height))];
                if (corners.All(corner => corner.Z > scene.View.Near))
                    canvas.Fill(corners, Shade(scene, cube, face));
            }
        }

        return canvas.Picture();
    }

    /// <summary>The bodies with their names, and the panel, or its place where its rows are not given.</summary>
    public static SKBitmap Annotated(DrawnScene scene, IReadOnlyList<string>? panel = null)
    {
        SKBitmap picture = Bodies(scene);
        using SKCanvas canvas = new(picture);
        using SKPaint line = new() { Color = Ink, Style = SKPaintStyle.Stroke, StrokeWidth = 1, IsAntialias = true };
        using SKPaint text = new() { Color = Ink, IsAntialias = true };
        using SKFont font = new(SKTypeface.FromFamilyName(SansFonts.FirstOrDefault(name => SKFontManager.Default.FontFamilies.Contains(name))), 16);
        canvas.DrawRect(Panel, line);
        if (panel == null)
            canvas.DrawText("panel", Panel.MidX, Panel.MidY, SKTextAlign.Center, font, text);
        else
            DrawnPanel.Draw(canvas, Panel, panel);

        foreach (DrawnCube cube in scene.Cubes.Where(cube => cube.Parent == null))
        {
            Vector2[] outline = Outline.Of(cube, scene.View, Width, Height);
            float middle = (outline.Min(p => p.X) + outline.Max(p => p.X)) / 2;
            canvas.DrawText(cube.Name, middle, outline.Max(p => p.Y) + 24, SKTextAlign.Center, font, text);
        }

        return picture;
    }

    /// <summary>Writes a PNG.</summary>
    public static void Save(SKBitmap picture, string path)
    {
        if (Path.GetDirectoryName(path) is { Length: > 0 } folder)
            Directory.CreateDirectory(folder);

        using SKData png = picture.Encode(SKEncodedImageFormat.Png, 100);
        File.WriteAllBytes(path, png.ToArray());
    }

    private static Vector3 Shade(DrawnScene scene, DrawnCube cube, Vector3[] face)
    {
        Vector3 normal = Vector3.Normalize(Vector3.Cross(face[1] - face[0], face[3] - face[0]));
        Vector3 outward = Vector3.Dot(normal, face[0] - cube.Center) < 0 ? -normal : normal;
        return cube.Color * scene.Shading.At(outward);
    }
}
