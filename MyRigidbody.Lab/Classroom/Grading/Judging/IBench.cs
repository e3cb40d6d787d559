namespace RigidBodyDynamics.Lab.Grading.Judging;

/// <summary>Creates judges.</summary>
internal interface IBench
{
    /// <summary>A folder name that changes whenever the same script could be judged differently.</summary>
    string Version { get; }

    /// <summary>The text that all students received.</summary>
    string Starter { get; }

    /// <summary>A judge for one thread.</summary>
    IScriptJudge NewJudge();
}
