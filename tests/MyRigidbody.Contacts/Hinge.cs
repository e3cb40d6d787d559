namespace RigidBodyDynamics.Contacts;

/// <summary>A block on a hinge through its centre, rotated about it: the joint is the engine's, and holds as well as without ExactRotation.</summary>
internal static class Hinge
{
    public static bool Holds(PhysX engine)
    {
        double alone = Wobble(engine, isExact: false), exact = Wobble(engine, isExact: true);
        Console.WriteLine($"\nhung on an axis and turned at 5 rad/s, 20 s: largest angle between the body's axis and the joint's, rad\nthe engine alone  {alone,10:e1}\nwith ExactRotation{exact,10:e1}");
        return exact < Math.Max(1e-3, 2 * alone);
    }

    private static double Wobble(PhysX engine, bool isExact)
    {
        Box block = new([0.3, 0.5, 0.7], [0, 3, 0], [0, 0, 0], [5, 0, 0]) { IsExact = isExact };
        World world = new(engine, new Setting { Hinge = true, Bodies = [block] });
        double most = 0;
        for (int step = 0; step < 1000; step++)
        {
            world.Step([0, 0, 0.3 * Math.Sin(0.06 * step), 0.2]);
            Vector3d axis = world[0].Orientation.Normalized.Rotate(new Vector3d(1, 0, 0));
            most = Math.Max(most, Math.Asin(Math.Min(1, new Vector3d(0, axis.Y, axis.Z).Length)));
        }

        return most;
    }
}
