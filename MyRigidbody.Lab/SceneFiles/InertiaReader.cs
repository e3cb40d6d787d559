namespace RigidBodyDynamics.Lab;

/// <summary>Reads mass, inertia and centre of mass of a body.</summary>
internal static class InertiaReader
{
    // a mass beside masses may be rounded in the file, no more
    private const double SameMass = 1e-9;

    private static readonly Vector3d Ones = new(1, 1, 1);

    // of a file with many bodies of which little is said, most would be copies of it
    private static readonly MassProperties UnitBox = Solids.Box(1, Ones);
    private static readonly string[] Shapes = ["solidBox", "boxVertices", "solidSphere", "points", "principal"];

    /// <summary>The mass properties, and for a box of vertices those of the solid box.</summary>
    public static (MassProperties Mass, MassProperties? SolidBox) Read(Fields body)
    {
        Place? massPlace = body.Optional("mass"), inertia = body.Optional("inertia"), center = body.Optional("centerOfMass");
        double mass = massPlace?.Make(() => Guard.Positive(massPlace.Value.Number(), string.Empty)) ?? 1;
        if (inertia == null)
        {
            return (Centered(massPlace?.Make(() => Solids.Box(mass, Ones)) ?? UnitBox, center), null);
        }

        Fields fields = inertia.Value.Fields();
        string[] shapes = [.. Shapes.Where(shape => fields.Optional(shape) != null)];
        if (shapes.Length != 1)
        {
            fields.End("masses", "frame");
            throw inertia.Value.Wrong($"must have exactly one of {string.Join(", ", Shapes)}, found {(shapes.Length == 0 ? "none" : string.Join(", ", shapes))}");
        }

        Place shape = fields.Required(shapes[0]);
        MassProperties found = shapes[0] switch
        {
            "solidBox" => shape.Make(() => Solids.Box(mass, shape.Vector())),
            "boxVertices" => shape.Make(() => PointMasses.BoxVertices(mass, shape.Vector())),
            "solidSphere" => shape.Make(() => Solids.Sphere(mass, shape.Number())),
            "points" => Points(fields, shape, massPlace, mass),
            _ => Principal(fields, mass),
        };
        fields.End();
        if (shapes[0] == "points" && center != null)
        {
            throw center.Value.Wrong("must not stand beside points, which say where the centre of mass is");
        }

        MassProperties? solid = shapes[0] == "boxVertices" ? Centered(shape.Make(() => Solids.Box(mass, shape.Vector())), center) : null;
        return (Centered(found, center), solid);
    }

    private static MassProperties Points(Fields fields, Place list, Place? massPlace, double mass)
    {
        Vector3d[] points = list.Items("a list of points", place => place.Vector());
        Place? massesPlace = fields.Optional("masses");
        if (massesPlace == null)
        {
            return fields.Place.Make(() => PointMasses.Equal(mass, points));
        }

        double[] masses = massesPlace.Value.Numbers("a list of masses");
        MassProperties found = fields.Place.Make(() => PointMasses.Of(points, masses));
        return massPlace == null || Math.Abs(found.Mass - mass) <= SameMass * mass
            ? found
            : throw massPlace.Value.Wrong(FormattableString.Invariant($"must be the sum of the masses, {found.Mass:R}, found {mass:R}"));
    }

    private static MassProperties Principal(Fields fields, double mass)
    {
        Vector3d moments = fields.Required("principal").Vector();
        Quaterniond frame = fields.Or("frame", Quaterniond.Identity, place => place.Turn());
        return fields.Place.Make(() => MassProperties.FromPrincipal(mass, moments, frame, Vector3d.Zero));
    }

    private static MassProperties Centered(MassProperties mass, Place? center) =>
        center is Place place ? place.Make(() => mass.WithCenterOfMass(place.Vector())) : mass;
}
