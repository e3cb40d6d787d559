namespace RigidBodyDynamics.Tests;

/// <summary>Mass, centre and inertia of a shape by brute force: points that fill it evenly, and sums over them.</summary>
internal static class FilledShape
{
    private const int Count = 200_000;

    /// <summary>The tensor about the origin of a shape of mass 1, given what is inside it and the box it lies in.</summary>
    public static SymmetricMatrix3 Inertia(Vector3d halfExtent, Predicate<Vector3d> inside)
    {
        int hits = 0;
        double xx = 0, yy = 0, zz = 0, yz = 0, xz = 0, xy = 0;
        for (int i = 1; i <= Count; i++)
        {
            // Halton's sequence: deterministic, and far more even than chance
            Vector3d p = new(
                halfExtent.X * (2 * Halton(i, 2) - 1), halfExtent.Y * (2 * Halton(i, 3) - 1), halfExtent.Z * (2 * Halton(i, 5) - 1));
            if (!inside(p))
                continue;
            hits++;
            xx += p.Y * p.Y + p.Z * p.Z;
            yy += p.X * p.X + p.Z * p.Z;
            zz += p.X * p.X + p.Y * p.Y;
            yz -= p.Y * p.Z;
            xz -= p.X * p.Z;
            xy -= p.X * p.Y;
        }

        return 1.0 / hits * new SymmetricMatrix3 { XX = xx, YY = yy, ZZ = zz, YZ = yz, XZ = xz, XY = xy };
    }

    /// <summary>The digits of i mirrored at the point.</summary>
    private static double Halton(int i, int b)
    {
        double result = 0, part = 1;
        for (; i > 0; i /= b)
        {
            part /= b;
            result += part * (i % b);
        }

        return result;
    }
}
