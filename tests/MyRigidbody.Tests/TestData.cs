namespace RigidBodyDynamics.Tests;

/// <summary>Where the reference data is.</summary>
internal static class TestData
{
    /// <summary>A file of reference data.</summary>
    public static string Path(params string[] parts) => System.IO.Path.Combine([AppContext.BaseDirectory, "data", .. parts]);

    /// <summary>A recording of the real PhysX.</summary>
    public static string Physx(string file) => Path("physx", file);

    /// <summary>A solution to 20 digits.</summary>
    public static string Exact(string file) => Path("exact", file);
}
