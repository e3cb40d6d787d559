using System.Globalization;
using System.Text.Json;

namespace RigidBodyDynamics.Tests;

/// <summary>A reference solution to 20 digits: its inputs, and its samples with the error that is attainable at each.</summary>
internal sealed class ExactCase
{
    private readonly string[] _columns;

    private ExactCase(string id)
    {
        using JsonDocument json = JsonDocument.Parse(File.ReadAllText(TestData.Exact(id + ".json")));
        Inputs = json.RootElement.Clone();
        string[] lines = File.ReadAllLines(TestData.Exact(id + ".csv"));
        _columns = lines[0].Split(',');
        Samples = [.. lines.Skip(1).Select(line => new Sample(this, [.. line.Split(',').Select(Number)]))];
    }

    public JsonElement Inputs { get; }

    public IReadOnlyList<Sample> Samples { get; }

    public static ExactCase Read(string id) => new(id);

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);

    /// <summary>The state at one time.</summary>
    internal sealed class Sample(ExactCase owner, double[] values)
    {
        public double Time => this["t"];

        public Vector3d Position => Vector("p");

        public Vector3d Velocity => Vector("v");

        /// <summary>In world axes.</summary>
        public Vector3d AngularVelocity => Vector("ww");

        public Quaterniond Orientation => new(this["qw"], Vector("q"));

        public double this[string column] => values[Array.IndexOf(owner._columns, column)];

        private Vector3d Vector(string name) => new(this[name + "x"], this[name + "y"], this[name + "z"]);
    }
}
