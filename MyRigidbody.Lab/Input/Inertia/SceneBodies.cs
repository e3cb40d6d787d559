namespace RigidBodyDynamics.Lab.Inertia;

/// <summary>The bodies of a scene, including those with impossible numbers, which no other command reads.</summary>
internal static class SceneBodies
{
    private static readonly string[] Elements = ["xx", "yy", "zz", "xy", "xz", "yz"];

    /// <summary>Reads a scene or a recording.</summary>
    public static IReadOnlyList<DescribedBody> Read(string path) => JsonFile.Read(path, root =>
    {
        Fields fields = root.Fields();
        return fields.Required("schema").Text() == SceneReader.Schema
            ? fields.Required("bodies").Items("a list of bodies", Body)
            : [.. SceneReader.ReadWithCrowds(path).Scene.Bodies.Select((body, i) => Of(body.Name, $"bodies[{i}]", body.Mass, isComputed: false))];
    });

    private static DescribedBody Body(Place place)
    {
        Fields fields = place.Fields();
        string name = fields.Required("name").ShortText();
        if (fields.Optional("inertia") is Place { Value.ValueKind: System.Text.Json.JsonValueKind.Object } inertia)
        {
            Fields kinds = inertia.Fields();
            if ((kinds.Optional("tensor") ?? kinds.Optional("principal")) is Place numbers)
                return Given(new DescribedBody(name, place.Path), fields, kinds, numbers);
        }

        BodyInertia read = InertiaReader.Read(fields, name);
        return Of(name, place.Path, read.Mass, isComputed: true);
    }

    private static DescribedBody Of(string name, string place, MassProperties mass, bool isComputed) =>
        new(name, place) { Mass = mass.Mass, Center = mass.CenterOfMass, Tensor = mass.Inertia, IsComputed = isComputed };

    private static DescribedBody Given(DescribedBody body, Fields fields, Fields kinds, Place numbers)
    {
        double[] n = new double[6];
        string[] written = new string[6];
        Array.Fill(written, string.Empty);
        if (numbers.Name == "principal")
        {
            Vector3d moments = numbers.Vector();
            (n[0], n[1], n[2]) = (moments.X, moments.Y, moments.Z);
            int i = 0;
            foreach (Place moment in numbers.List())
                written[i++] = moment.Value.GetRawText();
        }
        else
        {
            Fields tensor = numbers.Fields();
            for (int i = 0; i < Elements.Length; i++)
            {
                Place? element = i < 3 ? tensor.Required(Elements[i]) : tensor.Optional(Elements[i]);
                n[i] = element?.Number() ?? 0;
                written[i] = element?.Value.GetRawText() ?? string.Empty;
            }

            tensor.End();
        }

        double mass = fields.Or("mass", 1, place => place.Number());
        Vector3d center = fields.Or("centerOfMass", Vector3d.Zero, place => place.Vector());
        DescribedBody given = body with
        {
            Mass = mass,
            Center = center,
            Axes = kinds.Or("frame", Quaterniond.Identity, place => place.Turn()),
            Tensor = Robots.UrdfReader.Tensor(n),
            HalfDigits = Robots.UrdfReader.Tensor(TypedDigits.HalfUnits(written)),
        };
        return fields.Or("about", 0, place => place.OneOf("centerOfMass", "origin")) == 1
            ? given with { Tensor = given.InBodyAxes - mass * SymmetricMatrix3.OfPoint(center), Axes = Quaterniond.Identity }
            : given;
    }
}
