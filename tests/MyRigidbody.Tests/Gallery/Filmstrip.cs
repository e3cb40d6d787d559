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

    // the corners of each side of a box, in the order around its outward normal
    private static readonly int[][] Sides = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];

    // the camera: from the front, a little from the right and above; Unity's z points away from it
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
        _bodies.AddRange(file.Scene.Bodies.Select((body, i) => new Body(body.Name, body.Mass.CenterOfMass, [.. Faces(root["bodies"]![i]!["inertia"]!, Path.GetDirectoryName(path)!)])));
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
        foreach (Face face in body.Faces.OrderByDescending(face => Flat(turn.Rotate(face.Middle)).Depth))
        {
            Vector3d normal = turn.Rotate(face.Normal);
            if (Flat(normal).Depth >= 0)
                continue;

            string points = string.Join(' ', face.Corners.Select(corner => Point(centre + _larger * turn.Rotate(corner - body.CenterOfMass))));
            double shade = 0.27 * Vector3d.Dot(normal, new Vector3d(0.36, -0.8, 0.48));
            Line($"<polygon points=\"{points}\" fill=\"{color}\" stroke=\"#1c1d1f\" stroke-width=\"0.5\" stroke-opacity=\"{(body.Faces.Length > 100 ? 0.15 : 0.6)}\" stroke-linejoin=\"round\"/>");
            Line($"<polygon points=\"{points}\" fill=\"{(shade > 0 ? "#000000" : "#ffffff")}\" fill-opacity=\"{Math.Abs(shade):f2}\"/>");
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

    /// <summary>What an inertia looks like: boxes, cylinders as square bars, meshes as they are.</summary>
    private static IEnumerable<Face> Faces(JsonNode inertia, string folder)
    {
        if (inertia["compound"] is JsonArray parts)
            return parts.SelectMany(part => Faces(part!["inertia"]!, folder).Select(face => face.Moved(part["position"] is JsonNode at ? Vector(at) : Vector3d.Zero)));

        if (inertia["mesh"] is JsonNode mesh)
            return OfMesh(File.ReadAllLines(Path.Combine(folder, mesh.GetValue<string>())), Vector(inertia["scale"]!));

        if (inertia["solidCylinder"] is JsonNode cylinder)
        {
            double thick = 2 * cylinder["radius"]!.GetValue<double>();
            return OfBox(new Vector3d(thick, cylinder["height"]!.GetValue<double>(), thick));
        }

        return OfBox(Vector(inertia["solidBox"] ?? inertia["boxVertices"]!));
    }

    private static IEnumerable<Face> OfBox(Vector3d edges) => Sides.Select(side => new Face([.. side.Select(corner => 0.5 * new Vector3d(
        (corner & 1) == 0 ? -edges.X : edges.X, (corner & 2) == 0 ? -edges.Y : edges.Y, (corner & 4) == 0 ? -edges.Z : edges.Z))]));

    private static IEnumerable<Face> OfMesh(string[] lines, Vector3d scale)
    {
        string[][] words = [.. lines.Select(line => line.Split(' ', StringSplitOptions.RemoveEmptyEntries))];
        Vector3d[] points = [.. words.Where(word => word is ["v", ..]).Select(word => Vector3d.Scale(scale, new Vector3d(Number(word[1]), Number(word[2]), Number(word[3]))))];
        return words.Where(word => word is ["f", ..]).Select(word => new Face([.. word.Skip(1).Select(corner => points[int.Parse(corner.Split('/')[0], CultureInfo.InvariantCulture) - 1])]));

        static double Number(string word) => double.Parse(word, CultureInfo.InvariantCulture);
    }

    private static Vector3d Vector(JsonNode list) => new(list[0]!.GetValue<double>(), list[1]!.GetValue<double>(), list[2]!.GetValue<double>());

    private sealed record Face(Vector3d[] Corners)
    {
        public Vector3d Middle => Corners.Aggregate(Vector3d.Zero, (sum, corner) => sum + corner) / Corners.Length;

        // Newell's sum: three corners of a side may be on a line
        public Vector3d Normal { get; } = Corners.Zip(Corners.Skip(1).Append(Corners[0]), (a, b) => Vector3d.Cross(a - Corners[0], b - Corners[0]))
            .Aggregate(Vector3d.Zero, (sum, part) => sum + part) is var twice ? twice / twice.Length : Vector3d.Zero;

        public Face Moved(Vector3d by) => new([.. Corners.Select(corner => corner + by)]);
    }

    private sealed record Body(string Name, Vector3d CenterOfMass, Face[] Faces)
    {
        public List<BodyState> States { get; } = [];

        public double Size => 2 * Faces.SelectMany(face => face.Corners).Max(corner => (corner - CenterOfMass).Length);

        public Vector3d Centre(in BodyState state) => state.Position + state.Orientation.Normalized.Rotate(CenterOfMass);
    }
}
