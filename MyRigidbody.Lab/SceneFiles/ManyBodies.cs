namespace RigidBodyDynamics.Lab;

/// <summary>Many bodies of a scene that differ in their starts alone: <c>"count"</c>, <c>"seed"</c> and <c>"spread"</c>.</summary>
/// <param name="Body">What each of them is, and where the one in the middle starts.</param>
/// <param name="Count">How many there are.</param>
/// <param name="Spread">How their starts differ.</param>
internal sealed record ManyBodies(BodyDescription Body, int Count, Spread Spread)
{
    /// <summary>A scene may have so many bodies of one kind.</summary>
    public const int Most = 10_000_000;

    /// <summary>Reads what a body says of its number; null if it is one.</summary>
    public static ManyBodies? Read(Fields fields, BodyDescription body)
    {
        Place? count = fields.Optional("count");
        fields.OnlyIf(count != null, "seed", "is for bodies with a count only");
        fields.OnlyIf(count != null, "spread", "is for bodies with a count only");
        if (count is not Place place)
        {
            return null;
        }

        long number = place.Count();
        if (number is < 1 or > Most)
        {
            throw place.Not($"a number from 1 to {Most}");
        }

        Spread spread = new() { Seed = fields.Or("seed", 0, seed => seed.Count()) };
        if (fields.Optional("spread") is Place differences)
        {
            differences.Make(() => Read(differences.Fields(), spread));
        }

        return new ManyBodies(body, (int)number, spread);
    }

    /// <summary>The bodies, at their starts.</summary>
    public Batch Gather(TimeSteps steps)
    {
        Batch batch = new(Body, steps);
        for (int i = 0; i < Count; i++)
        {
            BodyState start = Spread.Of(Body.Start, i);
            // one that turns as the body in the middle keeps its very numbers in body axes
            _ = start.Orientation == Body.Start.Orientation && start.AngularVelocity == Body.Start.AngularVelocity
                ? batch.Add(start, Body.AngularVelocityInBody)
                : batch.Add(start);
        }

        return batch;
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
