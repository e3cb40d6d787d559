namespace RigidBodyDynamics.StudentScripts;

/// <summary>One source file of a submission.</summary>
/// <param name="Name">Its name inside the submission, with forward slashes.</param>
/// <param name="Bytes">As saved, in any encoding.</param>
public sealed record ScriptFile(string Name, byte[] Bytes);
