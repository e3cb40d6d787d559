namespace RigidBodyDynamics.Tests;

/// <summary>Steps of integrations that may diverge.</summary>
internal static class Running
{
    /// <summary>True unless a body has diverged before the last of some steps.</summary>
    public static bool TryStep(this Simulation simulation, long count = 1)
    {
        try
        {
            simulation.Step(count);
            return true;
        }
        catch (StateOverflowException)
        {
            return false;
        }
    }
}
