using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Bodies of all kinds and starts that break a careless lane, and what must hold for many of them.</summary>
internal static class Crowding
{
    private static readonly Quaterniond Tilt = new(0.9, 0.1, -0.3, 0.2);
    private static readonly Vector3d Center = new(0.1, -0.2, 0.3);

    /// <summary>Every kind of top, and moments that are almost another kind's.</summary>
    public static IEnumerable<MassProperties> Masses { get; } =
    [
        MassProperties.FromPrincipal(1, new Vector3d(1, 2, 3)),
        MassProperties.FromPrincipal(2, new Vector3d(3, 1, 2.5), Tilt, Center),
        MassProperties.FromPrincipal(1, new Vector3d(1, 1 + 1e-12, 2)),
        MassProperties.FromPrincipal(1e-3, new Vector3d(1e-6, 1e-3, 1.0005e-3)),
        MassProperties.FromPrincipal(1, new Vector3d(1, 1, 0.5)),
        MassProperties.FromPrincipal(3, new Vector3d(0.5, 2, 2), Tilt, Center),
        MassProperties.FromPrincipal(2, new Vector3d(2, 2, 2), Tilt, Center),
    ];

    /// <summary>Random starts, every few of them at rest, at 1e-80, about the unstable axis, or with many revolutions a step.</summary>
    public static BodyState[] Starts(int count, int seed, BodyDescription body)
    {
        Random random = new(seed);
        return [.. Enumerable.Range(0, count).Select(Start)];

        BodyState Start(int i)
        {
            Vector3d w = (i % 13) switch
            {
                0 => Vector3d.Zero,
                1 => new Vector3d(1e-8, 3, 0),
                2 => 1e3 * Any(),
                3 => new Vector3d(0, 0, 2),
                4 => 1e-80 * Any(),
                5 => 30 * Any(),
                6 => new Vector3d(1e-3, 400, 1e-3),
                _ => 3 * Any(),
            };
            Quaterniond q = new(random.NextDouble() - 0.5, Any());
            Vector3d x = Any(), v = body.CanMove ? Any() : Vector3d.Zero;
            return body.Lock.Applied(new BodyState(x, q, v, q.Normalized.Rotate(w)), body.Mass);
        }

        Vector3d Any() => new(2 * random.NextDouble() - 1, 2 * random.NextDouble() - 1, 2 * random.NextDouble() - 1);
    }

    /// <summary>Bodies of a batch, each beside the same body alone.</summary>
    public static void Same(BodyDescription body, TimeSteps steps, BodyState[] starts, IEnumerable<long> looks, int threads = 1)
    {
        Together batch = new(body, steps) { Threads = threads };
        foreach (BodyState start in starts)
            batch.Add(start);
        Simulation? alone = starts.Length == 0 ? null : new(new SceneDescription("alone", "", steps, [.. starts.Select(Alone)]), Omissions.Coasting);
        BodyState[] found = new BodyState[starts.Length];
        foreach (long look in looks)
        {
            batch.Step(look - batch.StepsDone);
            alone?.Step(look - alone.StepsDone);
            batch.Read(found);
            for (int i = 0; i < found.Length; i++)
                Same(batch[i], found[i], $"body {i} of {starts.Length} at step {look}, by itself");

            for (int i = 0; i < found.Length; i++)
                Same(found[i], alone!.Bodies[i].State, $"body {i} of {starts.Length} at step {look}, {body.Mass.PrincipalMoments}");
        }

        BodyDescription Alone(BodyState start, int number)
        {
            BodyDescription copy = body.Copy("body " + number, body.Mass);
            copy.Start = start;
            return copy;
        }
    }

    /// <summary>All bits equal, those of zeros' signs too; one NaN is like another.</summary>
    public static void Same(in BodyState found, in BodyState expected, string which)
    {
        if (!Numbers(found).SequenceEqual(Numbers(expected)))
            Assert.That(Show(found), Is.EqualTo(Show(expected)), which);
    }

    private static string Show(in BodyState s) => $"{s.Position} {s.Orientation} {s.Velocity} {s.AngularVelocity}";

    private static IEnumerable<long> Numbers(BodyState s) => new[]
    {
        s.Position.X, s.Position.Y, s.Position.Z, s.Orientation.W, s.Orientation.X, s.Orientation.Y, s.Orientation.Z,
        s.Velocity.X, s.Velocity.Y, s.Velocity.Z, s.AngularVelocity.X, s.AngularVelocity.Y, s.AngularVelocity.Z,
    }.Select(x => double.IsNaN(x) ? -1 : BitConverter.DoubleToInt64Bits(x));
}
