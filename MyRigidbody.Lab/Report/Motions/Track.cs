using RigidBodyDynamics.Lab.Languages;

namespace RigidBodyDynamics.Lab.Report;

/// <summary>A body as drawn: its shape, and its states at the moments of a page.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Mass">For energy and momentum.</param>
/// <param name="Shape">The solid box with these moments is drawn; for a body of vertices Unity's.</param>
internal sealed record Track(string Name, MassProperties Mass, MassProperties Shape)
{
    // a plate or a needle has edges of length 0, which would be invisible
    private const double Thinnest = 0.02;

    /// <summary>The name in each language; null where it is the same in both.</summary>
    public Word? Names { get; init; }

    /// <summary>One state for each moment.</summary>
    public List<BodyState> States { get; } = [];

    /// <summary>The edges of the solid box with this mass and these moments, along the principal axes, m: a² = 6 (I₂ + I₃ − I₁) / m.</summary>
    public Vector3d Edges
    {
        get
        {
            Vector3d i = Shape.PrincipalMoments;
            double sum = i.X + i.Y + i.Z, largest = Math.Max(i.X, Math.Max(i.Y, i.Z));
            // scaled first, so that the argument of the square root neither overflows nor underflows
            Vector3d edges = new(Edge(sum - 2 * i.X, largest), Edge(sum - 2 * i.Y, largest), Edge(sum - 2 * i.Z, largest));
            return Math.Sqrt(6) * Math.Sqrt(largest) / Math.Sqrt(Shape.Mass) * edges;
        }
    }

    private static double Edge(double twice, double largest) => Math.Max(Thinnest, Math.Sqrt(Math.Max(0, twice / largest)));
}

/// <summary>The difference of two bodies, at every moment of a page.</summary>
/// <param name="First">The number of the one.</param>
/// <param name="Second">The number of the other.</param>
/// <param name="Distance">m.</param>
/// <param name="Angle">rad.</param>
internal sealed record Distances(int First, int Second, IReadOnlyList<double> Distance, IReadOnlyList<double> Angle)
{
    /// <summary>The difference of the angular velocities, rad/s, where a page shows it.</summary>
    public IReadOnlyList<double>? Spin { get; init; }
}

/// <summary>An effect that acts for a part of the time; keys of the lab are drawn as keys.</summary>
/// <param name="Name">A key of the lab, or the effect in words.</param>
/// <param name="IsKey">True for a key of the lab.</param>
/// <param name="From">s.</param>
/// <param name="To">s.</param>
internal sealed record Held(string Name, bool IsKey, double From, double To);
