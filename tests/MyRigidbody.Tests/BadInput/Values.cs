namespace RigidBodyDynamics.Tests;

/// <summary>For every type that an entry of the library takes: a sound value, and invalid values.</summary>
internal static class Values
{
    private static readonly double[] Numbers =
        [double.NaN, double.PositiveInfinity, double.NegativeInfinity, -0.0, 5e-324, -5e-324, 1e-308, 1e308, -1e308, double.MaxValue];

    /// <summary>A value with which the entry works.</summary>
    public static object Sound(Type type)
    {
        Vector3d vector = new(1, 0.5, 0.25);
        return type switch
        {
            _ when type == typeof(double) => 0.5,
            _ when type == typeof(int) || type == typeof(long) => Convert.ChangeType(1, type, null),
            _ when type == typeof(bool) => false,
            _ when type == typeof(string) => "name",
            _ when type == typeof(object) => "value",
            _ when type == typeof(Vector3d) => vector,
            _ when type == typeof(Quaterniond) => new Quaterniond(0.8, 0.6, 0, 0),
            _ when type == typeof(SymmetricMatrix3) => SymmetricMatrix3.Identity,
            _ when type == typeof(MassProperties) => Solids.Box(1, vector),
            _ when type == typeof(BodyState) => new BodyState(vector, Quaterniond.Identity, vector, vector),
            _ when type == typeof(Instant) => new Instant(0, 0),
            _ when type == typeof(Coasting) => Coasting.Free,
            _ when type == typeof(Wrench) => default(Wrench),
            _ when type == typeof(BodyDescription) => new BodyDescription("body", Solids.Box(1, vector)) { Start = new BodyState(vector, Quaterniond.Identity, vector, vector) },
            _ when type == typeof(BodyDescription[]) || type == typeof(IReadOnlyList<BodyDescription>) => new[] { (BodyDescription)Sound(typeof(BodyDescription)) },
            _ when type == typeof(TimeSteps) => TimeSteps.Every(0.5, 2),
            _ when type == typeof(SceneDescription) => new SceneDescription("scene", "", TimeSteps.Every(0.5, 2), [(BodyDescription)Sound(typeof(BodyDescription))]),
            _ when type == typeof(Simulation) => new Simulation((SceneDescription)Sound(typeof(SceneDescription))),
            _ when type == typeof(Body) => ((Simulation)Sound(typeof(Simulation))).Bodies[0],
            _ when type == typeof(Effect) => ((BodyDescription)Sound(typeof(BodyDescription))).With(new Force(vector)).Effects[0],
            _ when type == typeof(Predicate<Effect>) => (Predicate<Effect>)(effect => false),
            _ when type == typeof(Action) => (Action)(() => { }),
            _ when type == typeof(Action<double>) => (Action<double>)(done => { }),
            _ when type == typeof(ICoast) => new LinearDamping(1),
            _ when type == typeof(IPush) => new Force(vector),
            _ when type == typeof(IReadOnlyList<double>) => new[] { 0.5, 0.5, 0.5, 0.5 },
            _ when type == typeof(IReadOnlyList<Vector3d>) => new[] { Vector3d.Zero, new(1, 0, 0), new(0, 1, 0), new(0, 0, 1) },
            // the tetrahedron of those vertices
            _ when type == typeof(IReadOnlyList<int>) => new[] { 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3 },
            _ when type == typeof(IReadOnlyList<BodyState>) => new[] { BodyState.AtRest },
            _ when type == typeof(Explanation) => new Explanation((Body)Sound(typeof(Body))),
            _ when type == typeof(Rule) => Rules.Default,
            _ when type == typeof(FreeMotion) => new FreeMotion((BodyDescription)Sound(typeof(BodyDescription))),
            _ when type == typeof(HeldKeys) => new HeldKeys(new LabKeyboard { [LabKey.R] = true }),
            _ when type == typeof(PerStep) => new PerStep([vector], [vector]),
            _ when type == typeof(Torque) => Torque.Constant(vector),
            _ when type.IsEnum => Enum.GetValues(type).GetValue(0)!,
            _ when type.IsValueType || type.GetConstructor([]) != null => Activator.CreateInstance(type)!,
            _ => throw new NotSupportedException($"no sound value of {type} is known: add one here"),
        };
    }

    /// <summary>Invalid values.</summary>
    public static IEnumerable<object?> Hostile(Type type)
    {
        if (!type.IsValueType)
            yield return null;

        IEnumerable<object> more = type switch
        {
            _ when type == typeof(double) => Numbers.Cast<object>(),
            _ when type == typeof(int) => [int.MinValue, -1, 0, int.MaxValue],
            _ when type == typeof(long) => [long.MinValue, -1L, 0L, long.MaxValue],
            _ when type == typeof(string) => ["", "two\nlines", "../../x"],
            _ when type == typeof(Vector3d) => [Vector3d.Zero, .. Numbers.Select(x => (object)new Vector3d(0.5, x, 1)), new Vector3d(1e308, 1e308, -1e308)],
            _ when type == typeof(Quaterniond) => [default(Quaterniond), .. Numbers.Select(x => (object)new Quaterniond(0, x, 0, 0))],
            _ when type == typeof(SymmetricMatrix3) => [default(SymmetricMatrix3), .. Numbers.Select(x => (object)new SymmetricMatrix3(new Vector3d(1, x, 1), Vector3d.Zero))],
            _ when type == typeof(BodyState) => [default(BodyState), .. Numbers.Select(x => (object)new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(x, 0, 0), Vector3d.Zero))],
            _ when type == typeof(IReadOnlyList<double>) => [Array.Empty<double>(), .. Numbers.Select(x => (object)new[] { 0.5, x, 0.5, 0.5 })],
            _ when type == typeof(IReadOnlyList<Vector3d>) => [Array.Empty<Vector3d>(), .. Numbers.Select(x => (object)new[] { Vector3d.Zero, new(1, 0, 0), new(0, 1, x), new(0, 0, 1) })],
            _ when type == typeof(IReadOnlyList<int>) => [Array.Empty<int>(), new[] { 0, 1 }, new[] { 0, 1, 4 }, new[] { 0, -1, 2 }, new[] { 0, 1, 2 }],
            _ when type == typeof(BodyDescription[]) || type == typeof(IReadOnlyList<BodyDescription>) => [Array.Empty<BodyDescription>(), new BodyDescription[1]],
            _ when type == typeof(IReadOnlyList<BodyState>) => [Array.Empty<BodyState>(), new BodyState[1]],
            _ when type.IsEnum => [Enum.ToObject(type, 99)],
            _ when type.IsValueType && type != typeof(bool) => [Activator.CreateInstance(type)!],
            _ => [],
        };
        foreach (object value in more)
            yield return value;
    }
}
