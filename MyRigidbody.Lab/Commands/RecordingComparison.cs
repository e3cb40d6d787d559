using System.Globalization;
using RigidBodyDynamics.Lab.Animation;
using RigidBodyDynamics.Lab.Comparison;
using RigidBodyDynamics.Lab.Languages;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Lab.Report;

namespace RigidBodyDynamics.Lab.Commands;

/// <summary>The distance of our UnityRigidbody from a recorded Rigidbody, or of LabEuler from a recorded script, and the first difference.</summary>
internal sealed class RecordingComparison
{
    private static readonly (string Name, string Unit, int First, int Count)[] AllParts =
        [("position", "m", 0, 3), ("orientation", "", 3, 4), ("velocity", "m/s", 7, 3), ("angular velocity", "rad/s", 10, 3)];

    private readonly (string Name, string Unit, int First, int Count)[] _judged;
    private readonly double[] _farthest;
    private readonly List<Compared> _course = [];
    private string? _difference;

    // a script's velocities are only differences of its poses
    private RecordingComparison(Recording recording)
    {
        _judged = recording.IsOfScript ? AllParts[..2] : AllParts;
        _farthest = new double[_judged.Length];
    }

    private double Farthest => _farthest.Max();

    /// <summary>Compares, prints, writes; throws if the difference exceeds the tolerance.</summary>
    public static int Execute(SceneFile file, Recording recording, string folder, double tolerance)
    {
        if (!(tolerance >= 0))
            throw new InputException(FormattableString.Invariant($"--tolerance: must not be below 0, found {tolerance}"));

        if (recording.Rows.Count == 0)
            throw new InputException($"{recording.Path}: there is no such file, and compare needs the states that were recorded");

        if (folder.Length > 0 && RealPath.Same(folder, Path.GetDirectoryName(Path.GetFullPath(file.Path))!))
            throw new InputException($"--out: must be another folder than the recording's own, found {folder}");

        RecordingComparison found = new(recording);
        Simulation simulation = new(file.Scene);
        found.Look(simulation, recording);
        while (simulation.StepsDone < file.Scene.Steps.Count)
        {
            simulation.Step();
            found.Look(simulation, recording);
        }

        Pictures.NoteIfThereAreNoFonts();
        using Files files = new(folder, folder, file.Inputs);
        files.Write("trajectory.csv", to => TrajectoryCsv.Write(new Simulation(file.Scene), file.Path, to));
        files.Write("summary.json", to => File.WriteAllText(to, found.Json(file.Scene)));
        Motion motion = Motion.Of(file, Words.All["recorded"].With(file.Scene.Bodies[0].Name).En, found._course, knowsSpin: !recording.IsOfScript);
        foreach (string format in new[] { ".png", ".svg" })
            files.Write("apart" + format, to => Pictures.Save(ComparePictures.Apart($"{file.Scene.Name}: how far {file.Scene.Bodies[0].Rule.Name} is from the recording", found._course), to));

        MotionPictures.Write(file.Scene.Name, motion, files);
        files.Write(Reports.FileName, to => PageWriter.Write(
            Reports.Of(file, simulation, new RecordingTable(found.Lead(file.Scene), found.Verdict(tolerance), [.. found.Rows()]), motion), to));
        files.Keep();
        found.Print(file.Scene, folder);
        return found.Farthest <= tolerance
            ? 0
            : throw new FellShortException(FormattableString.Invariant(
                $"{file.Path}: up to {found.Farthest:G3} from the recording, more than the tolerance {tolerance:G3}"));
    }

    private static double[] Values(in BodyState s) =>
    [
        s.Position.X, s.Position.Y, s.Position.Z,
        s.Orientation.X, s.Orientation.Y, s.Orientation.Z, s.Orientation.W,
        s.Velocity.X, s.Velocity.Y, s.Velocity.Z,
        s.AngularVelocity.X, s.AngularVelocity.Y, s.AngularVelocity.Z,
    ];

