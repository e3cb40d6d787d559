using System.Xml.Linq;

namespace RigidBodyDynamics.Lab.Inertia.Robots;

/// <summary>The five forms of an orientation in MJCF.</summary>
/// <param name="attributes">Reads numbers.</param>
/// <param name="inDegrees">The compiler's angle; degrees by default.</param>
/// <param name="sequence">The compiler's eulerseq: lower-case axes rotate with the body, upper-case axes are fixed.</param>
internal sealed class MjcfTurns(Attributes attributes, bool inDegrees, string sequence)
{
    /// <summary>The names of the attributes.</summary>
    public static readonly string[] Names = ["quat", "axisangle", "xyaxes", "zaxis", "euler"];

    private readonly double _unit = inDegrees ? Math.PI / 180 : 1;

    /// <summary>The orientation of an element; the identity by default.</summary>
    public Quaterniond Of(XElement element)
    {
        string[] said = [.. Names.Where(name => element.Attribute(name) != null)];
        if (said.Length > 1)
            throw attributes.Wrong(element, $"{said[0]} and {said[1]} exclude each other");

        if (said.Length == 0)
            return Quaterniond.Identity;

        double[] n = attributes.Numbers(element, said[0], 1, 6)!;
        Quaterniond turn = (said[0], n.Length) switch
        {
            ("quat", 4) => new Quaterniond(n[0], n[1], n[2], n[3]),
            ("axisangle", 4) => Quaterniond.FromAxisAngle(new Vector3d(n[0], n[1], n[2]).Normalized, n[3] * _unit),
            ("xyaxes", 6) => Axes(new Vector3d(n[0], n[1], n[2]), new Vector3d(n[3], n[4], n[5])),
            ("zaxis", 3) => ToZ(new Vector3d(n[0], n[1], n[2])),
            ("euler", 3) => Euler(n, element),
            _ => throw attributes.Wrong(element, $"{said[0]} has {n.Length} numbers"),
        };
        double square = turn.LengthSquared;
        return square > 1e-20 && square < 1e20 ? turn.Normalized : throw attributes.Wrong(element, $"{said[0]} is no orientation");
    }

    /// <summary>The shortest rotation that takes z to a direction.</summary>
    public static Quaterniond ToZ(Vector3d direction)
    {
        Vector3d z = direction.Normalized;
        // the quaternion of half the angle, up to its length: 1 + cos, and the axis times sin
        return z.Z > -1 + 1e-12 ? new Quaterniond(1 + z.Z, -z.Y, z.X, 0).Normalized : new Quaterniond(0, 1, 0, 0);
    }

    private static Quaterniond Axes(Vector3d x, Vector3d y)
    {
        x = x.Normalized;
        y = (y - Vector3d.Dot(x, y) * x).Normalized;
        // first z to its direction, then x about it
        Quaterniond first = ToZ(Vector3d.Cross(x, y));
        Vector3d left = first.RotateInverse(x);
        double angle = Math.Atan2(left.Y, left.X);
        return first * new Quaterniond(Math.Cos(angle / 2), 0, 0, Math.Sin(angle / 2));
    }

    private Quaterniond Euler(double[] angles, XElement element)
    {
        Quaterniond turn = Quaterniond.Identity;
        for (int i = 0; i < 3; i++)
        {
            char letter = i < sequence.Length ? sequence[i] : ' ';
            Vector3d axis = char.ToLowerInvariant(letter) switch
            {
                'x' => new Vector3d(1, 0, 0),
                'y' => new Vector3d(0, 1, 0),
                'z' => new Vector3d(0, 0, 1),
                _ => throw attributes.Wrong(element, $"compiler eulerseq must be three letters of xyzXYZ, found \"{sequence}\""),
            };
            Quaterniond one = angles[i] == 0 ? Quaterniond.Identity : Quaterniond.FromAxisAngle(axis, angles[i] * _unit);
            turn = char.IsLower(letter) ? turn * one : one * turn;
        }

        return turn;
    }
}
