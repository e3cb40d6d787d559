namespace RigidBodyDynamics.Lab.Output;

/// <summary>A comparison or check with a negative result: exit code 1. The message is one whole line.</summary>
internal sealed class FellShortException(string message) : Exception(Visible.Line(message));
