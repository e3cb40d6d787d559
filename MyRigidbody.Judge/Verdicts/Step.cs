namespace RigidBodyDynamics.Judging
{
    /// <summary>The subject of a finding: one of the sheet's five steps, the given code, or the code around them.</summary>
    public enum Step
    {
        Given,
        Velocity,
        AngularVelocity,
        Position,
        Orientation,
        Damping,
        Code,
        Package,
        Name,
    }

    /// <summary>The mark of one step.</summary>
    public enum Mark
    {
        Right,
        Wrong,

        /// <summary>Not the sheet's formula and not a mistake either: an instructor decides.</summary>
        Doubtful,

        /// <summary>Not done.</summary>
        Missing,

        /// <summary>It could not be observed.</summary>
        Unknown,
    }

    /// <summary>The result for a script as a whole.</summary>
    public enum Outcome
    {
        Right,
        Wrong,
        Doubtful,

        /// <summary>It was not run to its end: it does not compile, is not allowed, does not end, or throws.</summary>
        Refused,
    }
}
