using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab;

/// <summary>
/// Reads mass, inertia and centre of mass of a body, or of a part of one. A new kind of inertia is one line in the table, which states its
/// form; the schema is made from it.
/// </summary>
internal static class InertiaReader
{
    // nesting of compounds; enough for any drawing, and safe for the stack
    private const int Deepest = 8;

    // the sum of masses may be rounded in the file, no more
    private const double SameMass = 1e-9;

    // the names of a tensor's numbers in URDF and SDF
    private static readonly string[] Robots = ["ixx", "iyy", "izz", "ixy", "ixz", "iyz"];
    private static readonly string[] Axes = ["x", "y", "z"];
    private static readonly Vector3d Ones = new(1, 1, 1);

    // shared, because a file with many bodies of which little is given would hold many copies
    private static readonly MassProperties UnitBox = Solids.Box(1, Ones);

    private static readonly Dictionary<string, Kind> Kinds = new()
    {
        ["solidBox"] = new("A solid box", (of, given) => Solids.Box(given.Mass, of["solidBox"].Lengths("Full edges, m"))),
        ["boxVertices"] = new("The lab's box: an eighth of the mass in each corner", (of, given) =>
        {
            Vector3d edges = of["boxVertices"].Lengths("Full edges, m");
            given.SolidBox = Solids.Box(given.Mass, edges);
            return PointMasses.BoxVertices(given.Mass, edges);
        }),
        ["solidSphere"] = new("A solid ball", (of, given) => Solids.Sphere(given.Mass, of["solidSphere"].Positive("Radius, m"))),
        ["solidCylinder"] = new("A solid cylinder about its centre", (of, given) => of["solidCylinder"].Object("Radius, height and axis", shape =>
            Solids.Cylinder(given.Mass, shape["radius"].Positive("m"), shape["height"].Positive("m"), Axis(shape)))),
        ["solidCapsule"] = new("A solid cylinder between two half balls", (of, given) => of["solidCapsule"].Object("Radius, height and axis", shape =>
            Solids.Capsule(given.Mass, shape["radius"].Positive("m"), shape["height"].Positive("Without its caps, m"), Axis(shape)))),
        ["points"] = new("Points", Points, Beside.Mass),
        ["mesh"] = new("The solid inside a closed surface; its centre of mass as it comes out", (of, given) =>
        {
            Vector3d scale = of.Or("scale", Ones, factors => factors.Vector("Factors for x, y and z; 0.001 each for a file in mm; 1 if absent"));
            return of["mesh"].Mesh("A file in STL or OBJ, beside the scene", mesh => mesh.Scaled(scale).Weighing(given.Mass));
        }, Beside.Mass),
        ["principal"] = new("Principal moments", (of, given) => given.Principal(
            of["principal"].Lengths("kg m^2"),
            of.Or("frame", Quaterniond.Identity, frame => frame.Turn("Principal axes to body axes"))), Beside.All),
        ["tensor"] = new("The tensor's elements; beside the diagonal minus the integral of the product, as in URDF and MJCF", (of, given) => given.Tensor(
            of["tensor"].Object("kg m^2, body axes", Tensor)), Beside.All),
        ["compound"] = new("Parts, of which mass and centre of mass follow", (of, given) =>
            given.Depth < Deepest ? Together(of["compound"].Parts("One or more", part => Part(part, given)))
            : throw Guard.Refused("compound", given.Depth + 1, $"must not be nested deeper than {Deepest}"), Beside.Nothing),
    };

    /// <summary>The field that a body may have beside an inertia, unless the inertia gives it already.</summary>
    [Flags]
    private enum Beside
    {
        Nothing = 0,
        Mass = 1,
        Center = 2,
        About = 4,
        MassAndCenter = Mass | Center,
        All = Mass | Center | About,
    }

    /// <summary>Names of all kinds.</summary>
    public static IEnumerable<string> Names => Kinds.Keys;

    private static string Numeric => string.Join(" and ", Names.Where(name => (Kinds[name].Beside & Beside.About) != 0));

    /// <summary>Reads the form of a kind by its reader.</summary>
    public static void Fill(string name, Form form) => form.Object(Kinds[name].About, of => Kinds[name].Read(of, new Given(1, Vector3d.Zero, null, 0)));

    /// <summary>Reads the fields of a body, or of a part, which has no name.</summary>
    public static BodyInertia Read(Fields body, string? name, int depth = 0)
    {
        try
        {
            return Read(body, depth);
        }
        catch (InputException wrong) when (name != null)
        {
            throw new InputException($"{wrong.Message}, in body \"{name}\"");
        }
    }

    private static BodyInertia Read(Fields body, int depth)
    {
        Place? mass = body.Optional("mass"), inertia = body.Optional("inertia"), center = body.Optional("centerOfMass"), about = body.Optional("about");
        double kilograms = mass?.Make(() => Guard.Positive(mass.Value.Number(), string.Empty)) ?? 1;
        if (inertia is Place spread)
        {
            Place? fromOrigin = about?.OneOf("centerOfMass", "origin") == 1 ? about : null;
            return Read(spread, mass, center, about, new Given(kilograms, center?.Vector() ?? Vector3d.Zero, fromOrigin, depth));
        }

        Refuse(about, $"is for {Numeric} only, and no inertia is given here");
        MassProperties box = mass?.Make(() => Solids.Box(kilograms, Ones)) ?? UnitBox;
        return new BodyInertia(Centered(box, center), null, "solidBox", false, []);
    }

