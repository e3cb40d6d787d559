namespace RigidBodyDynamics.Contacts;

/// <summary>A slab thrown in a room: the part of its energy that is left as motion, with ExactRotation and without, in forty throws.</summary>
internal static class Bounce
{
    private const int Throws = 40, FiveSeconds = 250, Times = 6;
    private const double HalfRoom = 2, Weight = 9.81;

    public static bool Holds(PhysX engine)
    {
        Console.WriteLine("\nkinetic energy of a slab that bounces in a room, by its first energy: after 5, 10 … 30 s, the mean of 40 throws; then the most energy of any throw at any time");
        bool holds = true;
        foreach ((double restitution, double friction) in new[] { (0.5, 0.6), (0.8, 0.4), (0.8, 0.0), (1.0, 0.0), (1.0, 0.5) })
        {
            (double[] engines, double enginesMost) = Left(engine, restitution, friction, isExact: false);
            (double[] exact, double most) = Left(engine, restitution, friction, isExact: true);
            Write($"bounciness {restitution}, friction {friction}, the engine alone", engines, enginesMost);
            Write("    with ExactRotation", exact, most);
            // measured: by 0.0024 at most, of some throws that still move; blows that take nothing, and friction: in the first ten seconds the engine's bodies, which do not tumble, lose more
            holds &= (restitution == 1 && friction > 0) || exact.Zip(engines).All(pair => pair.First <= pair.Second + 0.003);
            holds &= most <= Math.Max(1.03, enginesMost);
        }

        return holds;
    }

    private static (double[] Left, double Most) Left(PhysX engine, double restitution, double friction, bool isExact)
    {
        Random random = new(1);
        double[] left = new double[Times];
        double most = 0;
        for (int i = 0; i < Throws; i++)
        {
            Box slab = new([1, 0.4, 0.1], Random(random, 1), Random(random, 4), Random(random, 8)) { IsExact = isExact };
            World world = new(engine, new Setting { Room = HalfRoom, Friction = friction, Restitution = restitution, Bodies = [slab] });
            double first = AboveTheFloor(world);
            for (int step = 1; step <= FiveSeconds * Times; step++)
            {
                world.Step();
                double now = AboveTheFloor(world) / first;
                most = Math.Max(most, now);
                if (step % FiveSeconds == 0)
                    left[(step / FiveSeconds) - 1] += world.Motion(0) / first / Throws;
            }
        }

        return (left, most);
    }

    private static double AboveTheFloor(World world) => world.Energy(0) + (HalfRoom * Weight);

    private static double[] Random(Random random, double most) =>
        [.. Enumerable.Range(0, 3).Select(_ => most * Math.Round((2 * random.NextDouble()) - 1, 3))];

    private static void Write(string what, double[] left, double most) =>
        Console.WriteLine($"{what,-55}{string.Concat(left.Select(part => $"{part,8:f3}"))}{most,12:f3}");
}
