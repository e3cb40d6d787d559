using System.Numerics;
using SkiaSharp;

namespace RigidBodyDynamics.UnityFiles.Drawing;

/// <summary>Filled polygons, of which the nearest is seen in every point; a pixel is the mean of nine points.</summary>
internal sealed class Canvas
{
    private const int Fine = 3;

    private readonly int _width, _height;
    private readonly Vector3[] _colors;
    private readonly float[] _nearness;

    public Canvas(int width, int height, Vector3 background)
    {
        _width = width * Fine;
        _height = height * Fine;
        _colors = new Vector3[_width * _height];
        _nearness = new float[_width * _height];
        Array.Fill(_colors, background);
    }

    /// <summary>Fills a plane convex polygon; corners are pixels from the left, from the top and depth.</summary>
    public void Fill(Vector3[] corners, Vector3 color)
    {
        for (int i = 2; i < corners.Length; i++)
            Triangle(Finer(corners[0]), Finer(corners[i - 1]), Finer(corners[i]), color);
    }

    public SKBitmap Picture()
    {
        SKBitmap picture = new(_width / Fine, _height / Fine, SKColorType.Rgba8888, SKAlphaType.Opaque);
        picture.Pixels = [.. Enumerable.Range(0, picture.Width * picture.Height).Select(i => Mean(i % picture.Width * Fine, i / picture.Width * Fine))];
        return picture;
    }

    // what is linear in a picture in perspective is one over the depth
    private static Vector3 Finer(Vector3 corner) => new(corner.X * Fine, corner.Y * Fine, 1 / corner.Z);

    private void Triangle(Vector3 a, Vector3 b, Vector3 c, Vector3 color)
    {
        float area = Cross(b - a, c - a);
        if (area == 0)
            return;

        int left = Math.Max(0, (int)MathF.Min(a.X, MathF.Min(b.X, c.X))), right = Math.Min(_width - 1, (int)MathF.Max(a.X, MathF.Max(b.X, c.X)) + 1);
        int top = Math.Max(0, (int)MathF.Min(a.Y, MathF.Min(b.Y, c.Y))), bottom = Math.Min(_height - 1, (int)MathF.Max(a.Y, MathF.Max(b.Y, c.Y)) + 1);
        for (int y = top; y <= bottom; y++)
        {
            for (int x = left; x <= right; x++)
            {
                Vector3 p = new(x + 0.5f, y + 0.5f, 0);
                float u = Cross(b - p, c - p) / area, v = Cross(c - p, a - p) / area, w = 1 - u - v;
                float nearness = u * a.Z + v * b.Z + w * c.Z;
                int at = y * _width + x;
                if (u < 0 || v < 0 || w < 0 || nearness <= _nearness[at])
                    continue;

                _nearness[at] = nearness;
                _colors[at] = color;
            }
        }
    }

    private static float Cross(Vector3 a, Vector3 b) => a.X * b.Y - a.Y * b.X;

    private SKColor Mean(int left, int top)
    {
        Vector3 sum = Vector3.Zero;
        for (int y = top; y < top + Fine; y++)
        {
            for (int x = left; x < left + Fine; x++)
                sum += _colors[y * _width + x];
        }

        Vector3 mean = Vector3.Min(sum / (Fine * Fine), Vector3.One) * 255;
        return new SKColor((byte)MathF.Round(mean.X), (byte)MathF.Round(mean.Y), (byte)MathF.Round(mean.Z));
    }
}
