using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab;

/// <summary>A scene whose true motion is known.</summary>
/// <param name="Scene">Converted by <see cref="StepFree"/>.</param>
/// <param name="Truth">Its motion.</param>
/// <param name="IsSolved">True if the motion was computed elsewhere, to 20 digits; false if by our own integrators.</param>
internal sealed record CostMotion(SceneDescription Scene, Truth Truth, bool IsSolved)
{
    /// <summary>The source of the true motion, in words.</summary>
    public string Origin => IsSolved
        ? "true motion: solved to 20 digits"
        : FormattableString.Invariant($"true motion: our own, with shorter and shorter steps until it converged; uncertainty {Truth.Uncertainty:0.0e+0}");

    /// <summary>The motion of a scene file.</summary>
    public static CostMotion Of(string path, Action<double> report)
    {
        SceneDescription scene = SceneReader.Read(path).Scene;
        try
        {
            return new CostMotion(StepFree.Of(scene), Truth.Of(scene, report), IsSolved: false);
        }
        catch (ArgumentException refused)
        {
            throw new InputException($"{path}: {refused.Message}");
        }
    }
}
