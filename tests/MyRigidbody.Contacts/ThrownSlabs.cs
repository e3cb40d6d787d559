using System.Globalization;

namespace RigidBodyDynamics.Contacts;

/// <summary>The package's scene of that name as PhysX plays it, for its picture: a CSV file of poses.</summary>
internal static class ThrownSlabs
{
    private const int FourSeconds = 200;

    public static void Write(PhysX engine, string path)
    {
        (string Name, double X, double[] Spin)[] slabs =
            [("Exact flips", -3.9, [9, 0.3, 0.3]), ("Unity flips", -1.5, [9, 0.3, 0.3]), ("Exact wobbles", 1.5, [3, 8, 0]), ("Unity wobbles", 3.9, [3, 8, 0])];
        World world = new(engine, new Setting
        {
            Floor = true,
            Bodies = [.. slabs.Select(slab => new Box([1.2, 0.3, 2], [slab.X, 1.2, 0], [0, 10, 0], slab.Spin) { IsExact = slab.Name.StartsWith("Exact", StringComparison.Ordinal) })],
        });
        using StreamWriter file = new(path);
        file.WriteLine("body,t,px,py,pz,qw,qx,qy,qz");
        for (int step = 0; step <= FourSeconds; step++)
        {
            for (int i = 0; i < slabs.Length; i++)
            {
                (Vector3d p, Quaterniond q) = (world.Position(i), world[i].Orientation);
                string[] cells = [.. new[] { step * 0.02, p.X, p.Y, p.Z, q.W, q.X, q.Y, q.Z }.Select(number => number.ToString("r", CultureInfo.InvariantCulture))];
                file.WriteLine($"{slabs[i].Name},{string.Join(',', cells)}");
            }

            world.Step();
        }
    }
}
