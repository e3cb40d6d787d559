using System.Globalization;

namespace RigidBodyDynamics.Tests;

/// <summary>A random scene, and an error bound; all of it follows from a number.</summary>
/// <remarks>
/// Twelve kinds one after another: springs in phase with whole seconds, springs on an arm, windows on decimal, frame and odd times, throws with drag,
/// stiff springs with damping, heavy tops, torques in world and body axes, free tops, two bodies at once, the lab's keys with its factor per
/// step, lists of steps, and fast oscillations of a body that is hung up by a point.
/// </remarks>
internal sealed class RandomChoice
{
    private readonly Random _random;

    private RandomChoice(int number)
    {
        _random = new Random(20261130 + number);
        double duration = Round(Between(2, 20)), step = Pick(0.02, 1.0 / 60, 0.01);
        string steps = Number(step), bodies = Kind(number % 12);
        if (number % 12 == 8)
            bodies += ", " + Kind(_random.Next(8)).Replace("\"ball\"", "\"other\"", StringComparison.Ordinal);

        if (number % 12 == 10)
            steps = "[" + string.Join(", ", Enumerable.Range(0, 200).Select(i => Number(i % 3 == 0 ? 0.05 : 0.03))) + "]";

        string end = number % 12 == 10 ? string.Empty : $""" "duration": {Number(duration)}, """;
        Json = $$"""{ "schema": "rigid-body-scene/1", "name": "random {{number}}", "step": {{steps}}, {{end}} "bodies": [{{bodies}}] }""";
        Error = number % 20 == 19 ? 1e-12 : Math.Round(Math.Pow(10, Between(-10, -1.3)), 13);
    }

    /// <summary>The scene file.</summary>
    public string Json { get; }

    /// <summary>The error bound, the larger of rad and m.</summary>
    public double Error { get; }

    /// <summary>The scene of a number.</summary>
    public static RandomChoice Of(int number) => new(number);

    private string Kind(int kind) => kind switch
    {
        0 => Ball(Start(spin: 0, speed: 0), Gravity, Spring(Mass * Math.Pow(2 * Math.PI * Pick(1, 2, 2.5, 4), 2), Zero)),
        1 => Ball(Start(spin: 1, speed: 1), Gravity, Spring(Between(5, 50), Vector(0.3))),
        2 => Ball(Start(spin: 2, speed: 1), Windowed(Force), Windowed(Torque(Pick(0, 1) == 1)), Windowed($"\"gravity\": {Vector(3)}")),
        3 => Ball(Start(spin: 1, speed: 15), Gravity, $$"""{ "quadraticDrag": {{Number(Between(0.01, 0.3))}} }"""),
        4 => Ball(Start(spin: 0.5, speed: 1), Gravity, Spring(Between(200, 4000), Zero), Pick(0, 1) == 1
            ? $$"""{ "linearDamping": {{Number(Between(1, 40))}} }"""
            : $$"""{ "quadraticDrag": {{Number(Between(0.1, 5))}} }"""),
        5 => Ball(Start(spin: Between(3, 15), speed: 0), $$"""{ "heavyTop": { "axis": [0, 0, 1], "moment": {{Number(Between(0.5, 5))}}, "up": [0, 0, 1], "inertiaAbout": "pivot" } }"""),
        6 => Ball(Start(spin: 2, speed: 0), "{ " + Torque(true) + " }", "{ " + Torque(false) + " }", $$"""{ "angularDamping": {{Number(Between(0, 0.5))}} }"""),
        7 => Ball(Start(spin: 6, speed: 5), Gravity, $$"""{ "linearDamping": {{Number(Between(0, 0.5))}} }"""),
        8 => Kind(_random.Next(8)),
        9 => Ball(Start(spin: 1, speed: 0), Key("R"), Key("RightArrow"), Key("UpArrow"), """{ "decayPerStep": 0.98 }"""),
        10 => Ball(Start(spin: 3, speed: 1), Gravity, "{ " + Torque(true) + " }", Windowed(Force)),
        _ => Ball(Start(spin: 1, speed: 0), Spring(Between(50, 400), Vector(0.4)), $$"""{ "angularDamping": {{Number(Between(0, 1))}} }""").Replace("\"name\"", "\"canMove\": false, \"name\"", StringComparison.Ordinal),
    };

    private const string Gravity = """{ "gravity": [0, -9.81, 0] }""", Zero = "[0, 0, 0]";

    private const double Mass = 2;

    private string Ball(string start, params string[] effects)
    {
        string inertia = Pick(0, 1, 2) switch
        {
            0 => """{ "solidSphere": 0.5 }""",
            1 => """{ "principal": [1, 1, 0.6] }""",
            _ => $$"""{ "principal": [1, {{Number(Between(1.1, 2))}}, {{Number(Between(2, 2.1))}}] }""",
        };
        return $$"""{ "name": "ball", "mass": 2, "inertia": {{inertia}}, {{start}}, "effects": [{{string.Join(", ", effects)}}] }""";
    }

    private string Start(double spin, double speed) =>
        $"\"position\": {Vector(1)}, \"orientation\": {Turn()}, \"velocity\": {Vector(speed)}, \"angularVelocityBody\": {Vector(spin)}";

    private string Spring(double stiffness, string anchor) => $$"""{ "spring": { "anchor": {{anchor}}, "at": {{Vector(1)}}, "stiffness": {{Number(stiffness)}} } }""";

    private string Torque(bool inBody) =>
        $$""" "torque": { "frame": "{{(inBody ? "body" : "world")}}", "constant": {{Vector(0.5)}}, "sin": {{Vector(1)}}, "rate": {{Number(Pick(1, 2 * Math.PI, 3.7))}} } """;

    private string Force => $"\"force\": {Vector(5)}";

    private string Key(string key) => Windowed($"\"key\": \"{key}\"");

    /// <summary>From one time to another: of tenths, of frames, or odd.</summary>
    private string Windowed(string effect)
    {
        double unit = Pick(0.1, 1.0 / 60, 0.0137), from = _random.Next(1, (int)(1 / unit)), to = from + _random.Next(1, (int)(1 / unit));
        return $$"""{ {{effect}}, "from": {{Number(from * unit)}}, "to": {{Number(to * unit)}} }""";
    }

    private string Turn() => Pick(0, 1) == 0 ? "[1, 0, 0, 0]" : $"[{Number(Between(0.2, 1))}, {Number(Between(-1, 1))}, {Number(Between(-1, 1))}, {Number(Between(-1, 1))}]";

    private string Vector(double size) => $"[{Number(Between(-size, size))}, {Number(Between(-size, size))}, {Number(Between(-size, size))}]";

    private double Between(double low, double high) => low + ((high - low) * _random.NextDouble());

    private double Pick(params double[] of) => of[_random.Next(of.Length)];

    private static double Round(double value) => Math.Round(value, 1);

    private static string Number(double value) => value.ToString("R", CultureInfo.InvariantCulture);
}
