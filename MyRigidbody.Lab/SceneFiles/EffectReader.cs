namespace RigidBodyDynamics.Lab;

/// <summary>Reads an effect of a body. A new effect is one line in the table and, if it is an object, one function.</summary>
internal static class EffectReader
{
    private static readonly Dictionary<string, Func<Place, Func<Window, BodyDescription>>> Effects = new()
    {
        ["gravity"] = place => Coast(new Gravity(place.Vector())),
        ["linearDamping"] = place => Coast(new LinearDamping(place.Number())),
        ["angularDamping"] = place => Coast(new AngularDamping(place.Number())),
        ["decayPerStep"] = place => Coast(DecayPerStep(place)),
        ["force"] = place => Push(new Force(place.Vector())),
        ["torque"] = place => Push(Torque(place.Fields())),
        ["key"] = place => Push(new Key((LabKey)place.OneOf(Enum.GetNames<LabKey>()))),
        ["quadraticDrag"] = place => Push(new QuadraticDrag(place.Number())),
        ["thrust"] = place => Push(Thrust(place.Fields())),
        ["spring"] = place => Push(Spring(place.Fields())),
        ["heavyTop"] = place => Push(HeavyTop(place.Fields())),
        ["perStep"] = place => Push(PerStep(place.Fields())),
    };

    /// <summary>Names of all effects.</summary>
    public static IEnumerable<string> Names => Effects.Keys;

    /// <summary>Adds the effect to the body.</summary>
    public static void Read(Place place, BodyDescription body)
    {
        Fields fields = place.Fields();
        Place? from = fields.Optional("from"), to = fields.Optional("to");
        IReadOnlyList<(string Name, Place Place)> effects = fields.Rest();
        if (effects.Count != 1)
        {
            throw place.Wrong($"must have exactly one effect, found {(effects.Count == 0 ? "none" : string.Join(", ", effects.Select(found => found.Name)))}; effects are {string.Join(", ", Names)}");
        }

        (string name, Place effect) = effects[0];
        if (!Effects.TryGetValue(name, out Func<Place, Func<Window, BodyDescription>>? read))
        {
            throw effect.Wrong("is not an effect; effects are " + string.Join(", ", Names));
        }

        if (name == "perStep" && (from ?? to) is Place window)
        {
            throw window.Wrong("must not stand beside perStep, which says for every step what acts");
        }

        Func<Window, BodyDescription> add = effect.Make(() => read(effect));
        place.Make(() => add(new Window(body, from?.Number() ?? 0, to?.Number() ?? double.PositiveInfinity)));
    }

    internal static Func<Window, BodyDescription> Push<TPush>(TPush push) where TPush : struct, IPush =>
        window => window.Body.With(push, window.From, window.To);

    private static Func<Window, BodyDescription> Coast(ICoast coast) =>
        window => window.Body.With(coast, window.From, window.To);

    private static DecayPerStep DecayPerStep(Place place)
    {
        if (place.Value.ValueKind == System.Text.Json.JsonValueKind.Number)
        {
            return new DecayPerStep(place.Number(), place.Number());
        }

        if (place.Value.ValueKind != System.Text.Json.JsonValueKind.Object)
        {
            throw place.Not("a number or an object { \"linear\": …, \"angular\": … }");
        }

        Fields fields = place.Fields();
        double linear = fields.Or("linear", 1, factor => factor.Number()), angular = fields.Or("angular", 1, factor => factor.Number());
        fields.End();
        return new DecayPerStep(linear, angular);
    }

    private static Torque Torque(Fields fields)
    {
        bool inBody = fields.Or("frame", 0, place => place.OneOf("world", "body")) == 1;
        Torque torque = new(Vector("constant"), Vector("sin"), Vector("cos"), fields.Or("rate", 1, place => place.Number()), inBody);
        fields.End();
        return torque;

        Vector3d Vector(string name) => fields.Or(name, Vector3d.Zero, place => place.Vector());
    }

    private static Thrust Thrust(Fields fields)
    {
        Vector3d force = fields.Required("force").Vector(), point = fields.Or("point", Vector3d.Zero, place => place.Vector());
        fields.End();
        return new Thrust(force, point);
    }

    private static Spring Spring(Fields fields)
    {
        Vector3d anchor = fields.Or("anchor", Vector3d.Zero, place => place.Vector()), at = fields.Required("at").Vector();
        double stiffness = fields.Required("stiffness").Number();
        fields.End();
        return new Spring(anchor, at, stiffness);
    }

    private static HeavyTop HeavyTop(Fields fields)
    {
        Vector3d axis = fields.Required("axis").Vector(), up = fields.Required("up").Vector();
        double moment = fields.Required("moment").Number();
        fields.End();
        return new HeavyTop(axis, moment, up);
    }

    private static PerStep PerStep(Fields fields)
    {
        PerStep perStep = new(List("force"), List("torque"));
        fields.End();
        return perStep;

        Vector3d[] List(string name) => fields.Optional(name)?.Items("a list of vectors", place => place.Vector()) ?? [];
    }

    /// <summary>To which body an effect is added, and when it acts.</summary>
    internal readonly record struct Window(BodyDescription Body, double From, double To);
}
