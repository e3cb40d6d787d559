#if !UNITY_5_3_OR_NEWER
using System;
using System.Collections.Generic;
using System.Globalization;

namespace RigidBodyDynamics
{
    /// <summary>Tests whether triangles form a closed surface: every edge belongs to two of them, which run along it in opposite directions.</summary>
    internal static class MeshEdges
    {
        private const string Rule = "must be a closed surface, whose every edge is in two triangles, once in each direction, and ";

        /// <summary>Refuses an open surface with an edge that shows it: its two points, and its triangles, counted from 1.</summary>
        public static void MustBeClosed(IReadOnlyList<Vector3d> vertices, IReadOnlyList<int> triangles)
        {
            if (triangles.Count == 0 || triangles.Count % 3 != 0)
                throw Refused("must have three corners each, found " + triangles.Count + " numbers of vertices");

            // each edge: its lower vertex, its higher vertex, and the corner from which a triangle runs along it
            long[] edges = new long[triangles.Count];
            int[] corners = new int[triangles.Count];
            for (int i = 0; i < edges.Length; i++)
            {
                int from = triangles[i], to = triangles[Next(i)];
                if (from < 0 || from >= vertices.Count)
                    throw Refused("must be numbers of vertices from 0 to " + (vertices.Count - 1) + ", found " + from + " in triangle " + (i / 3 + 1));

                if (from == to)
                    throw Refused("must have three different corners, and triangle " + (i / 3 + 1) + " has " + vertices[from] + " twice");

                edges[i] = ((long)Math.Min(from, to) << 32) | (uint)Math.Max(from, to);
                corners[i] = i;
            }

            Array.Sort(edges, corners);
            int faults = 0, worst = 0, worstEnd = 0, lowest = int.MaxValue;
            for (int first = 0, end; first < edges.Length; first = end)
            {
                for (end = first + 1; end < edges.Length && edges[end] == edges[first];)
                    end++;

                if (end - first == 2 && Rises(triangles, corners[first]) != Rises(triangles, corners[first + 1]))
                    continue;

                faults++;
                int corner = Lowest(corners, first, end);
                if (corner < lowest)
                {
                    lowest = corner;
                    worst = first;
                    worstEnd = end;
                }
            }

            if (faults > 0)
                throw Refused(Rule + Fault(vertices, triangles, corners, worst, worstEnd) + (faults > 1 ? "; " + (faults - 1) + " more edges are like that" : string.Empty));
        }

        /// <summary>The corners of a triangle.</summary>
        public static string Triangle(IReadOnlyList<Vector3d> vertices, IReadOnlyList<int> triangles, int index) =>
            vertices[triangles[3 * index]] + " " + vertices[triangles[3 * index + 1]] + " " + vertices[triangles[3 * index + 2]];

        /// <summary>A number in four digits.</summary>
        public static string Text(double number) => number.ToString("G4", CultureInfo.InvariantCulture);

        public static ArgumentException Refused(string rule) => new MeshException(rule);

        private static string Fault(IReadOnlyList<Vector3d> vertices, IReadOnlyList<int> triangles, int[] corners, int first, int end)
        {
            int[] sharing = new int[end - first];
            Array.Copy(corners, first, sharing, 0, sharing.Length);
            Array.Sort(sharing);
            string edge = "the edge from " + vertices[triangles[sharing[0]]] + " to " + vertices[triangles[Next(sharing[0])]], one = " triangle " + (sharing[0] / 3 + 1);
            switch (sharing.Length)
            {
                case 1: return edge + " is in" + one + " alone: the surface is open there";
                case 2: return edge + " is run along in the same direction by" + one + " and triangle " + (sharing[1] / 3 + 1) + ": one of them is turned over";
                default: return edge + " is in " + sharing.Length + " triangles, the first of them" + one + ": parts that touch along an edge are not one surface";
            }
        }

        private static int Next(int corner) => corner % 3 == 2 ? corner - 2 : corner + 1;

        private static bool Rises(IReadOnlyList<int> triangles, int corner) => triangles[corner] < triangles[Next(corner)];

        private static int Lowest(int[] corners, int first, int end)
        {
            int lowest = corners[first];
            for (int i = first + 1; i < end; i++)
                lowest = Math.Min(lowest, corners[i]);

            return lowest;
        }

        /// <summary>The message alone, without the lines that the runtime would add.</summary>
        private sealed class MeshException : ArgumentException
        {
            private readonly string _line;

            public MeshException(string rule) : base(rule, "triangles") => _line = "triangles: " + rule;

            public override string Message => _line;
        }
    }
}
#endif
