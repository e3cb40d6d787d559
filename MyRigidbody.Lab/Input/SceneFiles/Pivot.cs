namespace RigidBodyDynamics.Lab;

/// <summary>
/// The pivot of a heavy top, the origin of the body frame: its motion depends on the inertia about it, which is four times that of a rod about
/// its middle. A scene states the point of its inertia, or enough to derive it.
/// </summary>
internal static class Pivot
{
    /// <summary>The effect of a body with a pivot.</summary>
    public const string Effect = "heavyTop";

    private const string Point = "inertiaAbout";

    private static readonly string[] Points = ["pivot", "centerOfMass"];

    // an axis typed with six digits points to the centre of mass within this angle
    private const double Aside = 1e-5;

    /// <summary>The form of the effect, after the field that names the point.</summary>
    public static Form Named(Form of)
    {
        of.OptionalOneOf(Point, "The point that the body's inertia is about; the pivot is the origin of the body frame", Points);
        return of;
    }

    /// <summary>The body with its inertia about the pivot, if it has one; otherwise unchanged.</summary>
    /// <param name="fields">The fields of the body, after all effects have been read.</param>
    /// <param name="body">The body with its effects.</param>
    /// <param name="inertia">Its inertia as given; becomes the one about the pivot.</param>
    public static BodyDescription Hold(Fields fields, BodyDescription body, ref BodyInertia inertia)
    {
        Place[] tops = [.. Tops(fields)];
        if (tops.Length == 0)
            return body;

        Place? named = tops.Select(top => top.Fields().Optional(Point)).FirstOrDefault(point => point != null);
        string? about = named?.Text(), taken = fields.Optional("about")?.Text();
        foreach (Place top in tops)
        {
            if (top.Fields().Optional(Point) is Place other && other.Text() != about)
                throw other.Not($"\"{about}\" as in the body's other heavy top");
        }

        Vector3d center = inertia.Mass.CenterOfMass;
        bool isOff = !center.IsZero, mayBeOfPivot = inertia.IsOfNumbers && taken != "centerOfMass";
        if (taken == "origin" && about == "centerOfMass")
            throw named!.Value.Not("\"pivot\", since about is \"origin\", and the pivot is the origin");

        if (about == "pivot" && isOff && !mayBeOfPivot)
            throw named!.Value.Wrong($"must not be the pivot: {inertia.Kind} is about its centre of mass, which centerOfMass puts elsewhere, at {center}");

        if (about != "pivot" && !isOff && (about != null || !mayBeOfPivot))
        {
            throw tops[0].Wrong($"{inertia.Kind} is about its centre of mass, and nothing says how far that is from the pivot: give centerOfMass, from the pivot, which is the body's origin; "
                + $"or \"{Point}\": \"pivot\", if the inertia is the one about the pivot");
        }

        List<string> notes = [.. inertia.Notes];
        bool isOfPivot = mayBeOfPivot && taken == null && (about == "pivot" || !isOff);
        BodyInertia given = inertia;
        MassProperties held = fields.Place.Make(() => isOfPivot ? given.Mass.WithCenterOfMass(Vector3d.Zero) : given.Mass.HeldAtOrigin());
        if (isOff)
        {
            foreach (Place top in tops)
                MustPointTo(center, top);
        }

        if (about == null && taken != "origin")
        {
            notes.Add(isOfPivot
                ? $"{tops[0].Path}: takes {inertia.Kind} {inertia.Mass.PrincipalMoments} kg m² as about the pivot; \"{Point}\" can say so, or that it is about the centre of mass"
                : $"{tops[0].Path}: takes the inertia about the centre of mass {center} to the pivot, the body's origin, where the principal moments are {held.PrincipalMoments} kg m²");
        }

        inertia = inertia with { Mass = held, SolidBox = fields.Place.Make(() => given.SolidBox?.HeldAtOrigin()), Notes = notes };
        return body.Copy(body.Name, held);
    }

    private static IEnumerable<Place> Tops(Fields body) =>
        from effect in body.Optional("effects")?.List() ?? []
        where effect.Value.TryGetProperty(Effect, out _)
        select effect.Fields().Required(Effect);

    private static void MustPointTo(Vector3d center, Place top)
    {
        Place axis = top.Fields().Required("axis");
        double moment = top.Fields().Required("moment").Number();
        Vector3d down = moment < 0 ? -axis.Vector() : axis.Vector();
        if (Vector3d.Cross(down, center).Length > Aside * down.Length * center.Length || Vector3d.Dot(down, center) < 0)
            throw axis.Not($"along centerOfMass {center}, from the pivot, which is the body's origin");
    }
}
