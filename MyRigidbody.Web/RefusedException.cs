namespace RigidBodyDynamics.Web;

/// <summary>What the user must mend first; its message is the one line that he reads.</summary>
internal sealed class RefusedException(string message) : Exception(message);
