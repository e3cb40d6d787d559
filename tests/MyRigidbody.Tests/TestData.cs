namespace RigidBodyDynamics.Tests;

/// <summary>Where the reference data is.</summary>
internal static class TestData
{
    /// <summary>A recording of the real PhysX.</summary>
    public static string Physx(string file) => Path.Combine(AppContext.BaseDirectory, "data", "physx", file);

    /// <summary>A solution to 20 digits.</summary>
    public static string Exact(string file) => Path.Combine(AppContext.BaseDirectory, "data", "exact", file);
}
