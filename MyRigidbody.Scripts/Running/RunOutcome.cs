using RigidBodyDynamics.Judging;

namespace RigidBodyDynamics.StudentScripts.Running;

/// <summary>What came of a script that was run: what was seen, or why it was stopped.</summary>
internal sealed record RunOutcome(Recording? Recording, Finding? Stopped);
