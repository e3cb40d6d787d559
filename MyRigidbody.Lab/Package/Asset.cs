namespace RigidBodyDynamics.Lab.Package;

/// <summary>A file or folder of a Unity package.</summary>
/// <param name="Path">Its path in a project: <c>Assets/MyRigidbody/...</c>, with forward slashes.</param>
/// <param name="Guid">Its name in Unity: 32 lower-case hex digits, those of its meta.</param>
/// <param name="Content">The file; null for a folder.</param>
/// <param name="Meta">Its meta.</param>
internal sealed record Asset(string Path, string Guid, byte[]? Content, byte[] Meta)
{
    public bool IsFolder => Content == null;
}
