namespace RigidBodyDynamics.Lab.Inertia.Robots;

/// <summary>A geometry that is left out: it is not understood, or its mesh cannot be read. This is a note and not an error of the description.</summary>
internal sealed class OmittedException(string message) : Exception(message);
