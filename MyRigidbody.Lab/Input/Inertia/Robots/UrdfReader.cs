using System.Xml.Linq;

namespace RigidBodyDynamics.Lab.Inertia.Robots;

/// <summary>
/// Reads the links of a URDF: mass, the tensor about the centre of mass in the axes of inertial/origin (rpy: about the fixed axes x, y, z,
/// one after another), and collision geometry, or visual where there is none (wiki.ros.org/urdf/XML/link).
/// </summary>
internal sealed class UrdfReader(string file)
{
    private static readonly string[] Elements = ["ixx", "iyy", "izz", "ixy", "ixz", "iyz"];
    private readonly Attributes _attributes = new(file);
    private readonly RobotMeshes _meshes = new(file);

    /// <summary>All links.</summary>
    public IReadOnlyList<DescribedBody> Read(XElement robot) =>
        [.. robot.Elements().Where(element => element.Name.LocalName == "link").Select(Link)];

    private DescribedBody Link(XElement link)
    {
        string name = link.Attribute("name")?.Value ?? "(a link without a name)";
        DescribedBody body = new(name, XmlFile.Line(link));
        if (Child(link, "inertial") is not XElement inertial)
            return body;

        List<string> notes = [];
        List<Finding> faults = [];
        (Vector3d center, Quaterniond axes) = Origin(Child(inertial, "origin"), faults);
        XElement mass = Child(inertial, "mass") ?? throw _attributes.Wrong(inertial, "mass is missing");
        XElement inertia = Child(inertial, "inertia") ?? throw _attributes.Wrong(inertial, "inertia is missing");
        if (!Elements.Any(element => inertia.Attribute(element) != null))
            throw _attributes.Wrong(inertia, "ixx is missing");

        double[] n = [.. Elements.Select((element, i) => i < 3 ? _attributes.Number(inertia, element) : _attributes.Number(inertia, element, 0))];
        double[] half = TypedDigits.HalfUnits([.. Elements.Select(element => inertia.Attribute(element)?.Value.Trim() ?? string.Empty)]);
        return body with
        {
            Mass = _attributes.Number(mass, "value"),
            Center = center,
            Axes = axes,
            Tensor = Tensor(n),
            HalfDigits = Tensor(half),
            Geometry = Geometry(link, "collision", notes) ?? Geometry(link, "visual", notes),
            Notes = notes,
            Faults = faults,
        };
    }

    /// <summary>xx, yy, zz, xy, xz, yz.</summary>
    public static SymmetricMatrix3 Tensor(double[] n) => new() { XX = n[0], YY = n[1], ZZ = n[2], XY = n[3], XZ = n[4], YZ = n[5] };

    private (Vector3d Position, Quaterniond Turn) Origin(XElement? origin, List<Finding> faults)
    {
        Vector3d rpy = _attributes.Vector(origin, "rpy") ?? Vector3d.Zero;
        if (Math.Max(Math.Abs(rpy.X), Math.Max(Math.Abs(rpy.Y), Math.Abs(rpy.Z))) > (2 * Math.PI) + 1e-3)
            faults.Add(new Finding("degrees", Severity.Doubtful, $"rpy is {rpy}, more than a whole revolution: URDF wants radians, and these may be degrees"));

        Quaterniond turn = About(new Vector3d(0, 0, 1), rpy.Z) * About(new Vector3d(0, 1, 0), rpy.Y) * About(new Vector3d(1, 0, 0), rpy.X);
        return (_attributes.Vector(origin, "xyz") ?? Vector3d.Zero, turn);

        static Quaterniond About(Vector3d axis, double angle) => angle == 0 ? Quaterniond.Identity : Quaterniond.FromAxisAngle(axis, angle);
    }

    /// <summary>All geometry of a kind; null where there is none, or where a part is not understood: a part alone would be another body.</summary>
    private Geometry? Geometry(XElement link, string kind, List<string> notes)
    {
        Geometry all = new();
        foreach (XElement part in link.Elements().Where(element => element.Name.LocalName == kind))
        {
            XElement? shape = Child(part, "geometry")?.Elements().FirstOrDefault();
            try
            {
                (Vector3d position, Quaterniond turn) = Origin(Child(part, "origin"), []);
                all.Add(shape == null ? throw new OmittedException("geometry is missing") : Shape(shape), position, turn);
            }
            catch (ArgumentException refused)
            {
                throw XmlFile.Wrong(file, shape ?? part, refused.Message);
            }
            catch (OmittedException missing)
            {
                notes.Add($"not compared with its {kind}: {missing.Message}");
                return null;
            }
        }

        return all.Count > 0 ? all : null;
    }

    private Shape Shape(XElement shape)
    {
        switch (shape.Name.LocalName)
        {
            case "box": return Inertia.Shape.Box(_attributes.Vector(shape, "size") ?? throw _attributes.Wrong(shape, "size is missing"));
            case "sphere": return Inertia.Shape.Sphere(_attributes.Number(shape, "radius"));
            case "cylinder": return Inertia.Shape.Cylinder(_attributes.Number(shape, "radius"), _attributes.Number(shape, "length"));
            case "capsule": return Inertia.Shape.Capsule(_attributes.Number(shape, "radius"), _attributes.Number(shape, "length"));
            case "mesh":
                string name = shape.Attribute("filename")?.Value ?? throw _attributes.Wrong(shape, "filename is missing");
                return _meshes.Shape(name, _attributes.Vector(shape, "scale") ?? new Vector3d(1, 1, 1));
            default: throw new OmittedException($"<{shape.Name.LocalName}> is not understood");
        }
    }

    private static XElement? Child(XElement element, string name) => element.Elements().FirstOrDefault(child => child.Name.LocalName == name);
}
