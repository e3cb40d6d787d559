namespace RigidBodyDynamics.Contacts;

/// <summary>Boxes thrown onto a floor: they come to rest, do not tremble, and sleep when the engine sleeps.</summary>
internal static class Rest
{
    private const int TwentySeconds = 1000, Throws = 10, LastFifth = 10;

    public static bool Holds(PhysX engine)
    {
        Console.WriteLine("\nthrown onto a floor, 10 throws: bodies asleep after 20 s, mean and latest time of falling asleep s, largest turn in a step of the last 0.2 s rad");
        bool holds = true;
        foreach ((string name, double[][] bodies) in new (string, double[][])[]
        {
            ("slab", [[1, 0.4, 0.1]]), ("thick slab", [[1, 0.4, 0.2]]), ("block", [[0.3, 0.5, 0.7]]),
            ("pile of four slabs", [[1, 0.4, 0.1], [1, 0.4, 0.1], [1, 0.4, 0.1], [1, 0.4, 0.1]]),
        })
        {
            Sum engines = Settle(engine, bodies, isExact: false), exact = Settle(engine, bodies, isExact: true);
            Console.WriteLine($"{name + ", the engine alone",-40}{engines}");
            Console.WriteLine($"{"    with ExactRotation",-40}{exact}");
            holds &= exact.Asleep == bodies.Length * Throws && exact.Mean < engines.Mean + 0.6 && exact.Turn < Math.Max(0.001, engines.Turn);
        }

        return holds;
    }

    private static Sum Settle(PhysX engine, double[][] edges, bool isExact)
    {
        Random random = new(2);
        List<int> times = [];
        double turn = 0;
        for (int i = 0; i < Throws; i++)
        {
            double Any() => Math.Round((2 * random.NextDouble()) - 1, 3);
            World world = new(engine, new Setting
            {
                Floor = true,
                Restitution = 0.2,
                Bodies = [.. edges.Select((edge, n) => new Box(edge, [0, 1.5 + (0.7 * n), 0], [Any(), 0, Any()], [5 * Any(), 5 * Any(), 5 * Any()]) { IsExact = isExact })],
            });
            Queue<double>[] turns = [.. edges.Select(_ => new Queue<double>())];
            bool[] isAsleep = new bool[edges.Length];
            for (int step = 1; step <= TwentySeconds; step++)
            {
                Quaterniond[] before = [.. edges.Select((_, n) => world[n].Orientation.Normalized)];
                world.Step();
                for (int n = 0; n < edges.Length; n++)
                {
                    turns[n].Enqueue(Conserved.AngleBetween(before[n], world[n].Orientation.Normalized));
                    if (turns[n].Count > LastFifth)
                        turns[n].Dequeue();

                    if (!isAsleep[n] && world[n].IsAsleep)
                    {
                        times.Add(step);
                        turn = Math.Max(turn, turns[n].Max());
                    }

                    isAsleep[n] |= world[n].IsAsleep;
                }
            }
        }

        return new Sum(times.Count, times.Count > 0 ? 0.02 * times.Average() : double.NaN, times.Count > 0 ? 0.02 * times.Max() : double.NaN, turn);
    }

    private sealed record Sum(int Asleep, double Mean, double Latest, double Turn)
    {
        public override string ToString() => $"{Asleep,6}{Mean,8:f2}{Latest,8:f2}{Turn,12:e1}";
    }
}
