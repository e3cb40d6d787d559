using System.Globalization;
using System.Numerics;

namespace RigidBodyDynamics.UnityFiles.Drawing;

/// <summary>The pose of an object.</summary>
/// <param name="Position">Its position, m.</param>
/// <param name="Rotation">Its orientation.</param>
public sealed record Pose(Vector3 Position, Quaternion Rotation)
{
    private static readonly string[] Columns = ["body", "t", "px", "py", "pz", "qw", "qx", "qy", "qz"];

    /// <summary>The poses at a time in a file of the command line's <c>run</c>: of each body the first row that is not before it.</summary>
    public static Dictionary<string, Pose> Read(string path, double time)
    {
        Dictionary<string, Pose> poses = [];
        using StreamReader file = new(path);
        string[] header = (file.ReadLine() ?? string.Empty).Split(',');
        int[] at = [.. Columns.Select(name => Array.IndexOf(header, name))];
        if (at.Contains(-1))
            throw new FormatException($"{path}: needs the columns {string.Join(", ", Columns)}");

        while (file.ReadLine() is string line)
        {
            string[] cells = line.Split(',');
            float[] n = [.. at.Skip(1).Select(column => float.Parse(cells[column], CultureInfo.InvariantCulture))];
            if (n[0] > time - 1e-6)
                poses.TryAdd(cells[at[0]], new Pose(new Vector3(n[1], n[2], n[3]), new Quaternion(n[5], n[6], n[7], n[4])));
        }

        return poses;
    }
}
