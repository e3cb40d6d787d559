using ScottPlot;

namespace RigidBodyDynamics.Lab;

/// <summary>Finds places for labels at which they cover neither each other nor lines and points.</summary>
/// <param name="limits">The limits of the axes.</param>
internal sealed class LabelPlaces(AxisLimits limits)
{
    /// <summary>The font size of the labels, pixels.</summary>
    public const float FontSize = 12;

    // about the size of the picture between the axes and the legend, pixels; then a letter, a line and a marker
    private const double Width = 690, Height = 620, Letter = 7.2, Line = 16, Beside = 10, Marker = 6;

    private readonly List<PixelRect> _taken = [];

    /// <summary>Keeps labels away from a line through some points.</summary>
    public void Avoid(IReadOnlyList<Coordinates> line)
    {
        for (int i = 0; i < line.Count; i++)
        {
            Coordinates from = line[Math.Max(0, i - 1)];
            int count = (int)(1 + (Math.Abs(X(line[i].X) - X(from.X)) / Marker));
            for (int part = 0; part < count; part++)
            {
                double share = (double)part / count;
                double x = X(line[i].X + (share * (from.X - line[i].X))), y = Y(line[i].Y + (share * (from.Y - line[i].Y)));
                _taken.Add(Box(x - Marker, x + Marker, y, Marker));
            }
        }
    }

    /// <summary>The middle of the left edge of a label for a point: beside it, or else above it, as near as is free.</summary>
    public Coordinates Next(Coordinates point, string text)
    {
        double left = X(point.X) + Beside;
        for (double y = Y(point.Y); ; y += Line / 4)
        {
            PixelRect box = Box(left, left + (Letter * text.Length), y, Line / 2);
            if (!_taken.Any(other => other.Left < box.Right && box.Left < other.Right && other.Top < box.Bottom && box.Top < other.Bottom))
            {
                _taken.Add(box);
                return new Coordinates(limits.Left + (left / Width * limits.HorizontalSpan), limits.Bottom + (y / Height * limits.VerticalSpan));
            }
        }
    }

    private static PixelRect Box(double left, double right, double middle, double half) =>
        new((float)left, (float)right, (float)(middle + half), (float)(middle - half));

    private double X(double x) => (x - limits.Left) / limits.HorizontalSpan * Width;

    private double Y(double y) => (y - limits.Bottom) / limits.VerticalSpan * Height;
}
