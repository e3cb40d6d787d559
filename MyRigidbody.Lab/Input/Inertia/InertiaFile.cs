using System.Xml.Linq;
using RigidBodyDynamics.Lab.Inertia.Robots;
using RigidBodyDynamics.Lab.Meshes;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Inertia;

/// <summary>The bodies of a file: a scene, a mesh or a robot description.</summary>
/// <param name="Path">The file, as typed.</param>
/// <param name="Kind">"scene", "STL", "OBJ", "URDF" or "MJCF".</param>
/// <param name="Bodies">Possible or not.</param>
/// <param name="Notes">Notes about the whole file.</param>
internal sealed record InertiaFile(string Path, string Kind, IReadOnlyList<DescribedBody> Bodies, IReadOnlyList<string> Notes)
{
    // a mesh has no unit; a part this large is probably in millimetres
    private const double LargePart = 5;

    /// <summary>Reads a file; any error in the file is an <see cref="InputException"/>.</summary>
    public static InertiaFile Read(string path, Filling? filling)
    {
        string extension = System.IO.Path.GetExtension(path).ToLowerInvariant();
        bool isMesh = MeshFile.HasKnownName(path);
        if (!isMesh && filling != null)
            throw new InputException($"{path}: --mass, --density and --scale are for meshes, and this file says it itself");

        return extension switch
        {
            _ when isMesh => Mesh(path, filling ?? new Filling(null, Filling.Water, 1)),
            ".json" => new InertiaFile(path, "scene", SceneBodies.Read(path), []),
            ".urdf" or ".xml" or ".mjcf" => Robot(path, XmlFile.Read(path)),
            ".xacro" => throw new InputException($"{path}: is xacro, which must be expanded first (xacro FILE > FILE.urdf)"),
            _ => throw new InputException($"{path}: must be a scene (.json), a mesh (.stl, .obj), a URDF (.urdf, .xml) or an MJCF (.xml, .mjcf)"),
        };
    }

    private static InertiaFile Robot(string path, XElement root)
    {
        switch (root.Name.LocalName)
        {
            case "robot":
                return new InertiaFile(path, "URDF", new UrdfReader(path).Read(root), []);
            case "mujoco":
                MjcfReader reader = new(path, root);
                return new InertiaFile(path, "MJCF", reader.Read(), reader.Notes);
            default:
                string name = root.Name.LocalName;
                throw XmlFile.Wrong(path, root, $"<{(name.Length > 40 ? name[..40] + "…" : name)}> is neither <robot>, of URDF, nor <mujoco>, of MJCF");
        }
    }

    private static InertiaFile Mesh(string path, Filling filling)
    {
        MeshFile mesh = MeshFile.Read(path).Scaled(filling.Scale * new Vector3d(1, 1, 1));
        MassProperties mass = filling.Mass is double kilograms ? mesh.Weighing(kilograms) : mesh.OfDensity(filling.Density);
        Shape shape = Shape.Mesh(mesh);
        Vector3d size = shape.High - shape.Low;
        List<string> notes = [FormattableString.Invariant($"{mesh.Triangles.Length / 3} triangles, closed; {Tensors.Short(size.X)} × {Tensors.Short(size.Y)} × {Tensors.Short(size.Z)} m, {Tensors.Short(shape.Filled.Mass)} m³")];
        if (mesh.Collapsed > 0)
            notes.Add(FormattableString.Invariant($"{mesh.Collapsed} triangles with two equal corners are left out"));

        if (filling.Mass == null)
            notes.Add(FormattableString.Invariant($"as heavy as {filling.Density:R} kg/m³ make it{(filling.Density == Filling.Water ? ", which is water; --mass or --density says another" : string.Empty)}"));

        List<Finding> faults = [];
        if (Math.Max(size.X, Math.Max(size.Y, size.Z)) > LargePart && filling.Scale == 1)
            faults.Add(new Finding("units", Severity.Doubtful, $"the part is {Tensors.Short(size.X)} m × {Tensors.Short(size.Y)} m × {Tensors.Short(size.Z)} m large; a mesh has no unit, and in millimetres it wants --scale 0.001"));

        DescribedBody body = new(System.IO.Path.GetFileNameWithoutExtension(path), string.Empty)
        {
            Mass = mass.Mass,
            Center = mass.CenterOfMass,
            Tensor = mass.Inertia,
            IsComputed = true,
            Notes = notes,
            Faults = faults,
        };
        return new InertiaFile(path, System.IO.Path.GetExtension(path)[1..].ToUpperInvariant(), [body], []);
    }
}

/// <summary>The material of a mesh.</summary>
/// <param name="Mass">kg; null if the density gives it.</param>
/// <param name="Density">kg/m³.</param>
/// <param name="Scale">The factor for every length of the file.</param>
internal sealed record Filling(double? Mass, double Density, double Scale)
{
    /// <summary>The default density of MuJoCo.</summary>
    public const double Water = 1000;
}
