#if !UNITY_5_3_OR_NEWER
using System;
using System.Collections.Generic;

namespace RigidBodyDynamics
{
    public static partial class Solids
    {
        /// <summary>The homogeneous solid inside a closed surface of triangles, with a given mass; the mesh gives its centre of mass.</summary>
        /// <param name="mass">kg, above zero.</param>
        /// <param name="vertices">In the body frame, m.</param>
        /// <param name="triangles">
        /// Three vertex numbers a triangle, counter-clockwise seen from outside. Every edge belongs to two triangles, which run along it in
        /// opposite directions; any other mesh is refused with the edge.
        /// </param>
        /// <remarks>
        /// Signed tetrahedra from a point to every triangle, as in B. Mirtich, "Fast and accurate computation of polyhedral mass properties",
        /// Journal of Graphics Tools 1(2), 1996. The sums are compensated and taken about the middle of the mesh, then about its centre of
        /// mass, so that neither a million triangles nor a place far from the origin costs digits. Self-intersection is not tested: what
        /// the surface encloses twice counts twice, and a surface turned inwards encloses a hollow.
        /// </remarks>
        public static MassProperties Mesh(double mass, IReadOnlyList<Vector3d> vertices, IReadOnlyList<int> triangles)
        {
            Guard.Positive(mass, nameof(mass));
            return new ClosedMesh(vertices, triangles).Weighing(mass);
        }

        /// <summary>The homogeneous solid inside a closed surface, with a given density, kg/m³.</summary>
        /// <param name="density">kg/m³, above zero; with 1 the mass is the volume.</param>
        /// <param name="vertices">As for <see cref="Mesh"/>.</param>
        /// <param name="triangles">As for <see cref="Mesh"/>.</param>
        public static MassProperties MeshOfDensity(double density, IReadOnlyList<Vector3d> vertices, IReadOnlyList<int> triangles)
        {
            Guard.Positive(density, nameof(density));
            ClosedMesh mesh = new ClosedMesh(vertices, triangles);
            return mesh.Weighing(density * mesh.Volume);
        }
    }

    /// <summary>Volume, centre and moments of the solid inside a closed surface.</summary>
    internal sealed class ClosedMesh
    {
        // a solid thinner than this part of its half extent cannot be distinguished from a sheet: its corners are rounded to 1e-16
        private const double Thinnest = 1e-14;

        private readonly IReadOnlyList<Vector3d> _vertices;
        private readonly IReadOnlyList<int> _triangles;
        private readonly Vector3d _middle, _center;
        private readonly double _unit, _volume6;

        public ClosedMesh(IReadOnlyList<Vector3d> vertices, IReadOnlyList<int> triangles)
        {
            _vertices = Guard.NotNull(vertices, nameof(vertices));
            _triangles = Guard.NotNull(triangles, nameof(triangles));
            for (int i = 0; i < vertices.Count; i++)
                Guard.Finite(vertices[i], nameof(vertices), i);

            MeshEdges.MustBeClosed(vertices, triangles);
            Vector3d low = vertices[triangles[0]], high = low;
            foreach (int i in triangles)
            {
                Vector3d v = vertices[i];
                low = new Vector3d(Math.Min(low.X, v.X), Math.Min(low.Y, v.Y), Math.Min(low.Z, v.Z));
                high = new Vector3d(Math.Max(high.X, v.X), Math.Max(high.Y, v.Y), Math.Max(high.Z, v.Z));
            }

            Vector3d half = Guard.Finite(0.5 * (high - low), "extent of the vertices");
            _middle = low + half;
            _unit = PowerOfTwoFrom(Math.Max(half.X, Math.Max(half.Y, half.Z)));
            double lost = 0, area = 0;
            Vector3d moment = Vector3d.Zero, lostMoment = Vector3d.Zero;
            for (int i = 0; i < triangles.Count; i += 3)
            {
                double six = Six(i, Vector3d.Zero, out Vector3d a, out Vector3d b, out Vector3d c);
                RunningSum.Add(ref _volume6, ref lost, six);
                RunningSum.Add(ref moment, ref lostMoment, six * (a + b + c));
                area += Vector3d.Cross(b - a, c - a).Length;
            }

            if (!(Math.Abs(_volume6) > Thinnest * area))
                throw MeshEdges.Refused("must enclose a volume, and this surface is flat, or its parts take away as much as they add");

            if (_volume6 < 0)
            {
                throw MeshEdges.Refused("must run counter-clockwise seen from outside, and this whole surface is inside out, its volume "
                    + MeshEdges.Text(Volume) + ": exchange two corners of every triangle, as in triangle 1, " + MeshEdges.Triangle(vertices, triangles, 0));
            }

            _center = moment / (4 * _volume6);
        }

        /// <summary>m³.</summary>
        public double Volume => _volume6 / 6 * _unit * _unit * _unit;

        /// <summary>The mass properties of the solid with a given mass.</summary>
        public MassProperties Weighing(double mass)
        {
            // summed about the centre of mass: moments about another point, moved there afterwards, would lose digits
            Vector3d square = Vector3d.Zero, lostSquare = Vector3d.Zero, product = Vector3d.Zero, lostProduct = Vector3d.Zero;
            for (int i = 0; i < _triangles.Count; i += 3)
            {
                double six = Six(i, _center, out Vector3d a, out Vector3d b, out Vector3d c);
                SymmetricMatrix3 sum = SymmetricMatrix3.Outer(a + b + c) + SymmetricMatrix3.Outer(a) + SymmetricMatrix3.Outer(b) + SymmetricMatrix3.Outer(c);
                RunningSum.Add(ref square, ref lostSquare, six * sum.Diagonal);
                RunningSum.Add(ref product, ref lostProduct, six * sum.OffDiagonal);
            }

            double scale = mass / (20 * _volume6) * _unit * _unit;
            return MassProperties.FromTensor(
                mass,
                scale * new SymmetricMatrix3(new Vector3d(square.Y + square.Z, square.X + square.Z, square.X + square.Y), -product),
                _middle + _unit * _center);
        }

        // six times the signed volume of the tetrahedron from a point to a triangle, and its corners relative to the point
        private double Six(int first, Vector3d from, out Vector3d a, out Vector3d b, out Vector3d c)
        {
            a = (_vertices[_triangles[first]] - _middle) / _unit - from;
            b = (_vertices[_triangles[first + 1]] - _middle) / _unit - from;
            c = (_vertices[_triangles[first + 2]] - _middle) / _unit - from;
            return Vector3d.Dot(a, Vector3d.Cross(b, c));
        }

        // division by a power of two rounds nothing
        private static double PowerOfTwoFrom(double size)
        {
            double unit = 1;
            while (unit < size)
                unit *= 2;

            while (unit > 2 * size && unit > double.Epsilon)
                unit *= 0.5;

            return unit;
        }
    }
}
#endif
