using RigidBodyDynamics.Judging;

namespace RigidBodyDynamics.StudentScripts.Comments;

/// <summary>Which line of a script is which of the five steps.</summary>
/// <param name="assignments">What is assigned where.</param>
internal sealed class StepLines(IReadOnlyList<Assignment> assignments)
{
    private static readonly string[] Velocities = ["v", "velocity", "vel", "linearvelocity", "speed", "velo"], AngularVelocities = ["w", "omega", "ω", "angularvelocity", "angvel", "av"];

    /// <summary>The line; null where none is seen.</summary>
    public int? Of(Step step) => step switch
    {
        Step.Velocity => Assigned(Velocities, damps: false),
        Step.AngularVelocity => Assigned(AngularVelocities, damps: false),
        Step.Position => Last(Assignment.Position),
        Step.Orientation => Last(Assignment.Rotation),
        Step.Damping => Assigned([.. Velocities, .. AngularVelocities], damps: true),
        _ => null,
    };

    private int? Assigned(string[] names, bool damps) => assignments
        .FirstOrDefault(assignment => assignment.Damps == damps && names.Contains(assignment.Name.Replace("_", string.Empty, StringComparison.Ordinal).ToLowerInvariant()))?.Line;

    private int? Last(string name) => assignments.LastOrDefault(assignment => assignment.Name == name)?.Line;
}
