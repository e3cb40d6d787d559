using System;
using System.Linq;
using RigidBodyDynamics.Engine;

namespace UnityEngine
{
    /// <summary>A camera along the z axis of the scene.</summary>
    public sealed class Camera : Behaviour
    {
        /// <summary>The first that is enabled and has the tag MainCamera; null if there is none.</summary>
        public static Camera main =>
            World.Objects.Where(o => o.tag == "MainCamera").Select(o => o.GetComponent<Camera>()).FirstOrDefault(camera => camera != null && camera.isActiveAndEnabled);

        public float fieldOfView { get; set; } = 60;

        /// <summary>Pixels from the lower left, and the distance in front of the camera.</summary>
        public Vector3 WorldToScreenPoint(Vector3 position)
        {
            Vector3 seen = Quaternion.Inverse(transform.rotation) * (position - transform.position);
            float perMetre = (float)(0.5 * Screen.height / Math.Tan(fieldOfView * Math.PI / 360)) / seen.z;
            return new Vector3(0.5f * Screen.width + perMetre * seen.x, 0.5f * Screen.height + perMetre * seen.y, seen.z);
        }
    }

    /// <summary>A light.</summary>
    public sealed class Light : Behaviour { }

    /// <summary>A listener.</summary>
    public sealed class AudioListener : Behaviour { }

    /// <summary>The renderer of an object.</summary>
    public class Renderer : Component
    {
        public bool enabled { get; set; } = true;

        public Material material { get; set; } = new Material();

        public Material sharedMaterial { get => material; set => material = value; }
    }

    /// <summary>The look of a surface.</summary>
    public class Material : Object
    {
        public Color color { get; set; } = Color.white;
    }

    /// <summary>The renderer of a mesh.</summary>
    public class MeshRenderer : Renderer { }

    /// <summary>The mesh of an object.</summary>
    public sealed class MeshFilter : Component
    {
        private Mesh _own;

        /// <summary>The mesh that all its users share.</summary>
        public Mesh sharedMesh { get; set; }

        /// <summary>A copy for this object alone, created at the first access.</summary>
        public Mesh mesh
        {
            get => _own ?? (_own = sharedMesh == null ? new Mesh() : sharedMesh = sharedMesh.Copy());
            set => _own = sharedMesh = value;
        }
    }

    /// <summary>A shape for collisions.</summary>
    public class Collider : Component
    {
        public bool enabled { get; set; } = true;
    }

    /// <summary>A box for collisions, before the object's scale.</summary>
    public class BoxCollider : Collider
    {
        public Vector3 center { get; set; } = Vector3.zero;

        public Vector3 size { get; set; } = Vector3.one;
    }
}
