using SkiaSharp;

namespace RigidBodyDynamics.Lab.Animation;

/// <summary>A close-up of a body: a box in its orientation with its arrows, in a part of the picture.</summary>
internal static class Stage
{
    // the camera: from the front, a little from the right and above
    private const double Turn = 0.5, Tilt = 0.35, Distance = 4.5;

    // the corners of each face, and the outward normal's axis and side
    private static readonly (int[] Corners, int Axis, int Side)[] Faces =
    [
        ([0, 2, 6, 4], 0, -1), ([1, 5, 7, 3], 0, 1),
        ([0, 4, 5, 1], 1, -1), ([2, 3, 7, 6], 1, 1),
        ([0, 1, 3, 2], 2, -1), ([4, 6, 7, 5], 2, 1),
    ];

    public static SKColor Spin { get; } = SKColor.Parse("#2c7a3f");

    /// <summary>The color of L, which is dashed.</summary>
    public static SKColor Momentum { get; } = SKColor.Parse("#7a3fa0");

    /// <summary>Draws a body.</summary>
    /// <param name="canvas">The canvas.</param>
    /// <param name="frame">The place in the picture.</param>
    /// <param name="edges">The edges of the box, m.</param>
    /// <param name="axes">Takes the box's axes to world axes.</param>
    /// <param name="color">The colour of its sides.</param>
    /// <param name="spin">ω as a part of its greatest length in the run.</param>
    /// <param name="momentum">L as a part of its greatest length in the run.</param>
    public static void Draw(SKCanvas canvas, SKRect frame, Vector3d edges, Quaterniond axes, SKColor color, Vector3d spin, Vector3d momentum)
    {
        double size = edges.Length;
        SKPoint[] corners = [.. Enumerable.Range(0, 8).Select(i => Project(frame, axes.Rotate(Corner(edges / size, i))))];
        Vector3d eye = Eye();
        foreach ((int[] face, int axis, int side) in Faces)
        {
            Vector3d normal = axes.Rotate(side * Unit(axis));
            double half = 0.5 * (axis == 0 ? edges.X : axis == 1 ? edges.Y : edges.Z) / size;
            // a face that points away from the camera is hidden, because a box is convex
            if (Vector3d.Dot(normal, eye - half * normal) <= 0)
                continue;

            using SKPath path = new();
            path.AddPoly([.. face.Select(corner => corners[corner])]);
            double light = 0.8 + 0.2 * Vector3d.Dot(normal, new Vector3d(-0.36, 0.8, -0.48));
            using SKPaint fill = new() { Color = Shaded(color, light), IsAntialias = true };
            using SKPaint line = new() { Color = SKColors.Black.WithAlpha(160), Style = SKPaintStyle.Stroke, StrokeWidth = 1, IsAntialias = true };
            canvas.DrawPath(path, fill);
            canvas.DrawPath(path, line);
        }

        Arrow(canvas, frame, 0.75 * momentum, Momentum, [5, 4]);
        Arrow(canvas, frame, 0.6 * spin, Spin, null);
    }

    private static void Arrow(SKCanvas canvas, SKRect frame, Vector3d along, SKColor color, float[]? dashes)
    {
        if (along.Length < 0.02)
            return;

        using SKPaint line = new() { Color = color, StrokeWidth = 2.5f, Style = SKPaintStyle.Stroke, IsAntialias = true };
        line.PathEffect = dashes == null ? null : SKPathEffect.CreateDash(dashes, 0);
        using SKPaint tip = new() { Color = color, IsAntialias = true };
        SKPoint end = Project(frame, along);
        canvas.DrawLine(Project(frame, Vector3d.Zero), end, line);
        canvas.DrawCircle(end, 4, tip);
    }

    // Unity's axes are left-handed: x to the right, y up, z away from the camera
    private static SKPoint Project(SKRect frame, Vector3d p)
    {
        double x = Math.Cos(Turn) * p.X - Math.Sin(Turn) * p.Z, z = Math.Sin(Turn) * p.X + Math.Cos(Turn) * p.Z;
        double y = Math.Cos(Tilt) * p.Y + Math.Sin(Tilt) * z, depth = Distance - Math.Sin(Tilt) * p.Y + Math.Cos(Tilt) * z;
        double scale = 0.62 * Math.Min(frame.Width, frame.Height) * Distance / depth;
        return new SKPoint((float)(frame.MidX + scale * x), (float)(frame.MidY - scale * y));
    }

    private static Vector3d Eye() => new(
        -Distance * Math.Cos(Tilt) * Math.Sin(Turn), Distance * Math.Sin(Tilt), -Distance * Math.Cos(Tilt) * Math.Cos(Turn));

    private static Vector3d Corner(Vector3d edges, int i) =>
        Vector3d.Scale(edges, new Vector3d((i & 1) - 0.5, ((i >> 1) & 1) - 0.5, ((i >> 2) & 1) - 0.5));

    private static Vector3d Unit(int axis) => new(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);

    private static SKColor Shaded(SKColor color, double light) =>
        new((byte)(light * color.Red), (byte)(light * color.Green), (byte)(light * color.Blue));
}
