namespace RigidBodyDynamics.Lab.Inertia.Robots;

/// <summary>A geometry that is left out: it is not understood, or its mesh cannot be had. That is no fault of the description; it is noted.</summary>
internal sealed class OmittedException(string message) : Exception(message);
