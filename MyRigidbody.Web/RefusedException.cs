namespace RigidBodyDynamics.Web;

/// <summary>An error that the user must correct first; its message is one line for the user.</summary>
internal sealed class RefusedException(string message) : Exception(message);
