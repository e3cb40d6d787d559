using System.Globalization;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab;

/// <summary>The recorded motion of a real Rigidbody, or of an object that a student's script moves: a row for its start and one after every step.</summary>
/// <param name="Path">The CSV file.</param>
/// <param name="Rows">Its rows; empty if there is no file.</param>
/// <param name="IsOfScript">True if a script was recorded: its velocities are differences of its poses.</param>
internal sealed record Recording(string Path, IReadOnlyList<float[]> Rows, bool IsOfScript = false)
{
    /// <summary>The schema of a recording.</summary>
    public const string Schema = "free-rigid-body/1";

    /// <summary>The schema of a recorded script, of which only the pose is known.</summary>
    public const string ScriptSchema = "lab-script/1";

    /// <summary>The columns of a row after step and time.</summary>
    public static readonly string[] Columns = ["px", "py", "pz", "qx", "qy", "qz", "qw", "vx", "vy", "vz", "wx", "wy", "wz"];

    private const string Header = "step,t,px,py,pz,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz,wakeCounter,asleep";

    /// <summary>Reads the rows beside a JSON file.</summary>
    /// <param name="json">The JSON file.</param>
    /// <param name="steps">The number of steps.</param>
    public static Recording Beside(string json, long steps)
    {
        string path = System.IO.Path.ChangeExtension(json, ".csv");
        if (!File.Exists(path))
            return new Recording(path, []);

        ArraySegment<byte> bytes = InputFile.Bytes(path);
        using StreamReader lines = new(new MemoryStream(bytes.Array!, bytes.Offset, bytes.Count));
        if (lines.ReadLine() != Header)
            throw new InputException($"{path}: line 1: must be {Header}");

        List<float[]> rows = new((int)steps + 1);
        for (int number = 2; lines.ReadLine() is string line; number++)
        {
            if (rows.Count > steps && line.Length > 0)
                throw WrongCount("more");

            if (line.Length > 0)
                rows.Add(Row(line, path, number));
        }

        return rows.Count > steps ? new Recording(path, rows) : throw WrongCount(rows.Count.ToString(CultureInfo.InvariantCulture));

        InputException WrongCount(string found) => new($"{path}: must have {steps + 1} rows, one more than there are steps, found {found}");
    }

    /// <summary>Whether a recorded body slept after a step.</summary>
    public bool IsAsleep(int row) => Rows[row][Columns.Length + 1] != 0;

    private static float[] Row(string line, string path, int number)
    {
        float[] row = new float[Columns.Length + 2];
        int found = line.AsSpan().Count(',') + 1;
        if (found != row.Length + 2)
            throw new InputException($"{path}: line {number}: must have {row.Length + 2} numbers, found {found}");

        int i = -2;
        foreach (Range range in line.AsSpan().Split(','))
        {
            ReadOnlySpan<char> cell = line.AsSpan(range);
            if (i >= 0 && !(float.TryParse(cell, NumberStyles.Float, CultureInfo.InvariantCulture, out row[i]) && float.IsFinite(row[i])))
                throw new InputException($"{path}: line {number}: must be finite numbers, found {Place.Shown(cell.ToString())} as {Header.Split(',')[i + 2]}");

            i++;
        }

        return row;
    }
}
