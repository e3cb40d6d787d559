using System.Numerics;

namespace RigidBodyDynamics.UnityFiles.Shading;

/// <summary>How bright our shader shows a surface, with the numbers that stand in its text.</summary>
/// <param name="ToLight">The way to the light, of length 1.</param>
/// <param name="Darkest">What is left of a colour on the far side.</param>
/// <param name="Lightest">And on the side of the light.</param>
public sealed record MattShading(Vector3 ToLight, float Darkest, float Lightest)
{
    public static MattShading Of(ShaderFile shader) => new(shader.Direction("ToLight"), shader.Constant("Darkest"), shader.Constant("Lightest"));

    /// <summary>What a colour is multiplied with, where a surface looks along its normal: half Lambert, squared.</summary>
    public float At(Vector3 normal)
    {
        float facing = 0.5f + 0.5f * Vector3.Dot(normal, ToLight);
        return Darkest + (Lightest - Darkest) * facing * facing;
    }
}
