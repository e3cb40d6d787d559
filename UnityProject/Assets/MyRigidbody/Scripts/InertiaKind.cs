using System;
using UnityEngine;

namespace RigidBodyDynamics.Scripts
{
    /// <summary>The source of a body's inertia.</summary>
    public enum InertiaKind
    {
        /// <summary>An eighth of the mass in each corner of the box: the lab's sum over vertices. Three times the solid box.</summary>
        LabVertices,

        /// <summary>The solid box, as for Unity's BoxCollider.</summary>
        SolidBox,

        /// <summary>The lab's sum over all vertices of the object's own mesh.</summary>
        MeshVertices,
    }

    /// <summary>Mass and inertia of an object, at the size it has in the scene.</summary>
    internal static class InertiaOf
    {
        /// <summary>The mass properties of an object. Vertices of a mesh are unscaled, so they are scaled here.</summary>
        public static MassProperties Object(Component component, double mass, InertiaKind kind)
        {
            Vector3 size = component.transform.lossyScale;
            switch (kind)
            {
                case InertiaKind.LabVertices: return PointMasses.BoxVertices(mass, Edges(size));
                case InertiaKind.SolidBox: return Solids.Box(mass, Edges(size));
                default: return PointMasses.Equal(mass, Vertices(component, size));
            }
        }

        // a mirrored object has a scale below zero, and the same inertia
        private static Vector3d Edges(Vector3 size) => new Vector3d(Math.Abs(size.x), Math.Abs(size.y), Math.Abs(size.z));

        private static Vector3d[] Vertices(Component component, Vector3 size)
        {
            MeshFilter filter = component.GetComponent<MeshFilter>();
            if (filter == null || filter.sharedMesh == null)
                throw new ArgumentException("inertia: MeshVertices needs a MeshFilter with a mesh on the same object");

            if (!filter.sharedMesh.isReadable)
                throw new ArgumentException("inertia: the mesh '" + filter.sharedMesh.name + "' cannot be read; tick Read/Write in its import settings");

            return Array.ConvertAll(filter.sharedMesh.vertices, vertex => Vector3.Scale(vertex, size).Double());
        }
    }
}
