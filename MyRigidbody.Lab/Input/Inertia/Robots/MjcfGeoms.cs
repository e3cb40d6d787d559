using System.Xml.Linq;

namespace RigidBodyDynamics.Lab.Inertia.Robots;

/// <summary>A geom of an MJCF.</summary>
/// <param name="Element">As in the file.</param>
/// <param name="Full">With the attributes of its default class.</param>
/// <param name="Position">Of the frame around it, in the body.</param>
/// <param name="Turn">Of the frame around it.</param>
/// <param name="Attributes">Reads numbers.</param>
internal sealed record MjcfGeom(XElement Element, XElement Full, Vector3d Position, Quaterniond Turn, Attributes Attributes)
{
    /// <summary>Its group, 0 if it says none.</summary>
    public double Group => Attributes.Number(Full, "group", 0);

    /// <summary>True unless it is visual only.</summary>
    public bool Collides => Attributes.Number(Full, "contype", 1) != 0 || Attributes.Number(Full, "conaffinity", 1) != 0;
}

/// <summary>The solids of the geoms of an MJCF.</summary>
internal sealed class MjcfGeoms
{
    private const double Water = 1000;
    private readonly Attributes _attributes;
    private readonly MjcfTurns _turns;
    private readonly RobotMeshes _meshes;
    private readonly string _meshFolder;
    private readonly bool _stripPath;
    private readonly Dictionary<string, XElement> _assets = [];

    public MjcfGeoms(Attributes attributes, MjcfTurns turns, RobotMeshes meshes, XElement mujoco, string meshFolder, bool stripPath)
    {
        (_attributes, _turns, _meshes, _meshFolder, _stripPath) = (attributes, turns, meshes, meshFolder, stripPath);
        MjcfDefaults defaults = new(mujoco);
        foreach (XElement mesh in mujoco.Elements("asset").Elements("mesh"))
        {
            string? file = mesh.Attribute("file")?.Value;
            if ((mesh.Attribute("name")?.Value ?? Path.GetFileNameWithoutExtension(file)) is string name)
                _assets[name] = defaults.With(mesh);
        }
    }

    /// <summary>The solid, its density, and its place in the body; null for a geom without mass, such as a plane.</summary>
    /// <exception cref="OmittedException">It is not understood, or its mesh cannot be read.</exception>
    public (Shape Shape, double Density, Vector3d Position, Quaterniond Turn)? Solid(MjcfGeom geom)
    {
        XElement full = geom.Full;
        string type = full.Attribute("type")?.Value ?? (full.Attribute("mesh") != null ? "mesh" : "sphere");
        if (type is "plane" or "hfield")
            return null;

        if (full.Attribute("shellinertia")?.Value == "true")
            throw new OmittedException("shellinertia=\"true\" is not understood");

        double[] size = full.Attribute("size") == null ? [] : _attributes.Numbers(full, "size", 1, 3)!;
        Vector3d position = _attributes.Vector(full, "pos") ?? Vector3d.Zero;
        Quaterniond turn = _turns.Of(full);
        if (full.Attribute("fromto") != null && type is "capsule" or "cylinder" or "box" or "ellipsoid")
        {
            double[] ends = _attributes.Numbers(full, "fromto", 6, 6)!;
            Vector3d from = new(ends[0], ends[1], ends[2]), to = new(ends[3], ends[4], ends[5]);
            position = 0.5 * (from + to);
            turn = MjcfTurns.ToZ(to - from);
            double half = 0.5 * (to - from).Length;
            double first = size.Length > 0 ? size[0] : throw _attributes.Wrong(geom.Element, "size is missing");
            size = type is "capsule" or "cylinder" ? [first, half] : [first, size.Length > 1 ? size[1] : first, half];
        }

        Shape shape = type == "mesh" ? Mesh(geom, full) : Primitive(geom, type, size);
        double volume = shape.Filled.Mass, density = full.Attribute("mass") != null ? _attributes.Number(full, "mass") / volume : _attributes.Number(full, "density", Water);
        return density == 0 ? null : (shape, density, geom.Position + geom.Turn.Rotate(position), geom.Turn * turn);
    }

    // half lengths, as everywhere in MJCF
    private Shape Primitive(MjcfGeom geom, string type, double[] size)
    {
        int needed = type switch { "sphere" => 1, "capsule" or "cylinder" => 2, "box" or "ellipsoid" => 3, _ => throw new OmittedException($"type=\"{type}\" is not understood") };
        if (geom.Full.Attribute("mesh") != null)
            throw new OmittedException($"a {type} that is fitted to a mesh is not understood");

        if (size.Length < needed)
            throw _attributes.Wrong(geom.Element, $"size of a {type} must have {needed} number{(needed > 1 ? "s" : string.Empty)}, found {size.Length}");

        return type switch
        {
            "sphere" => Shape.Sphere(size[0]),
            "capsule" => Shape.Capsule(size[0], 2 * size[1]),
            "cylinder" => Shape.Cylinder(size[0], 2 * size[1]),
            "box" => Shape.Box(2 * new Vector3d(size[0], size[1], size[2])),
            _ => Shape.Ellipsoid(new Vector3d(size[0], size[1], size[2])),
        };
    }

    private Shape Mesh(MjcfGeom geom, XElement full)
    {
        string name = full.Attribute("mesh")?.Value ?? throw _attributes.Wrong(geom.Element, "mesh is missing");
        if (!_assets.TryGetValue(name, out XElement? asset) || asset.Attribute("file")?.Value is not string file)
            throw new OmittedException($"mesh \"{name}\" has no file among the assets");

        if (asset.Attribute("refpos") != null || asset.Attribute("refquat") != null || asset.Attribute("inertia")?.Value == "shell")
            throw new OmittedException($"mesh \"{name}\" has refpos, refquat or inertia=\"shell\", which are not understood");

        string path = Path.Combine(_meshFolder, _stripPath ? Path.GetFileName(file) : file);
        return _meshes.Shape(path, _attributes.Vector(asset, "scale") ?? new Vector3d(1, 1, 1));
    }
}
