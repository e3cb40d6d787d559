using ScottPlot;

namespace RigidBodyDynamics.Lab;

/// <summary>Finds places for labels at which they lie neither on each other nor on points.</summary>
internal sealed class LabelPlaces
{
    // sizes in powers of ten, as the diagram of errors has them: about 100 pixels one across, 40 one down
    private const double Letter = 0.075, Line = 0.45, Beside = 0.12;

    private readonly List<(double Left, double Right, double Bottom, double Top)> _taken = [];

    /// <summary>Keeps labels away from a point.</summary>
    public void Avoid(double x, double y) => _taken.Add((x - 0.07, x + 0.07, y - 0.15, y + 0.15));

    /// <summary>The middle of the left edge of a label for a point: beside it, or else as little above as is free.</summary>
    public Coordinates Next(Coordinates point, string text)
    {
        for (int up = 0; ; up++)
        {
            double left = point.X + Beside, y = point.Y + (up * Line / 2);
            (double Left, double Right, double Bottom, double Top) box = (left, left + (Letter * text.Length), y - (Line / 2), y + (Line / 2));
            if (!_taken.Any(other => other.Left < box.Right && box.Left < other.Right && other.Bottom < box.Top && box.Bottom < other.Top))
            {
                _taken.Add(box);
                return new Coordinates(left, y);
            }
        }
    }
}
