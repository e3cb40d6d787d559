using RigidBodyDynamics.Lab.Languages;

namespace RigidBodyDynamics.Lab.Report;

/// <summary>A body as it is drawn: what it looks like, and where it was at every moment of a page.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Mass">What energy and momentum are computed with.</param>
/// <param name="Shape">The solid box of these moments is drawn; Unity's, of a body that is made of vertices.</param>
internal sealed record Track(string Name, MassProperties Mass, MassProperties Shape)
{
    // a plate or a needle has edges of length 0, which nobody would see
    private const double Thinnest = 0.02;

    /// <summary>The name in each language; null where it is the same in all.</summary>
    public Word? Names { get; init; }

    /// <summary>One for each moment.</summary>
    public List<BodyState> States { get; } = [];

    /// <summary>Of the solid box that has this mass and these moments, along the principal axes, m: a² = 6 (I₂ + I₃ − I₁) / m.</summary>
    public Vector3d Edges
    {
        get
        {
            Vector3d i = Shape.PrincipalMoments;
            double sum = i.X + i.Y + i.Z, largest = Math.Max(i.X, Math.Max(i.Y, i.Z));
            // first to a size that can be neither too large nor too small for a square root
            Vector3d edges = new(Edge(sum - 2 * i.X, largest), Edge(sum - 2 * i.Y, largest), Edge(sum - 2 * i.Z, largest));
            return Math.Sqrt(6) * Math.Sqrt(largest) / Math.Sqrt(Shape.Mass) * edges;
        }
    }

    private static double Edge(double twice, double largest) => Math.Max(Thinnest, Math.Sqrt(Math.Max(0, twice / largest)));
}

/// <summary>How far two of the bodies are apart, at every moment of a page.</summary>
/// <param name="First">Which body.</param>
/// <param name="Second">Which other.</param>
/// <param name="Distance">m.</param>
/// <param name="Angle">rad.</param>
internal sealed record Distances(int First, int Second, IReadOnlyList<double> Distance, IReadOnlyList<double> Angle)
{
    /// <summary>How far apart the angular velocities are, rad/s, where a page shows it.</summary>
    public IReadOnlyList<double>? Spin { get; init; }
}

/// <summary>Something that acts for a part of the time; keys of the lab are drawn as keys.</summary>
/// <param name="Name">A key of the lab, or the effect in words.</param>
/// <param name="IsKey">True for a key of the lab.</param>
/// <param name="From">s.</param>
/// <param name="To">s.</param>
internal sealed record Held(string Name, bool IsKey, double From, double To);