    private static BodyState State(float[] row) => new(
        new Vector3d(row[0], row[1], row[2]),
        new Quaterniond(row[6], row[3], row[4], row[5]),
        new Vector3d(row[7], row[8], row[9]),
        new Vector3d(row[10], row[11], row[12]));

    // q and −q are one orientation, and a script may hold either
    private static float[] WithSignOf(Quaterniond ours, float[] row)
    {
        double cosine = ours.X * row[3] + ours.Y * row[4] + ours.Z * row[5] + ours.W * row[6];
        return cosine >= 0 ? row : [.. row[..3], -row[3], -row[4], -row[5], -row[6], .. row[7..]];
    }

    private void Look(Simulation simulation, Recording recording)
    {
        int row = (int)simulation.StepsDone;
        BodyState state = simulation.Bodies[0].State, recorded = State(recording.Rows[row]);
        double[] ours = Values(state);
        float[] theirs = recording.IsOfScript ? WithSignOf(state.Orientation, recording.Rows[row]) : recording.Rows[row];
        double distance = (state.Position - recorded.Position).Length, angle = Conserved.AngleBetween(state.Orientation, recorded.Orientation);
        _course.Add(new Compared(row, state, recorded, new Moment(simulation.Time, distance, angle, angle)));
        for (int part = 0; part < _judged.Length; part++)
        {
            for (int i = _judged[part].First; i < _judged[part].First + _judged[part].Count; i++)
            {
                double difference = Math.Abs(ours[i] - theirs[i]);
                _farthest[part] = difference > _farthest[part] || double.IsNaN(difference) ? difference : _farthest[part];
                // equal numbers have equal bits, except for the sign of zero, which recordings do not keep
                if ((float)ours[i] != theirs[i])
                    _difference ??= string.Create(CultureInfo.InvariantCulture, $"step {row}, {Recording.Columns[i]}: {(float)ours[i]:R} here, {theirs[i]:R} recorded");
            }
        }

        if (simulation.Bodies[0].IsAsleep != recording.IsAsleep(row))
            _difference ??= string.Create(CultureInfo.InvariantCulture, $"step {row}: {(recording.IsAsleep(row) ? "awake here, asleep" : "asleep here, awake")} in the recording");
    }

    private void Print(SceneDescription scene, string folder)
    {
        TextTable table = new("of", "largest difference");
        foreach (RecordingTable.Row row in Rows())
            table.AddRow(row.What.En, row.Largest);

        Terminal.WriteText($"{scene.Name}: {scene.About}");
        Terminal.WriteText(Lead(scene).En);
        Terminal.Write(table);
        Terminal.WriteText($"Written to {folder}: trajectory.csv, summary.json, pictures (.png, .svg), replay.png, which moves, and {Reports.FileName}, to open in the browser");
    }

    private Word Lead(SceneDescription scene) => _difference == null
        ? Words.All["recording.same"].With(scene.Bodies[0].Rule.Name, scene.Steps.Count)
        : Words.All["recording.parts"].With(scene.Bodies[0].Rule.Name, Words.Said(_difference));

    private Word Verdict(double tolerance) => (Farthest <= tolerance ? Words.All["recording.within"] : Words.All["recording.beyond"]).With(
        Farthest.ToString("G3", CultureInfo.InvariantCulture), tolerance.ToString("G3", CultureInfo.InvariantCulture));

    private IEnumerable<RecordingTable.Row> Rows() => _judged.Select((part, i) => new RecordingTable.Row(
        Words.Phrase(part.Name),
        string.Create(CultureInfo.InvariantCulture, $"{_farthest[i]:G3} {part.Unit}").Trim()));

    private string Json(SceneDescription scene) => CompareSummary.Text(
        new
        {
            recording = scene.Name,
            steps = scene.Steps.Count,
            bitForBit = _difference == null,
            firstParts = _difference,
            largestDifference = _judged.Select((part, i) => (part.Name, Value: _farthest[i])).ToDictionary(part => part.Name, part => part.Value),
        }) + "\n";
}
