using System.Numerics;

namespace RigidBodyDynamics.Lab;

/// <summary>Many bodies of a scene that differ only in their starts: <c>"count"</c>, <c>"seed"</c> and <c>"spread"</c>.</summary>
/// <param name="Body">The common description, with the start in the middle of the spread.</param>
/// <param name="Count">Their number.</param>
/// <param name="Spread">How their starts differ.</param>
internal sealed record ManyBodies(BodyDescription Body, int Count, Spread Spread)
{
    /// <summary>The largest number of bodies of one kind.</summary>
    public const int Most = 10_000_000;

    // below this number their memory is not measured
    private const int Many = 100_000, Tried = 4096;

    private const double BytesOfHandle = 100;

    /// <summary>Reads the count of a body; null if it is one body.</summary>
    public static ManyBodies? Read(Fields fields, BodyDescription body)
    {
        Place? count = fields.Optional("count");
        fields.OnlyIf(count != null, "seed", "is for bodies with a count only");
        fields.OnlyIf(count != null, "spread", "is for bodies with a count only");
        if (count is not Place place)
            return null;

        long number = place.Count();
        if (number is < 1 or > Most)
            throw place.Not($"a number from 1 to {Most}");

        Spread spread = new() { Seed = fields.Or("seed", 0, seed => seed.Count()) };
        if (fields.Optional("spread") is Place differences)
            differences.Make(() => Read(differences.Fields(), spread));

        return new ManyBodies(body, (int)number, spread);
    }

    /// <summary>The bodies of a scene: first the single ones, then those with a count.</summary>
    public static Simulation Simulate(SceneDescription scene, IReadOnlyDictionary<string, ManyBodies> crowds)
    {
        Memory.MustHold("bodies", crowds.Values.Where(crowd => crowd.Count > Many).Sum(crowd => crowd.Bytes(scene.Steps)));
        Simulation simulation = new(new SceneDescription(scene.Name, scene.About, scene.Steps, [.. scene.Bodies.Where(body => !crowds.ContainsKey(body.Name))]));
        foreach (BodyDescription body in scene.Bodies.Where(body => crowds.ContainsKey(body.Name)))
            crowds[body.Name].AddTo(simulation);

        return simulation;
    }

    /// <summary>The scene with the first of each crowd in place of its middle body, which is not simulated.</summary>
    public static SceneDescription WithFirst(SceneDescription scene, IReadOnlyDictionary<string, ManyBodies> crowds) => new(
        scene.Name, scene.About, scene.Steps, [.. scene.Bodies.Select(body => crowds.TryGetValue(body.Name, out ManyBodies? crowd) ? crowd.Start(0) : body)]);

    /// <summary>The name of a body; one of many has a number.</summary>
    public static string NameOf(Body body) => body.Tag is int number ? $"{body.Name} {number}" : body.Name;

    private void AddTo(Simulation simulation)
    {
        BodyDescription all = Body.Copy(Body.Name, Body.Mass);
        for (int i = 0; i < Count; i++)
        {
            Place(all, i);
            simulation.Add(all).Tag = i;
        }
    }

    private BodyDescription Start(int number)
    {
        BodyDescription one = Body.Copy(Body.Name, Body.Mass);
        Place(one, number);
        return one;
    }

    private void Place(BodyDescription body, int number)
    {
        body.Start = Spread.Of(Body.Start, number);
        // one with the orientation and ω of the middle body keeps exactly its numbers in body axes
        if (body.Start.Orientation == Body.Start.Orientation && body.Start.AngularVelocity == Body.Start.AngularVelocity)
            body.AngularVelocityInBody = Body.AngularVelocityInBody;
    }

    /// <summary>Their memory, measured on a few of their kind; columns grow by doubling, so half of it is unused.</summary>
    private double Bytes(TimeSteps steps)
    {
        Simulation few = new(steps);
        long before = GC.GetAllocatedBytesForCurrentThread();
        (this with { Count = Tried }).AddTo(few);
        double each = (GC.GetAllocatedBytesForCurrentThread() - before) / 2.0 / Tried;
        return (each * BitOperations.RoundUpToPowerOf2((uint)Count)) + (BytesOfHandle * Count);
    }

    private static Spread Read(Fields fields, Spread spread)
    {
        spread.Position = fields.Or("position", Vector3d.Zero, place => place.Vector());
        spread.Orientation = fields.Or("orientation", 0, place => place.Number());
        spread.Velocity = fields.Or("velocity", Vector3d.Zero, place => place.Vector());
        spread.AngularVelocity = fields.Or("angularVelocity", Vector3d.Zero, place => place.Vector());
        fields.End();
        return spread;
    }
}
