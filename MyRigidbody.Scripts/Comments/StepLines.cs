using RigidBodyDynamics.Judging;

namespace RigidBodyDynamics.StudentScripts.Comments;

/// <summary>The line of each of the five steps in a script: by the variable it assigns, and by common names of velocities.</summary>
internal static class StepLines
{
    private static readonly string[] Velocities = ["v", "velocity", "vel", "linearvelocity", "linvel", "speed", "velo", "sudu", "速度"];
    private static readonly string[] AngularVelocities = ["w", "omega", "ω", "angularvelocity", "angvel", "angularvel", "av", "jiaosudu", "角速度"];

    /// <summary>The lines of those steps that are found.</summary>
    public static IReadOnlyDictionary<Step, int> Of(IReadOnlyList<Assignment> assignments)
    {
        Dictionary<Step, int> lines = [];
        Add(Step.Velocity, assignments.FirstOrDefault(one => !one.Damps && Velocities.Contains(Plain(one))));
        Add(Step.AngularVelocity, assignments.FirstOrDefault(one => !one.Damps && AngularVelocities.Contains(Plain(one))));
        Add(Step.Position, assignments.LastOrDefault(one => one.Name == Assignment.Position));
        Add(Step.Orientation, assignments.FirstOrDefault(one => one.Name == Assignment.PureQuaternion) ?? assignments.LastOrDefault(one => one.Name == Assignment.Rotation));
        Add(Step.Damping, assignments.FirstOrDefault(one => one.Damps && (Velocities.Contains(Plain(one)) || AngularVelocities.Contains(Plain(one)))));
        return lines;

        void Add(Step step, Assignment? found)
        {
            if (found != null)
                lines[step] = found.Line;
        }
    }

    private static string Plain(Assignment assignment) => assignment.Name.Replace("_", string.Empty, StringComparison.Ordinal).ToLowerInvariant();
}
