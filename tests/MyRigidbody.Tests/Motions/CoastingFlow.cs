namespace RigidBodyDynamics.Tests;

/// <summary>The flow that a composition takes between pushes, of a whole state.</summary>
internal static class CoastingFlow
{
    public static void Advance(this in Coasting coasting, double duration, ref BodyState body)
    {
        Drift drift = new(coasting, duration);
        Vector3d xLost = Vector3d.Zero, vLost = Vector3d.Zero;
        drift.Move(ref body.Position, ref xLost, ref body.Velocity, ref vLost);
        body.AngularVelocity = drift.AngularDecay.Of(body.AngularVelocity);
    }
}
