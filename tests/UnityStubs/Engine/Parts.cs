namespace UnityEngine
{
    /// <summary>Looks at the scene.</summary>
    public sealed class Camera : Behaviour { }

    /// <summary>Lights it.</summary>
    public sealed class Light : Behaviour { }

    /// <summary>Hears it.</summary>
    public sealed class AudioListener : Behaviour { }

    /// <summary>Draws an object.</summary>
    public class Renderer : Component
    {
        public bool enabled { get; set; } = true;
    }

    /// <summary>Draws a mesh.</summary>
    public class MeshRenderer : Renderer { }

    /// <summary>Holds a mesh.</summary>
    public sealed class MeshFilter : Component
    {
        public Mesh sharedMesh { get; set; }
    }

    /// <summary>What physics touches.</summary>
    public class Collider : Component
    {
        public bool enabled { get; set; } = true;
    }

    /// <summary>A box that physics touches, before the object's scale.</summary>
    public class BoxCollider : Collider
    {
        public Vector3 center { get; set; } = Vector3.zero;

        public Vector3 size { get; set; } = Vector3.one;
    }
}
