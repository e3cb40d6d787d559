using System.Globalization;

namespace RigidBodyDynamics.Lab;

/// <summary>The result of another engine for the tumbling body, measured with that engine; its data file names the machine.</summary>
/// <param name="Name">The engine.</param>
/// <param name="AngleError">After 100 s in steps of 1/50 s, rad.</param>
/// <param name="Cost">Time for a simulated second, s.</param>
internal sealed record OtherEngine(string Name, double AngleError, double Cost)
{
    /// <summary>The motion they were measured on.</summary>
    public const string Motion = "asym_moderate";

    /// <summary>All of them.</summary>
    public static IReadOnlyList<OtherEngine> All { get; } = [.. Lines().Skip(1).Select(line => line.Split(','))
        .Select(cells => new OtherEngine(cells[0], Number(cells[1]), Number(cells[2]) / 1000 / 100))];

    private static IEnumerable<string> Lines()
    {
        using Stream stream = typeof(OtherEngine).Assembly.GetManifestResourceStream("other-engines.csv")!;
        using StreamReader reader = new(stream);
        return [.. reader.ReadToEnd().Split('\n').Where(line => line.Length > 0 && line[0] != '#')];
    }

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);
}
