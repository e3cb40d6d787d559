namespace RigidBodyDynamics.Lab;

/// <summary>Reads a recording: one body that moves by UnityRigidbody, or by LabEuler where a script was recorded, with a force and a torque for every step.</summary>
internal static class RecordingReader
{
    // Unity's names for the library's arguments
    private static readonly Dictionary<string, string> Called = new()
    {
        ["1 / mass"] = "mass",
        ["principal"] = "inertiaTensor",
        ["1 / principal"] = "inertiaTensor",
        ["frame"] = "inertiaTensorRotation",
        ["orientation"] = "rotation",
        ["velocity"] = "linearVelocity",
        ["drag"] = "linearDamping",
        ["angularDrag"] = "angularDamping",
        ["edges"] = "boxVertices",
    };

    /// <summary>The recording as a scene. Every number is read in single precision, as the engine received it.</summary>
    public static SceneFile Read(Place root)
    {
        Fields fields = root.Fields();
        fields.Required("schema");
        string name = fields.Required("name").ShortText();
        string about = fields.Or("about", string.Empty, place => place.Text());
        long count = fields.Required("steps").Count();
        Place dt = fields.Required("dt");
        double[] lengths = Numbers(dt, count);
        TimeSteps steps = dt.Make(() => TimeSteps.Of(lengths));
        BodyDescription body = Body(fields, name);
        Vector3d[] force = Vectors(fields, "force", count), torque = Vectors(fields, "torque", count);
        body.With(new PerStep(force, torque));
        bool usesGravity = fields.Required("useGravity").Flag();
        Gravity gravity = new(Vector(fields, "gravity"));
        if (usesGravity)
            body.With(gravity);

        fields.End();
        root.Check(body, steps, Called);
        SceneDescription scene = new(name, about, steps, [body]);
        return new SceneFile(root.File, scene, new Dictionary<string, ManyBodies>(), new Dictionary<string, MassProperties>(), Recording.Beside(root.File, count));
    }

    /// <summary>The input of a student's script, for LabEuler: starts at rest, one step a frame.</summary>
    public static SceneFile ReadScript(Place root)
    {
        Fields fields = root.Fields();
        fields.Required("schema");
        string name = fields.Required("name").ShortText();
        string about = fields.Or("about", string.Empty, place => place.Text());
        long count = fields.Required("steps").Count();
        Place dt = fields.Required("dt"), decay = fields.Required("decayPerStep");
        double[] lengths = Numbers(dt, count);
        TimeSteps steps = dt.Make(() => TimeSteps.Of(lengths));
        double mass = Number(fields, "mass");
        Vector3d edges = Vector(fields, "boxVertices");
        MassProperties properties = fields.Place.Make(() => PointMasses.BoxVertices(mass, edges), Called);
        BodyDescription body = fields.Place.Make(() => new BodyDescription(name, properties));
        body.Rule = Rules.LabEuler;
        body.Start = new BodyState(Vector(fields, "position"), Turn(fields, "rotation"), Vector3d.Zero, Vector3d.Zero);
        body.With(new PerStep(Vectors(fields, "force", count), Vectors(fields, "torque", count)));
        double factor = decay.Single();
        decay.Make(() => body.With(new DecayPerStep(factor, factor)));
        fields.End();
        root.Check(body, steps, Called);
        SceneDescription scene = new(name, about, steps, [body]);
        Recording recording = Recording.Beside(root.File, count) with { IsOfScript = true };
        Dictionary<string, MassProperties> solidBoxes = new() { [name] = Solids.Box(mass, edges) };
        return new SceneFile(root.File, scene, new Dictionary<string, ManyBodies>(), solidBoxes, recording);
    }

    private static BodyDescription Body(Fields fields, string name)
    {
        double mass = Number(fields, "mass");
        Vector3d moments = UnitySettings.Moments(Vector(fields, "inertiaTensor"), out Locks frozen), center = Vector(fields, "centerOfMass");
        Quaterniond frame = Turn(fields, "inertiaTensorRotation");
        Locks locked = frozen | (fields.Optional("lock") is Place locks ? BodyReader.Locked(locks.Fields()) : Locks.None);
        MassProperties properties = fields.Place.Make(() => MassProperties.FromPrincipal(mass, OfSingle(moments), frame, center), Called);
        BodyDescription body = fields.Place.Make(() => new BodyDescription(name, properties));
        body.Rule = Rules.UnityRigidbody;
        body.Lock = locked;
        body.Start = new BodyState(
            Vector(fields, "position"),
            Turn(fields, "rotation"),
            Vector(fields, "linearVelocity"),
            Vector(fields, "angularVelocity"));
        body.Unity = fields.Place.Make(() => new UnitySettings
        {
            Drag = Number(fields, "linearDamping"),
            AngularDrag = Number(fields, "angularDamping"),
            MaxAngularVelocity = Number(fields, "maxAngularVelocity"),
            SleepThreshold = Number(fields, "sleepThreshold"),
            WakeCounter = Number(fields, "wakeCounter"),
            GyroscopicForces = fields.Required("gyroscopicForces").Flag(),
        }, Called);
        return body;
    }

    /// <summary>The nearest possible moments that round to the same: the largest of a flat body is the sum of the others except for roundings to single precision.</summary>
    private static Vector3d OfSingle(Vector3d moments)
    {
        const double Rounding = 1.0 / (1 << 24);
        Vector3d off = Rounding * moments;
        if (!(off.X > 0 && off.Y > 0 && off.Z > 0))
            return moments;

        Vector3d nearest = MassProperties.NearestPossible(moments, off);
        return Math.Abs(nearest.X - moments.X) <= off.X ? nearest : moments;
    }

    private static double Number(Fields fields, string name) => fields.Required(name).Single();

    private static double[] Numbers(Place place, long count)
    {
        double[] numbers = place.Items("a list of numbers", number => (double)number.Single());
        return numbers.Length == count ? numbers : throw place.Wrong($"must have {count} numbers, found {numbers.Length}");
    }

    private static Vector3d Vector(Fields fields, string name)
    {
        double[] n = Numbers(fields.Required(name), 3);
        return new Vector3d(n[0], n[1], n[2]);
    }

    /// <summary>Here, unlike in scenes, the order is x, y, z, w.</summary>
    private static Quaterniond Turn(Fields fields, string name)
    {
        Place place = fields.Required(name);
        double[] n = Numbers(place, 4);
        return place.Make(() => Guard.Turn(new Quaterniond(n[3], n[0], n[1], n[2]), string.Empty));
    }

    private static Vector3d[] Vectors(Fields fields, string name, long count)
    {
        double[] n = Numbers(fields.Required(name), 3 * count);
        return [.. Enumerable.Range(0, (int)count).Select(i => new Vector3d(n[3 * i], n[3 * i + 1], n[3 * i + 2]))];
    }
}
