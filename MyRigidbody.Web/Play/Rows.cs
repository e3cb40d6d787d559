using System.Runtime.InteropServices;

namespace RigidBodyDynamics.Web.Play;

/// <summary>
/// Numbers that the page reads in this program's memory. A row is a moment: the time; for each body position (3), orientation (4),
/// angular velocity (3) and energy; for each pair distance and angle in degrees. Poses of the script (7) are before the rows.
/// </summary>
internal sealed class Rows
{
    /// <summary>The number of rows.</summary>
    public const int Most = 64;

    private const int PerBody = 11, PerPair = 2, PerPose = 7;

    private double[] _numbers = [];
    private int _at;

    /// <summary>The number of numbers in a row.</summary>
    public int Width { get; private set; }

    /// <summary>The address of the script's poses, followed by the rows, in the memory of the page's program.</summary>
    public nint Address => Marshal.UnsafeAddrOfPinnedArrayElement(_numbers, 0);

    /// <summary>Makes room for the rows of a motion.</summary>
    public void Fit(Course course)
    {
        int bodies = course.Bodies.Count + (course.Script != null ? 1 : 0);
        Width = 1 + PerBody * bodies + PerPair * PairsOf(course).Count();
        int length = Most * (PerPose + Width);
        if (_numbers.Length < length)
            _numbers = GC.AllocateArray<double>(length, pinned: true);
    }

    /// <summary>The compared pairs, including those of the script's object with the first body and with Unity's.</summary>
    public static IEnumerable<(int First, int Second)> PairsOf(Course course) => course.Script == null
        ? course.Pairs
        : [.. course.Pairs, (0, course.Bodies.Count), .. course.Pairs.Take(1).Select(pair => (pair.Second, course.Bodies.Count))];

    /// <summary>The pose of the script after the step of a row.</summary>
    public (Vector3d Position, Quaterniond Orientation) Pose(int row)
    {
        ReadOnlySpan<double> n = _numbers.AsSpan(PerPose * row, PerPose);
        return (new Vector3d(n[0], n[1], n[2]), new Quaterniond(n[3], n[4], n[5], n[6]));
    }

    /// <summary>Writes the states of all bodies.</summary>
    public void Write(Course course, int row)
    {
        _at = Most * PerPose + Width * row;
        Put(course.Time);
        foreach (Body body in course.Bodies)
            Put(body.State, body.Mass);

        if (course.Script is { } script)
            Put(script.State, script.Mass);

        foreach ((int first, int second) in PairsOf(course))
        {
            BodyState a = StateOf(course, first), b = StateOf(course, second);
            Put((a.Position - b.Position).Length);
            Put(Conserved.AngleBetween(a.Orientation, b.Orientation) * 180 / Math.PI);
        }
    }

    private static BodyState StateOf(Course course, int body) => body < course.Bodies.Count ? course.Bodies[body].State : course.Script!.State;

    private void Put(in BodyState state, MassProperties mass)
    {
        Put(state.Position);
        Put(state.Orientation.W);
        Put(state.Orientation.X);
        Put(state.Orientation.Y);
        Put(state.Orientation.Z);
        Put(state.AngularVelocity);
        Put(Conserved.KineticEnergy(state, mass));
    }

    private void Put(Vector3d v)
    {
        Put(v.X);
        Put(v.Y);
        Put(v.Z);
    }

    private void Put(double number) => _numbers[_at++] = number;
}
