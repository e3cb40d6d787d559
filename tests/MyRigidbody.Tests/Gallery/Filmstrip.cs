using System.Globalization;
using System.Text;
using System.Text.Json;
using System.Text.Json.Nodes;
using RigidBodyDynamics.Lab;

namespace RigidBodyDynamics.Tests;

/// <summary>A scene as a picture in six frames, from its start to its end, for the page of scenes.</summary>
internal sealed class Filmstrip
{
    private const int Frames = 6, Width = 158, Height = 220, Top = 40, Margin = 8;

    // a body that would be smaller than this part of a frame is drawn larger
    private const double Smallest = 0.24;
    private static readonly string[] Colors = ["#1f5fa8", "#c8550a"];
    private static readonly (int[] Corners, int Axis, int Side)[] Faces =
    [
        ([0, 2, 6, 4], 0, -1), ([1, 5, 7, 3], 0, 1), ([0, 4, 5, 1], 1, -1), ([2, 3, 7, 6], 1, 1), ([0, 1, 3, 2], 2, -1), ([4, 6, 7, 5], 2, 1),
    ];

    // looked at from the front, a little from the right and above; Unity's z points away from the eye
    private static readonly (double Sin, double Cos) Turn = (0.38, 0.925), Tilt = (0.3, 0.954);
    private readonly List<Body> _bodies = [];
    private readonly List<double> _times = [];
    private readonly StringBuilder _svg = new();
    private double _left, _low, _scale, _larger = 1;

    private Filmstrip(string path)
    {
        SceneFile file = SceneReader.Read(path);
        JsonNode root = JsonNode.Parse(File.ReadAllText(path), null, new JsonDocumentOptions { AllowTrailingCommas = true, CommentHandling = JsonCommentHandling.Skip })!;
        Simulation simulation = new(file.Scene);
        _bodies.AddRange(file.Scene.Bodies.Select((body, i) => new Body(body.Name, body.Mass.CenterOfMass, [.. Boxes(root["bodies"]![i]!["inertia"]!)])));
        long count = file.Scene.Steps.Count;
        for (long step = 0; step <= count; step++)
        {
            simulation.Step(step - simulation.StepsDone);
            _times.Add(simulation.Time);
            for (int i = 0; i < _bodies.Count; i++)
                _bodies[i].States.Add(simulation.Bodies[i].State);
        }

        Fit();
        Draw(file.Scene.Name);
    }

    /// <summary>The picture of a scene, as SVG.</summary>
    public static string Of(string path) => new Filmstrip(path)._svg.ToString();

    private void Fit()
    {
        (double X, double Y, double Depth)[] all = [.. _bodies.SelectMany(body => body.States.Select(state => Flat(body.Centre(state))))];
        double size = _bodies.Max(body => body.Size);
        double left = all.Min(p => p.X), right = all.Max(p => p.X), low = all.Min(p => p.Y), high = all.Max(p => p.Y);
        double scale = Math.Min((Width - 2 * Margin) / (right - left + size), (Height - 2 * Margin) / (high - low + size));
        if (scale * size < Smallest * Height)
        {
            double drawn = Smallest * Height;
            scale = Math.Min((Width - 2 * Margin - drawn) / Math.Max(right - left, 1e-9), (Height - 2 * Margin - drawn) / Math.Max(high - low, 1e-9));
            _larger = drawn / (scale * size);
        }

        (_scale, _left, _low) = (scale, 0.5 * (left + right), 0.5 * (low + high));
    }

    private void Draw(string name)
    {
        int width = Frames * (Width + Margin) + Margin, height = Top + Height + 26;
        Line($"<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" font-size=\"14\">");
        Line($"<rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>");
        Line($"<text x=\"{Margin}\" y=\"26\" font-size=\"17\" fill=\"#1c1d1f\">{name}</text>");
        for (int i = 0; i < _bodies.Count; i++)
            Line($"<text x=\"{width - Margin - (_bodies.Count - 1 - i) * 170}\" y=\"26\" text-anchor=\"end\" fill=\"{Colors[i]}\">■ {_bodies[i].Name}</text>");

        if (_larger > 1.5)
            Line($"<text x=\"{width / 2}\" y=\"26\" text-anchor=\"middle\" fill=\"#5f6368\">bodies {Math.Round(_larger):f0} times larger</text>");

        for (int frame = 0; frame < Frames; frame++)
        {
            int at = (int)Math.Round((_times.Count - 1.0) * frame / (Frames - 1)), left = Margin + frame * (Width + Margin);
            Line($"<svg x=\"{left}\" y=\"{Top}\" width=\"{Width}\" height=\"{Height}\">");
            Line($"<rect width=\"{Width}\" height=\"{Height}\" fill=\"#f5f6f7\" stroke=\"#d4d6d8\"/>");
            for (int i = 0; i < _bodies.Count; i++)
                Way(_bodies[i], at, Colors[i]);

            foreach ((Body body, int i) in _bodies.Select((body, i) => (body, i)).OrderByDescending(pair => Flat(pair.body.Centre(pair.body.States[at])).Depth))
                Solid(body, body.States[at], Colors[i]);

            Line($"</svg>");
            Line($"<text x=\"{left + Width / 2}\" y=\"{Top + Height + 18}\" text-anchor=\"middle\" fill=\"#1c1d1f\">{Math.Round(_times[at], 2)} s</text>");
        }

        Line($"</svg>");
    }

