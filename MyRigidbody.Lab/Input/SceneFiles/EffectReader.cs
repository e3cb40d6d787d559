namespace RigidBodyDynamics.Lab;

/// <summary>Reads an effect of a body. A new effect is one line in the table, which states its form; the schema is made from it.</summary>
internal static class EffectReader
{
    private const string PerStep = "perStep", Impulse = "impulse", Swing = "constant + sin * sin(rate t) + cos * cos(rate t)";

    private static readonly Dictionary<string, Func<Form, Func<Window, BodyDescription>>> Effects = new()
    {
        ["gravity"] = Coast(form => new Gravity(form.Vector("Acceleration, m/s^2"))),
        ["force"] = Push(form => form.VectorOrObject($"N: {Swing}, at a point of the body",
            shorthand => new Force(shorthand.Vector("N, world axes, at the centre of mass")),
            of => Swinging(of, "N", (inBody, constant, sine, cosine, rate) => new Force(constant, sine, cosine, rate, At(of), inBody)))),
        ["torque"] = Push(form => form.Object($"N m: {Swing}",
            of => Swinging(of, "N m", (inBody, constant, sine, cosine, rate) => new Torque(constant, sine, cosine, rate, inBody)))),
        [Impulse] = Effect(form => form.Object("N s and N m s, at once", of => (
            Time: Guard.NotNegative(of["time"].Number("At the beginning of the first step that starts then or later, s", 0), "time"),
            What: new Impulse(inBody: InBody(of), linear: of.OptionalVector("linear", "N s"),
                angular: of.OptionalVector("angular", "N m s, besides what the linear one gives"), at: At(of)))),
            (window, impulse) => window.Body.With(impulse.What, impulse.Time)),
        ["massRate"] = Effect(form => form.Object("The mass grows or falls, and the moments in proportion", of => new MassRate(
            of["rate"].Number("kg/s, below zero where mass is lost"),
            (Keeping)of.OptionalOneOf("keeps", "What goes on as it is; velocity, as of fuel, if absent", "velocity", "momentum"))),
            (window, rate) => window.Body.With(rate, window.From, window.To)),
        ["key"] = Push(form => new KeyPush((LabKey)form.OneOf(
            "A key of the lab: 5 N along -x, +x, +y, -y; torque (sin t, sin t, sin t)", Enum.GetNames<LabKey>()))),
        ["linearDamping"] = Coast(form => new LinearDamping(form.Number("Rate, 1/s: the velocity falls by exp(-c dt)", 0))),
        ["angularDamping"] = Coast(form => new AngularDamping(form.Number("Rate, 1/s: the angular velocity falls by exp(-c dt)", 0))),
        ["quadraticDrag"] = Push(form => new QuadraticDrag(form.Number("k, kg/m: force -k |v| v", 0))),
        ["decayPerStep"] = Coast(form => form.NumberOrObject("The lab's factor on the velocities, once a step",
            both => Same(both.Number(string.Empty, 0, 1)),
            of => new DecayPerStep(
                of.Or("linear", 1, factor => factor.Number("On the velocity, 1 if absent", 0, 1)),
                of.Or("angular", 1, factor => factor.Number("On the angular velocity, 1 if absent", 0, 1))))),
        ["spring"] = Push(form => form.Object("From a point of the body to a point of the world", of => new Spring(
            of.OptionalVector("anchor", "Body frame, m; the origin if absent"),
            of["at"].Vector("World, m"),
            of["stiffness"].Number("N/m", 0)))),
        [Pivot.Effect] = Push(form => form.Object("Gravity's torque about a pivot: -moment (axis x up)", of => new HeavyTop(
            Pivot.Named(of)["axis"].Vector("From the pivot to the centre of mass, body axes; its direction counts"),
            of["moment"].Number("m g l, N m"),
            of["up"].Vector("World axes; its direction counts")))),
        [PerStep] = Push(form => form.Object("One value a step, world axes", of => new PerStep(
            of.Or("force", [], force => force.Vectors("N")),
            of.Or("torque", [], torque => torque.Vectors("N m"))))),
    };

    /// <summary>Names of all effects.</summary>
    public static IEnumerable<string> Names => Effects.Keys;

    /// <summary>True for an effect that may act for a part of the time; an effect with a time of its own may not.</summary>
    public static bool HasWindow(string name) => name is not (PerStep or Impulse);

    /// <summary>Reads an effect's form by its reader.</summary>
    public static void Fill(string name, Form form) => Effects[name](form);

    /// <summary>Adds the effect to the body.</summary>
    public static void Read(Place place, BodyDescription body)
    {
        Fields fields = place.Fields();
        Place? from = fields.Optional("from"), to = fields.Optional("to");
        IReadOnlyList<(string Name, Place Place)> effects = fields.Rest();
        if (effects.Count != 1)
            throw place.Wrong($"must have exactly one effect, found {(effects.Count == 0 ? "none" : string.Join(", ", effects.Select(found => found.Name)))}; effects are {string.Join(", ", Names)}");

        (string name, Place effect) = effects[0];
        if (!Effects.TryGetValue(name, out Func<Form, Func<Window, BodyDescription>>? read))
            throw effect.Wrong("is not an effect; effects are " + string.Join(", ", Names));

        if (!HasWindow(name) && (from ?? to) is Place window)
            throw window.Wrong($"must not stand beside {name}, which says itself when it acts");

        Func<Window, BodyDescription> add = effect.Make(() => read(new FilledForm(effect)));
        place.Make(() => add(new Window(body, from?.Number() ?? 0, to?.Number() ?? double.PositiveInfinity)));
    }

    /// <summary>The reader of an effect that pushes.</summary>
    internal static Func<Form, Func<Window, BodyDescription>> Push<TPush>(Func<Form, TPush> read) where TPush : struct, IPush =>
        Effect(read, (window, push) => window.Body.With(push, window.From, window.To));

    private static Func<Form, Func<Window, BodyDescription>> Coast(Func<Form, ICoast> read) =>
        Effect(read, (window, coast) => window.Body.With(coast, window.From, window.To));

    private static Func<Form, Func<Window, BodyDescription>> Effect<T>(Func<Form, T> read, Func<Window, T, BodyDescription> add) => form =>
    {
        T effect = read(form);
        return window => add(window, effect);
    };

    private static T Swinging<T>(Form of, string unit, Func<bool, Vector3d, Vector3d, Vector3d, double, T> make) => make(
        InBody(of),
        of.OptionalVector("constant", unit),
        of.OptionalVector("sin", unit),
        of.OptionalVector("cos", unit),
        of.Or("rate", 1, rate => rate.Number("rad/s, 1 if absent")));

    private static bool InBody(Form of) => of.OptionalOneOf("frame", "Axes; world if absent", "world", "body") == 1;

    private static Vector3d? At(Form of) =>
        of.Or("at", default(Vector3d?), at => at.Vector("The point of the body where it acts, body frame, m; the centre of mass if absent"));

    private static DecayPerStep Same(double factor) => new(factor, factor);

    /// <summary>The body to which an effect is added, and the time in which it acts.</summary>
    internal readonly record struct Window(BodyDescription Body, double From, double To);
}
