using System.Numerics;

namespace RigidBodyDynamics.Tests;

/// <summary>A closed surface for tests, and what it encloses in whole numbers, without a rounding.</summary>
internal sealed record Surface(Vector3d[] Vertices, int[] Triangles)
{
    /// <summary>A box about the origin.</summary>
    public static Surface Box(Vector3d edges) => new(
        [.. Enumerable.Range(0, 8).Select(i => Vector3d.Scale(new Vector3d((i & 1) - 0.5, ((i >> 1) & 1) - 0.5, ((i >> 2) & 1) - 0.5), edges))],
        [0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5]);

    /// <summary>Four corners, the first three counter-clockwise seen from outside.</summary>
    public static Surface Tetrahedron(params Vector3d[] corners) => new(corners, [0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0]);

    /// <summary>A prism over a regular polygon in the xz plane, along y.</summary>
    public static Surface Prism(int sides, double radius, double height)
    {
        List<Vector3d> vertices = [new(0, -height / 2, 0), new(0, height / 2, 0)];
        List<int> triangles = [];
        for (int i = 0; i < sides; i++)
        {
            (double sin, double cos) = Math.SinCos(2 * Math.PI * i / sides);
            vertices.Add(new Vector3d(radius * cos, -height / 2, radius * sin));
            vertices.Add(new Vector3d(radius * cos, height / 2, radius * sin));
            int low = 2 + 2 * i, next = 2 + 2 * ((i + 1) % sides);
            triangles.AddRange([0, low, next, 1, next + 1, low + 1, low, low + 1, next + 1, low, next + 1, next]);
        }

        return new Surface([.. vertices], [.. triangles]);
    }

    /// <summary>An octahedron whose triangles are cut into four again and again, with the corners on a sphere: 8 · 4ⁿ triangles.</summary>
    public static Surface Ball(int cuts)
    {
        List<Vector3d> vertices = [new(1, 0, 0), new(0, 1, 0), new(0, 0, 1), new(-1, 0, 0), new(0, -1, 0), new(0, 0, -1)];
        List<int> triangles = [0, 1, 2, 1, 3, 2, 3, 4, 2, 4, 0, 2, 1, 0, 5, 3, 1, 5, 4, 3, 5, 0, 4, 5];
        for (int cut = 0; cut < cuts; cut++)
        {
            Dictionary<(int, int), int> halves = [];
            List<int> finer = [];
            for (int i = 0; i < triangles.Count; i += 3)
            {
                int a = triangles[i], b = triangles[i + 1], c = triangles[i + 2], ab = Half(a, b), bc = Half(b, c), ca = Half(c, a);
                finer.AddRange([a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca]);
            }

            triangles = finer;

            int Half(int p, int q)
            {
                (int, int) edge = (Math.Min(p, q), Math.Max(p, q));
                if (!halves.TryGetValue(edge, out int half))
                {
                    halves[edge] = half = vertices.Count;
                    vertices.Add((vertices[p] + vertices[q]).Normalized);
                }

                return half;
            }
        }

        return new Surface([.. vertices], [.. triangles]);
    }

    /// <summary>The same elsewhere; its corners are rounded there.</summary>
    public Surface Moved(Vector3d by) => this with { Vertices = [.. Vertices.Select(v => v + by)] };

    /// <summary>The same turned and stretched.</summary>
    public Surface Mapped(Func<Vector3d, Vector3d> map) => this with { Vertices = [.. Vertices.Select(map)] };

    /// <summary>What the corners enclose, as they are: volume, centre, and the tensor of a mass of 1 about it.</summary>
    public (double Volume, Vector3d Center, SymmetricMatrix3 Inertia) Exactly()
    {
        const int Places = 120;
        BigInteger[][] v = [.. Vertices.Select(p => new[] { Whole(p.X), Whole(p.Y), Whole(p.Z) })];
        BigInteger six = 0;
        BigInteger[] first = new BigInteger[3];
        BigInteger[,] second = new BigInteger[3, 3];
        for (int t = 0; t < Triangles.Length; t += 3)
        {
            BigInteger[] a = v[Triangles[t]], b = v[Triangles[t + 1]], c = v[Triangles[t + 2]];
            BigInteger det = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
            six += det;
            for (int i = 0; i < 3; i++)
            {
                first[i] += det * (a[i] + b[i] + c[i]);
                for (int j = 0; j <= i; j++)
                    second[i, j] += det * ((a[i] + b[i] + c[i]) * (a[j] + b[j] + c[j]) + a[i] * a[j] + b[i] * b[j] + c[i] * c[j]);
            }
        }

        // in units of 2^-120 m: ∫xᵢxⱼ/V − cᵢcⱼ = (4 D Q − 5 F F) / (80 D²)
        double Central(int i, int j) => Ratio(4 * six * second[i, j] - 5 * first[i] * first[j], (80 * six * six) << (2 * Places));
        double xx = Central(0, 0), yy = Central(1, 1), zz = Central(2, 2);
        return (
            Ratio(six, (BigInteger)6 << (3 * Places)),
            new Vector3d(Ratio(first[0], (4 * six) << Places), Ratio(first[1], (4 * six) << Places), Ratio(first[2], (4 * six) << Places)),
            new SymmetricMatrix3 { XX = yy + zz, YY = xx + zz, ZZ = xx + yy, XY = -Central(1, 0), XZ = -Central(2, 0), YZ = -Central(2, 1) });

        static BigInteger Whole(double x)
        {
            // a finite double is a whole number of 2^-1074; those of tests are of 2^-120
            long bits = BitConverter.DoubleToInt64Bits(x), mantissa = bits & 0xFFFFFFFFFFFFF;
            int exponent = (int)((bits >> 52) & 0x7FF);
            if (exponent == 0)
                return x == 0 ? 0 : throw new ArgumentOutOfRangeException(nameof(x));

            int shift = exponent - 1075 + Places;
            BigInteger whole = (mantissa | (1L << 52)) * (BigInteger)Math.Sign(x);
            return shift >= 0 ? whole << shift
                : (whole & ((BigInteger.One << -shift) - 1)).IsZero ? whole >> -shift
                : throw new ArgumentOutOfRangeException(nameof(x));
        }

        static double Ratio(BigInteger over, BigInteger under)
        {
            int shift = (int)(under.GetBitLength() - over.GetBitLength()) + 64;
            BigInteger quotient = (shift >= 0 ? over << shift : over >> -shift) / under;
            return Math.ScaleB((double)quotient, -shift);
        }
    }
}
