namespace RigidBodyDynamics.Lab;

/// <summary>Reads a body of a scene.</summary>
internal static class BodyReader
{
    private static readonly string[] LabIntegrators = ["LabEuler", "ExplicitEuler"];

    /// <summary>The body; its count, the solid box of one that is made of vertices, and notes for the user are stored by its name.</summary>
    public static BodyDescription Read(
        Place place, Dictionary<string, MassProperties> solidBoxes, Dictionary<string, ManyBodies> crowds, Dictionary<string, IReadOnlyList<string>> notes)
    {
        Fields fields = place.Fields();
        string name = fields.Required("name").ShortText();
        Place? integrator = fields.Optional("integrator");
        Rule rule = integrator is Place named
            ? named.Make(() => Rules.Named(named.Text()))
            : Rules.Default;
        BodyInertia inertia = InertiaReader.Read(fields, name);

        BodyDescription body = place.Make(() => new BodyDescription(name, inertia.Mass));
        body.Rule = rule;
        ReadStart(fields, body);
        body.Lock = (fields.Optional("lock") is Place locks ? Locked(locks.Fields()) : Locks.None)
            | (fields.Or("canMove", true, flag => flag.Flag()) ? Locks.None : Locks.Move)
            | (fields.Or("canTurn", true, flag => flag.Flag()) ? Locks.None : Locks.Turn);
        bool isLabs = LabIntegrators.Contains(rule.Name), isUnitys = rule == Rules.UnityRigidbody;
        if (fields.OnlyIf(isLabs, "lab", $"is for {string.Join(" and ", LabIntegrators)} only, and this body moves by {rule.Name}") is Place lab)
            body.Lab = Lab(lab.Fields());

        if (fields.OnlyIf(isUnitys, "unity", $"is for UnityRigidbody only, and this body moves by {rule.Name}") is Place unity)
            body.Unity = Unity(unity.Fields());

        foreach (Place effect in fields.Optional("effects")?.List("a list of effects") ?? [])
            EffectReader.Read(effect, body);

        body = Pivot.Hold(fields, body, ref inertia);
        if (ManyBodies.Read(fields, body) is ManyBodies crowd)
            crowds[name] = crowd;

        fields.End();
        if (inertia.SolidBox != null)
            solidBoxes[name] = inertia.SolidBox;

        if (inertia.Notes.Count > 0)
            notes[name] = inertia.Notes;

        return body;
    }

    /// <summary>Axes as letters: of the world for translation, principal axes for rotation.</summary>
    public static Locks Locked(Fields fields)
    {
        Locks locked = fields.Or("move", Locks.None, axes => Axes(axes, Locks.MoveX)) | fields.Or("turn", Locks.None, axes => Axes(axes, Locks.TurnX));
        fields.End();
        return locked;
    }

    // the number of a word is the sum of 1 for x, 2 for y and 4 for z
    private static Locks Axes(Place place, Locks first) =>
        (Locks)((int)first * place.OneOf(string.Empty, "x", "y", "xy", "z", "xz", "yz", "xyz"));

    private static void ReadStart(Fields fields, BodyDescription body)
    {
        body.Start = new BodyState(
            fields.Or("position", Vector3d.Zero, place => place.Vector()),
            fields.Or("orientation", Quaterniond.Identity, place => place.Turn()),
            fields.Or("velocity", Vector3d.Zero, place => place.Vector()),
            fields.Or("angularVelocity", Vector3d.Zero, place => place.Vector()));
        Place? inBody = fields.Optional("angularVelocityBody");
        if (inBody == null)
            return;

        if (fields.Optional("angularVelocity") != null)
            throw inBody.Value.Wrong("must not stand beside angularVelocity");

        body.AngularVelocityInBody = inBody.Value.Vector();
    }

    private static LabSettings Lab(Fields fields)
    {
        LabSettings lab = new();
        lab.Normalise = fields.Or("normalise", lab.Normalise, place => place.Flag());
        lab.FirstOrderOrientation = fields.Or("firstOrderOrientation", lab.FirstOrderOrientation, place => place.Flag());
        lab.UnitRotation = fields.Or("unitRotation", lab.UnitRotation, place => place.Flag());
        fields.End();
        return lab;
    }

    private static UnitySettings Unity(Fields fields)
    {
        UnitySettings unity = new();
        return fields.Place.Make(() =>
        {
            unity.Drag = fields.Or("drag", unity.Drag, place => place.Number());
            unity.AngularDrag = fields.Or("angularDrag", unity.AngularDrag, place => place.Number());
            unity.MaxAngularVelocity = fields.Or("maxAngularVelocity", unity.MaxAngularVelocity, place => place.Number());
            unity.SleepThreshold = fields.Or("sleepThreshold", unity.SleepThreshold, place => place.Number());
            unity.WakeCounter = fields.Or("wakeCounter", unity.WakeCounter, place => place.Number());
            unity.GyroscopicForces = fields.Or("gyroscopicForces", unity.GyroscopicForces, place => place.Flag());
            unity.FirstOrderOrientation = fields.Or("firstOrderOrientation", unity.FirstOrderOrientation, place => place.Flag());
            unity.InDouble = fields.Or("precision", 0, place => place.OneOf("single", "double")) == 1;
            fields.End();
            return unity;
        });
    }
}