    private void Way(Body body, int until, string color)
    {
        int every = Math.Max(1, _times.Count / 100);
        IEnumerable<int> moments = Enumerable.Range(0, until + 1).Where(at => at % every == 0 || at == until);
        string points = string.Join(' ', moments.Select(at => Point(body.Centre(body.States[at]))));
        Line($"<polyline points=\"{points}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"1.5\" stroke-opacity=\"0.6\"/>");
    }

    private void Solid(Body body, in BodyState state, string color)
    {
        Vector3d centre = body.Centre(state);
        Quaterniond turn = state.Orientation.Normalized;
        foreach (Box box in body.Boxes.OrderByDescending(box => Flat(turn.Rotate(box.Position)).Depth))
        {
            Quaterniond axes = turn * box.Turn;
            Vector3d middle = centre + _larger * turn.Rotate(box.Position - body.CenterOfMass);
            foreach ((int[] corners, int axis, int side) in Faces)
            {
                Vector3d normal = axes.Rotate(side * new Vector3d(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0));
                if (Flat(normal).Depth >= 0)
                    continue;

                string points = string.Join(' ', corners.Select(corner => Point(middle + 0.5 * _larger * axes.Rotate(new Vector3d(
                    (corner & 1) == 0 ? -box.Edges.X : box.Edges.X, (corner & 2) == 0 ? -box.Edges.Y : box.Edges.Y, (corner & 4) == 0 ? -box.Edges.Z : box.Edges.Z)))));
                double shade = 0.15 + 0.15 * Vector3d.Dot(normal, new Vector3d(0.36, -0.8, 0.48));
                Line($"<polygon points=\"{points}\" fill=\"{color}\" stroke=\"#1c1d1f\" stroke-width=\"0.5\" stroke-opacity=\"0.6\" stroke-linejoin=\"round\"/>");
                Line($"<polygon points=\"{points}\" fill=\"{(shade > 0.15 ? "#000000" : "#ffffff")}\" fill-opacity=\"{Math.Abs(shade - 0.15) * 1.8:f2}\"/>");
            }
        }
    }

    private string Point(Vector3d p)
    {
        (double x, double y, _) = Flat(p);
        return string.Create(CultureInfo.InvariantCulture, $"{0.5 * Width + _scale * (x - _left):f1},{0.5 * Height - _scale * (y - _low):f1}");
    }

    private static (double X, double Y, double Depth) Flat(Vector3d p)
    {
        double x = Turn.Cos * p.X - Turn.Sin * p.Z, z = Turn.Sin * p.X + Turn.Cos * p.Z;
        return (x, Tilt.Cos * p.Y + Tilt.Sin * z, Tilt.Cos * z - Tilt.Sin * p.Y);
    }

    private void Line(FormattableString text) => _svg.Append(text.ToString(CultureInfo.InvariantCulture)).Append('\n');

    /// <summary>What an inertia looks like: boxes, and cylinders as square bars.</summary>
    private static IEnumerable<Box> Boxes(JsonNode inertia)
    {
        if (inertia["compound"] is JsonArray parts)
            return parts.SelectMany(part => Boxes(part!["inertia"]!).Select(box => box with { Position = part["position"] is JsonNode at ? Vector(at) : Vector3d.Zero }));

        if (inertia["solidCylinder"] is JsonNode cylinder)
        {
            double thick = 2 * cylinder["radius"]!.GetValue<double>();
            return [new Box(Vector3d.Zero, Quaterniond.Identity, new Vector3d(thick, cylinder["height"]!.GetValue<double>(), thick))];
        }

        return [new Box(Vector3d.Zero, Quaterniond.Identity, Vector(inertia["solidBox"] ?? inertia["boxVertices"]!))];
    }

    private static Vector3d Vector(JsonNode list) => new(list[0]!.GetValue<double>(), list[1]!.GetValue<double>(), list[2]!.GetValue<double>());

    private sealed record Box(Vector3d Position, Quaterniond Turn, Vector3d Edges);

    private sealed record Body(string Name, Vector3d CenterOfMass, Box[] Boxes)
    {
        public List<BodyState> States { get; } = [];

        public double Size => 2 * Boxes.Max(box => (box.Position - CenterOfMass).Length + 0.5 * box.Edges.Length);

        public Vector3d Centre(in BodyState state) => state.Position + state.Orientation.Normalized.Rotate(CenterOfMass);
    }
}
