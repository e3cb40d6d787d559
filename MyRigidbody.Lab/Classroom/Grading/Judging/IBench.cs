namespace RigidBodyDynamics.Lab.Grading.Judging;

/// <summary>Where judges come from.</summary>
internal interface IBench
{
    /// <summary>Changes whenever the same script could be judged differently: a name of a folder.</summary>
    string Version { get; }

    /// <summary>The text that all students were given.</summary>
    string Starter { get; }

    /// <summary>A judge for one thread.</summary>
    IScriptJudge NewJudge();
}
