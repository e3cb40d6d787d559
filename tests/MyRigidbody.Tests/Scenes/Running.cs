namespace RigidBodyDynamics.Tests;

/// <summary>Steps of rules that may run away.</summary>
internal static class Running
{
    /// <summary>True unless a body has run away before the last of some steps.</summary>
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
