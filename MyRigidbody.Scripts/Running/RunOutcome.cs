using RigidBodyDynamics.Judging;

namespace RigidBodyDynamics.StudentScripts.Running;

/// <summary>The result of running a script: its recording, or why it was stopped.</summary>
internal sealed record RunOutcome(Recording? Recording, Finding? Stopped);