    private static BodyInertia Read(Place spread, Place? mass, Place? center, Place? about, Given given)
    {
        Fields fields = spread.Fields();
        (string name, Kind kind) = KindOf(fields);
        Refuse((kind.Beside & Beside.Mass) == 0 ? mass : null, $"must not stand beside {name}, whose parts say it");
        Refuse((kind.Beside & Beside.Center) == 0 ? center : null, $"must not stand beside {name}, which says where it is");
        Refuse((kind.Beside & Beside.About) == 0 ? about : null, $"is for {Numeric} only; {name} is about its own centre of mass");
        Place shape = fields.Required(name);
        given.Shape = shape;
        MassProperties found = shape.Make(() => new FilledForm(fields).Object(kind.About, of => kind.Read(of, given)));
        if (mass != null && Math.Abs(found.Mass - given.Mass) > SameMass * given.Mass)
            throw mass.Value.Wrong(FormattableString.Invariant($"must be the sum of the masses, {found.Mass:R}, found {given.Mass:R}"));

        MassProperties? solid = given.SolidBox is MassProperties box ? Centered(box, center) : null;
        return new BodyInertia(Centered(found, center), solid, name, (kind.Beside & Beside.About) != 0, given.Notes);
    }

    private static (string Name, Kind Kind) KindOf(Fields fields)
    {
        string[] names = [.. Names.Where(name => fields.Optional(name) != null)];
        if (names.Length == 1)
            return (names[0], Kinds[names[0]]);

        if (fields.Rest().Any(field => Robots.Contains(field.Name)))
            throw fields.Place.Wrong("""must name its six numbers "tensor": { "xx", "yy", "zz", "xy", "xz", "yz" }, found """ + string.Join(", ", fields.Rest().Select(field => field.Name)));

        fields.End("masses", "frame", "scale");
        throw fields.Place.Wrong($"must have exactly one of {string.Join(", ", Names)}, found {(names.Length == 0 ? "none" : string.Join(", ", names))}");
    }

    private static MassProperties Points(Form of, Given given)
    {
        Vector3d[] points = of["points"].Vectors("Body frame, m", least: 1);
        double[] masses = of.Or("masses", [], list => list.Positives("kg, one a point; equal parts of mass if absent"));
        return of.Has("masses") ? PointMasses.Of(points, masses) : PointMasses.Equal(given.Mass, points);
    }

    private static SymmetricMatrix3 Tensor(Form of) => new()
    {
        XX = of["xx"].Positive(string.Empty),
        YY = of["yy"].Positive(string.Empty),
        ZZ = of["zz"].Positive(string.Empty),
        XY = of.Or("xy", 0, product => product.Number("0 if absent")),
        XZ = of.Or("xz", 0, product => product.Number("0 if absent")),
        YZ = of.Or("yz", 0, product => product.Number("0 if absent")),
    };

    private static int Axis(Form shape) => shape.Or("axis", 1, axis => axis.OneOf("Along which it lies; y if absent", Axes));

    private static (MassProperties Mass, Vector3d Position, Quaterniond Orientation) Part(Fields part, Given whole)
    {
        BodyInertia inertia = Read(part, null, whole.Depth + 1);
        whole.Notes.AddRange(inertia.Notes);
        return (inertia.Mass, part.Or("position", Vector3d.Zero, place => place.Vector()), part.Or("orientation", Quaterniond.Identity, place => place.Turn()));
    }

    private static MassProperties Together((MassProperties Mass, Vector3d Position, Quaterniond Orientation)[] parts)
    {
        Compound compound = new();
        foreach ((MassProperties mass, Vector3d position, Quaterniond orientation) in parts)
            compound.With(mass, position, orientation);

        return compound.ToMassProperties();
    }

    private static void Refuse(Place? field, string why)
    {
        if (field is Place place)
            throw place.Wrong(why);
    }

    private static MassProperties Centered(MassProperties mass, Place? center) =>
        center is Place place ? place.Make(() => mass.WithCenterOfMass(place.Vector())) : mass;

    private sealed record Kind(string About, Func<Form, Given, MassProperties> Read, Beside Beside = Beside.MassAndCenter);
}

/// <summary>Mass, inertia and centre of mass of a body as given in its file.</summary>
/// <param name="Mass">The mass properties.</param>
/// <param name="SolidBox">For a box of vertices: those of the solid box.</param>
/// <param name="Kind">The kind of the inertia.</param>
/// <param name="IsOfNumbers">True if moments are given as numbers, which may be about any point; a shape is about its centre of mass.</param>
/// <param name="Notes">Notes for the user.</param>
internal sealed record BodyInertia(MassProperties Mass, MassProperties? SolidBox, string Kind, bool IsOfNumbers, IReadOnlyList<string> Notes);
