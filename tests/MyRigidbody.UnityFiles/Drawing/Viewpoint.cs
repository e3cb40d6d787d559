using System.Numerics;

namespace RigidBodyDynamics.UnityFiles.Drawing;

/// <summary>A camera of Unity's: it points along its own z, y is up and x to the right, so its axes are left-handed.</summary>
/// <param name="Position">Its position.</param>
/// <param name="Rotation">Its orientation.</param>
/// <param name="FieldOfView">The angle between the picture's upper and lower edge, degrees.</param>
/// <param name="Near">Nearer points are not drawn.</param>
/// <param name="Background">Red, green and blue of the background, 0 to 1.</param>
public sealed record Viewpoint(Vector3 Position, Quaternion Rotation, float FieldOfView, float Near, Vector3 Background)
{
    /// <summary>Where a point is in a picture: pixels from the left and from the top, and its distance along the camera's z.</summary>
    public Vector3 Project(Vector3 point, int width, int height)
    {
        Vector3 seen = Vector3.Transform(point - Position, Quaternion.Conjugate(Rotation));
        float pixels = height / (2 * MathF.Tan(FieldOfView * MathF.PI / 360)) / seen.Z;
        return new Vector3(width / 2f + pixels * seen.X, height / 2f - pixels * seen.Y, seen.Z);
    }
}
