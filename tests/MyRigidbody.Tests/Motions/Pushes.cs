using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Every push of the library, and a body and moments to try it on.</summary>
internal static class Pushes
{
    private static readonly Vector3d[] Kicks = [new Vector3d(1, 0, -2), new Vector3d(0.5, 0.25, 0), new Vector3d(0, -3, 1)];

    public static MassProperties Mass { get; } = MassProperties.FromPrincipal(
        2.5, new Vector3d(1, 2, 2.5), new Quaterniond(0.9, 0.1, -0.3, 0.2), new Vector3d(0.1, -0.2, 0.3));

    public static BodyState State { get; } = new(
        new Vector3d(1, 2, -3), new Quaterniond(0.8, 0.2, -0.4, 0.4).Normalized, new Vector3d(0.5, -1, 0.25), new Vector3d(0.3, 1.1, -0.7));

    public static Instant Now { get; } = new(1, 0.7);

    /// <summary>The library's pushes, with numbers that leave no component zero; what is not in the list is made of such numbers.</summary>
    public static IEnumerable<TestCaseData> All()
    {
        TestCaseData[] listed = [.. Listed()];
        HashSet<string> names = [.. listed.Select(test => test.Arguments[0]!.GetType().Name)];
        return listed.Concat(typeof(IPush).Assembly.GetExportedTypes()
            .Where(type => type.IsValueType && typeof(IPush).IsAssignableFrom(type) && !names.Contains(type.Name))
            .Select(type => new TestCaseData(Made(type)).SetArgDisplayNames(type.Name)));
    }

    private static object Made(Type type)
    {
        Queue<Vector3d> vectors = new([new(1, -2, 3), new(-0.5, 0.25, 2), new(0.75, 1.5, -1), new(-2, 0.5, 1)]);
        System.Reflection.ParameterInfo[] parameters = type.GetConstructors().MaxBy(made => made.GetParameters().Length)!.GetParameters();
        return Activator.CreateInstance(type, [.. parameters.Select(parameter => parameter.ParameterType switch
        {
            Type of when of == typeof(Vector3d) => vectors.Dequeue(),
            Type of when of == typeof(double) => 0.4,
            Type of when of == typeof(bool) => (object)true,
            _ => throw new NotSupportedException($"{type.Name} cannot be made without being told its {parameter.Name}: give it a line in Pushes.Listed"),
        })])!;
    }

    private static IEnumerable<TestCaseData> Listed()
    {
        Vector3d a = new(1, -2, 3), b = new(-0.5, 0.25, 2), c = new(0.75, 1.5, -1);
        Force force = new(a);
        Torque swinging = new(a, b, c, 1.3, inBody: true);
        yield return Case("nothing", default(Nothing));
        yield return Case("force", force);
        yield return Case("force at a point, world axes", new Force(a, at: b));
        yield return Case("force at a point, body axes", new Force(a, at: b, inBody: true));
        yield return Case("force in body axes at the centre of mass", new Force(c, inBody: true));
        yield return Case("swinging force, world axes", new Force(a, b, c, 1.3));
        yield return Case("swinging force at a point, body axes", new Force(a, b, c, -0.7, at: c, inBody: true));
        foreach (LabKey key in Enum.GetValues<LabKey>())
            yield return Case("key " + key, new KeyPush(key));
        yield return Case("constant torque", Torque.Constant(a));
        yield return Case("swinging torque, body axes", swinging);
        yield return Case("swinging torque, world axes", new Torque(a, b, c, -0.4, inBody: false));
        yield return Case("torque that only swings as a cosine", new Torque(Vector3d.Zero, Vector3d.Zero, c, 2, inBody: false));
        yield return Case("quadratic drag", new QuadraticDrag(0.3));
        yield return Case("spring", new Spring(a, b, 4));
        yield return Case("heavy top", new HeavyTop(b, 3, c));
        yield return Case("forces and torques per step", new PerStep(Kicks, Kicks));
        yield return Case("forces per step", new PerStep(Kicks, []));
        yield return Case("torques per step", new PerStep([], Kicks));
        yield return Case("keys held", new HeldKeys(new LabKeyboard { [LabKey.UpArrow] = true, [LabKey.R] = true }));
        yield return Case("sum of two", new Both<Force, Torque>(force, swinging));
        yield return Case("sum of many", new Many([force, swinging, new Spring(a, b, 4)]));

        static TestCaseData Case(string name, IPush push) => new TestCaseData(push).SetArgDisplayNames(name);
    }

    public static Wrench At(IPush push, in Instant now, in BodyState state)
    {
        Wrench wrench = default;
        push.At(now, state, Mass, ref wrench);
        return wrench;
    }

    public static Wrench Over(IPush push, in Instant now, double duration, in BodyState state)
    {
        Wrench impulse = default;
        push.Over(now, duration, state, Mass, ref impulse);
        return impulse;
    }

    /// <summary>The largest difference of two components.</summary>
    public static double Apart(in Wrench a, in Wrench b) => Math.Max(
        Samples.Apart(a.Force, b.Force), Math.Max(Samples.Apart(a.Torque, b.Torque), Samples.Apart(a.BodyTorque, b.BodyTorque)));

    public static Wrench Times(double s, in Wrench a) =>
        new() { Force = s * a.Force, Torque = s * a.Torque, BodyTorque = s * a.BodyTorque };
}
