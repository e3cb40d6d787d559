using System.Globalization;

namespace RigidBodyDynamics.Lab.Comparison;

/// <summary>A rule: one thing that MyRigidbody and DefaultRigidbody compute differently.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Mine">How MyRigidbody computes it.</param>
/// <param name="Unitys">How DefaultRigidbody computes it.</param>
/// <param name="Exchange">The body with Unity's rule in place of the lab's.</param>
internal sealed record Difference(string Name, string Mine, string Unitys, Func<BodyDescription, BodyDescription> Exchange)
{
    /// <summary>True for effects that are drag in Unity.</summary>
    public static bool IsDamping(Effect effect) => effect.Motion is ICoast && effect.Motion.Traits.HasFlag(EffectTraits.IsDamping);

    /// <summary>
    /// MyRigidbody as a body of UnityRigidbody, with every rule still the lab's: the same motion except for roundings, in which
    /// the rules can be exchanged one by one.
    /// </summary>
    public static BodyDescription LabInUnitysShape(BodyDescription mine)
    {
        BodyDescription body = mine.Copy("mine", mine.Mass);
        body.Rule = Rules.UnityRigidbody;
        body.Unity = new UnitySettings
        {
            Drag = 0,
            AngularDrag = 0,
            MaxAngularVelocity = double.PositiveInfinity,
            SleepThreshold = 0,
            InDouble = true,
            FirstOrderOrientation = true,
        };
        return body;
    }

    /// <summary>The rules in which a pair differs, in the order in which they are exchanged.</summary>
    public static IReadOnlyList<Difference> Between(Pair pair)
    {
        BodyDescription mine = pair.Mine, unity = pair.Default;
        UnitySettings to = unity.Unity;
        List<Difference> rules = [];
        if (mine.Rule != Rules.LabEuler)
            rules.Add(new Difference("integrator", mine.Rule.Name, "the lab's steps, no ω × I ω", body => body));

        if (mine.Mass.PrincipalMoments != unity.Mass.PrincipalMoments || mine.Mass.Mass != unity.Mass.Mass)
            rules.Add(new Difference("inertia", Moments(mine.Mass), Moments(unity.Mass) + Factor(mine.Mass, unity.Mass), body => body.Copy(body.Name, unity.Mass)));

        rules.Add(new Difference("damping", Damping(mine), $"drag {Number(to.Drag)}, angularDrag {Number(to.AngularDrag)}", body =>
            Set(WithDampingOf(unity, body), settings =>
            {
                settings.Drag = to.Drag;
                settings.AngularDrag = to.AngularDrag;
            })));
        rules.Add(new Difference("limit of spin", "none", $"{Number(to.MaxAngularVelocity)} rad/s", body =>
            Set(body, settings => settings.MaxAngularVelocity = to.MaxAngularVelocity)));
        rules.Add(new Difference("orientation", "q + [0, ½Δt ω] q", "the exact turn about ω", body =>
            Set(body, settings => settings.FirstOrderOrientation = to.FirstOrderOrientation)));
        rules.Add(new Difference("sleep", "never", $"below {Number(to.SleepThreshold)} J/kg, velocities of 0.2 s summed", body =>
            Set(body, settings =>
            {
                settings.SleepThreshold = to.SleepThreshold;
                settings.WakeCounter = to.WakeCounter;
            })));
        if (to.GyroscopicForces)
            rules.Add(new Difference("gyroscopic forces", "none", "PhysX 5's", body => Set(body, settings => settings.GyroscopicForces = true)));

        if (Acting(mine) != Acting(unity) || !mine.Start.Equals(unity.Start))
            rules.Add(new Difference("scene", Acting(mine), Acting(unity), body => Of(unity, body.Unity)));

        // last, and without a remainder: this is the body of the pair itself
        rules.Add(new Difference("precision", "double", to.InDouble ? "double" : "single", body =>
            Set(body, settings => settings.InDouble = to.InDouble)));
        return rules;
    }

    private static BodyDescription WithDampingOf(BodyDescription other, BodyDescription body)
    {
        BodyDescription copy = body.Copy(body.Name, body.Mass).Without(effect => IsDamping(effect));
        foreach (Effect effect in other.Effects.Where(IsDamping))
            copy.With(effect);

        return copy;
    }

    private static BodyDescription Of(BodyDescription body, UnitySettings settings)
    {
        BodyDescription copy = body.Copy(body.Name, body.Mass);
        copy.Unity = settings;
        return copy;
    }

    private static BodyDescription Set(BodyDescription body, Action<UnitySettings> change)
    {
        BodyDescription copy = body.Copy(body.Name, body.Mass);
        change(copy.Unity);
        return copy;
    }

    private static string Moments(MassProperties mass)
    {
        Vector3d i = mass.PrincipalMoments;
        return i.X == i.Y && i.Y == i.Z ? $"{Number(i.X)} kg m²" : $"({Number(i.X)}, {Number(i.Y)}, {Number(i.Z)}) kg m²";
    }

    private static string Factor(MassProperties mine, MassProperties unitys)
    {
        Vector3d a = mine.PrincipalMoments, b = unitys.PrincipalMoments;
        double ratio = b.X / a.X;
        bool isOne = Math.Abs(b.Y / a.Y - ratio) < 1e-9 && Math.Abs(b.Z / a.Z - ratio) < 1e-9;
        return !isOne || ratio == 1 ? string.Empty : ratio < 1 ? $", mine / {Number(1 / ratio)}" : $", mine × {Number(ratio)}";
    }

    private static string Damping(BodyDescription body)
    {
        string[] damping = [.. body.Effects.Where(IsDamping).Select(effect => effect.Motion.ToString()!)];
        return damping.Length > 0 ? string.Join(", ", damping) : "none";
    }

    private static string Acting(BodyDescription body)
    {
        string[] acting = [.. body.Effects.Where(effect => !IsDamping(effect)).Select(effect =>
            string.Create(CultureInfo.InvariantCulture, $"{effect.Motion} {effect.From}–{effect.To} s"))];
        return acting.Length > 0 ? string.Join(", ", acting) : "nothing acts";
    }

    private static string Number(double value) =>
        double.IsPositiveInfinity(value) ? "no" : value.ToString("G4", CultureInfo.InvariantCulture);
}
