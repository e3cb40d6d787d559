using System.Globalization;

namespace RigidBodyDynamics.Lab;

/// <summary>The recorded motion of a real Rigidbody: a row for its start and one after every step.</summary>
/// <param name="Path">The CSV file.</param>
/// <param name="Rows">Its rows; empty if there is no file.</param>
internal sealed record Recording(string Path, IReadOnlyList<float[]> Rows)
{
    /// <summary>The schema of a recording.</summary>
    public const string Schema = "free-rigid-body/1";

    /// <summary>The columns of a row after step and time.</summary>
    public static readonly string[] Columns = ["px", "py", "pz", "qx", "qy", "qz", "qw", "vx", "vy", "vz", "wx", "wy", "wz"];

    private const string Header = "step,t,px,py,pz,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz,wakeCounter,asleep";

    /// <summary>Reads the rows beside a JSON file.</summary>
    /// <param name="json">The JSON file.</param>
    /// <param name="steps">How many steps it has.</param>
    public static Recording Beside(string json, long steps)
    {
        string path = System.IO.Path.ChangeExtension(json, ".csv");
        if (!File.Exists(path))
        {
            return new Recording(path, []);
        }

        string[] lines = [.. File.ReadLines(path).Where(line => line.Length > 0)];
        if (lines.Length == 0 || lines[0] != Header)
        {
            throw new InputException($"{path}: line 1: must be {Header}");
        }

        if (lines.Length - 2 != steps)
        {
            throw new InputException($"{path}: must have {steps + 1} rows, one more than there are steps, found {lines.Length - 1}");
        }

        return new Recording(path, [.. lines.Skip(1).Select((line, i) => Row(line, path, i + 2))]);
    }

    /// <summary>Whether a recorded body slept after a step.</summary>
    public bool IsAsleep(int row) => Rows[row][Columns.Length + 1] != 0;

    private static float[] Row(string line, string path, int number)
    {
        string[] cells = line.Split(',');
        float[] row = new float[Columns.Length + 2];
        if (cells.Length != row.Length + 2)
        {
            throw new InputException($"{path}: line {number}: must have {row.Length + 2} numbers, found {cells.Length}");
        }

        for (int i = 0; i < row.Length; i++)
        {
            if (!float.TryParse(cells[i + 2], NumberStyles.Float, CultureInfo.InvariantCulture, out row[i]) || !float.IsFinite(row[i]))
            {
                throw new InputException($"{path}: line {number}: must be finite numbers, found {cells[i + 2]}");
            }
        }

        return row;
    }
}
