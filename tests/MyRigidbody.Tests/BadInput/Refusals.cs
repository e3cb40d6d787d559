using System.Globalization;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Every public place that takes a number, and the numbers that it must not take.</summary>
internal static class Refusals
{
    private static readonly double[] NotFinite = [double.NaN, double.PositiveInfinity, double.NegativeInfinity];
    private static readonly double[] NotAboveZero = [.. NotFinite, 0, -0.0, -1];
    private static readonly double[] BelowZero = [.. NotFinite, -1, -5e-324];
    private static readonly Vector3d One = new(1, 1, 1);
    private static readonly MassProperties Ball = Solids.Sphere(1, 1);

    /// <summary>What is done, the argument's name and the value that the message must show.</summary>
    public static IEnumerable<TestCaseData> All() => [.. Masses(), .. Shapes(), .. Effects(), .. Settings(), .. Times(), .. Starts()];

    private static IEnumerable<TestCaseData> Masses() =>
    [
        .. Numbers("mass", NotAboveZero, m => MassProperties.FromPrincipal(m, One)),
        .. Numbers("mass", NotAboveZero, m => MassProperties.FromTensor(m, SymmetricMatrix3.Identity, Vector3d.Zero)),
        .. Vectors("principal", NotAboveZero, i => MassProperties.FromPrincipal(1, i)),
        .. Vectors("inertia", NotFinite, i => MassProperties.FromTensor(1, new SymmetricMatrix3(i, Vector3d.Zero), Vector3d.Zero)),
        .. Vectors("inertia", NotFinite, i => MassProperties.FromTensor(1, new SymmetricMatrix3(One, i), Vector3d.Zero)),
        .. Vectors("centerOfMass", NotFinite, c => MassProperties.FromTensor(1, SymmetricMatrix3.Identity, c)),
        .. Vectors("centerOfMass", NotFinite, c => MassProperties.FromPrincipal(1, One, Quaterniond.Identity, c)),
        .. Vectors("centerOfMass", NotFinite, c => Ball.WithCenterOfMass(c)),
        .. Quaternions("frame", q => MassProperties.FromPrincipal(1, One, q, Vector3d.Zero)),
        Case("principal", "(1, 1, 2.5)", () => MassProperties.FromPrincipal(1, new Vector3d(1, 1, 2.5))),
    ];

    private static IEnumerable<TestCaseData> Shapes() =>
    [
        .. Numbers("mass", NotAboveZero, m => Solids.Box(m, One)),
        .. Numbers("mass", NotAboveZero, m => Solids.Sphere(m, 1)),
        .. Numbers("mass", NotAboveZero, m => Solids.Cylinder(m, 1, 1)),
        .. Numbers("mass", NotAboveZero, m => Solids.Capsule(m, 1, 1)),
        .. Numbers("mass", NotAboveZero, m => PointMasses.BoxVertices(m, One)),
        .. Numbers("mass", NotAboveZero, m => PointMasses.Equal(m, [One])),
        .. Vectors("edges", NotAboveZero, e => Solids.Box(1, e)),
        .. Vectors("edges", NotAboveZero, e => PointMasses.BoxVertices(1, e)),
        .. Numbers("radius", NotAboveZero, r => Solids.Sphere(1, r)),
        .. Numbers("radius", NotAboveZero, r => Solids.Cylinder(1, r, 1)),
        .. Numbers("radius", NotAboveZero, r => Solids.Capsule(1, r, 1)),
        .. Numbers("height", NotAboveZero, h => Solids.Cylinder(1, 1, h)),
        .. Numbers("height", NotAboveZero, h => Solids.Capsule(1, 1, h)),
        .. Vectors("points[1]", NotFinite, p => PointMasses.Equal(1, [One, p])),
        .. Vectors("points[1]", NotFinite, p => PointMasses.Of([One, p], [1, 1])),
        .. Numbers("masses[1]", NotAboveZero, m => PointMasses.Of([One, One], [1, m])),
        .. Vectors("position", NotFinite, p => new Compound().With(Ball, p)),
        .. Quaternions("orientation", q => new Compound().With(Ball, One, q)),
        Case("masses", "0", () => PointMasses.Of([], [])),
        Case("masses", "2", () => PointMasses.Of([One], [1, 2])),
        Case("masses", "0", () => PointMasses.Equal(1, [])),
        Case("mass of all parts", "0", () => new Compound().ToMassProperties()),
    ];

    private static IEnumerable<TestCaseData> Effects() =>
    [
        .. Vectors("force", NotFinite, f => new Force(f)),
        .. Vectors("gravity", NotFinite, g => new Gravity(g)),
        .. Vectors("constant", NotFinite, t => new Torque(t, One, One, 1, true)),
        .. Vectors("constant", NotFinite, t => Torque.Constant(t)),
        .. Vectors("sin", NotFinite, t => new Torque(One, t, One, 1, true)),
        .. Vectors("cos", NotFinite, t => new Torque(One, One, t, 1, true)),
        .. Numbers("rate", NotFinite, r => new Torque(One, One, One, r, true)),
        .. Numbers("linearDamping", BelowZero, c => new LinearDamping(c)),
        .. Numbers("angularDamping", BelowZero, c => new AngularDamping(c)),
        .. Numbers("quadraticDrag", BelowZero, k => new QuadraticDrag(k)),
        .. Numbers("linear", [.. BelowZero, 1.0000000000000002], f => new DecayPerStep(f, 1)),
        .. Numbers("angular", [.. BelowZero, 1.0000000000000002], f => new DecayPerStep(1, f)),
        .. Vectors("anchor", NotFinite, v => new Spring(v, One, 1)),
        .. Vectors("at", NotFinite, v => new Spring(One, v, 1)),
        .. Numbers("stiffness", BelowZero, k => new Spring(One, One, k)),
        .. Vectors("at", NotFinite, v => new Force(One, at: v)),
        .. Vectors("constant", NotFinite, f => new Force(f, One, One, 1)),
        .. Vectors("sin", NotFinite, f => new Force(One, f, One, 1)),
        .. Vectors("cos", NotFinite, f => new Force(One, One, f, 1)),
        .. Numbers("rate", NotFinite, r => new Force(One, One, One, r)),
        .. Vectors("at", NotFinite, v => new Force(One, One, One, 1, at: v, inBody: true)),
        .. Vectors("axis", NotFinite, v => new HeavyTop(v, 1, One)),
        .. Vectors("up", NotFinite, v => new HeavyTop(One, 1, v)),
        .. Numbers("moment", NotFinite, m => new HeavyTop(One, m, One)),
        Case("length of axis", "0", () => new HeavyTop(Vector3d.Zero, 1, One)),
        Case("length of up", "0", () => new HeavyTop(One, 1, Vector3d.Zero)),
        .. Vectors("force[1]", NotFinite, f => new PerStep([One, f], [])),
        .. Vectors("torque[0]", NotFinite, t => new PerStep([], [t])),
        Case("key", "99", () => new KeyPush((LabKey)99)),
        Case("axis length", "0", () => Quaterniond.FromAxisAngle(Vector3d.Zero, 1)),
    ];

    private static IEnumerable<TestCaseData> Settings() =>
    [
        .. Numbers("drag", BelowZero, v => new UnitySettings { Drag = v }),
        .. Numbers("angularDrag", BelowZero, v => new UnitySettings { AngularDrag = v }),
        .. Numbers("maxAngularVelocity", [double.NaN, double.NegativeInfinity, -1], v => new UnitySettings { MaxAngularVelocity = v }),
        .. Numbers("sleepThreshold", BelowZero, v => new UnitySettings { SleepThreshold = v }),
        .. Numbers("wakeCounter", BelowZero, v => new UnitySettings { WakeCounter = v }),
    ];

    private static IEnumerable<TestCaseData> Times() =>
    [
        .. Numbers("step", [.. NotAboveZero, 1e300, 1.0000001e9], h => TimeSteps.Every(h)),
        .. Numbers("step", [.. NotAboveZero, 1e300], h => TimeSteps.Every(h, 5)),
        .. Numbers("step", [.. NotAboveZero, 1e300], h => TimeSteps.Until(1, h)),
        .. Numbers("step[1]", [.. NotAboveZero, 1e300], h => TimeSteps.Of([0.1, h])),
        .. Numbers("duration", [.. NotAboveZero, 1e300], t => TimeSteps.Until(t, 0.02)),
        Case("steps", "0", () => TimeSteps.Every(0.1, 0)),
        Case("steps", "-7", () => TimeSteps.Every(0.1, -7)),
        Case("steps", "0", () => TimeSteps.Of([])),
        .. Numbers("from", [double.NaN], t => Body().With(new Force(One), t)),
        .. Numbers("to", [double.NaN, 1, 0.5, -1, double.NegativeInfinity], t => Body().With(new Force(One), 1, t)),
        .. Numbers("to", [double.NaN, 1, 0.5], t => Body().With(new Gravity(One), 1, t)),
        Case("to", "Infinity", () => Body().With(new Force(One), double.PositiveInfinity)),
    ];

    private static IEnumerable<TestCaseData> Starts() =>
    [
        .. Vectors("position", NotFinite, v => Run(b => b.Start = new BodyState(v, Quaterniond.Identity, One, One))),
        .. Vectors("velocity", NotFinite, v => Run(b => b.Start = new BodyState(One, Quaterniond.Identity, v, One))),
        .. Vectors("angularVelocity", NotFinite, v => Run(b => b.Start = new BodyState(One, Quaterniond.Identity, One, v))),
        .. Quaternions("orientation", q => Run(b => b.Start = new BodyState(One, q, One, One))),
        Case("orientation", "[0, 0, 0, 0]", () => Run(b => b.Start = default)),
        Case("velocity", "(0, 0, 1)", () => Run(b => (b.CanMove, b.Start) = (false, Moving(new Vector3d(0, 0, 1), Vector3d.Zero)))),
        Case("angularVelocity", "(0, 1, 0)", () => Run(b => (b.CanTurn, b.Start) = (false, Moving(Vector3d.Zero, new Vector3d(0, 1, 0))))),
        Case("integrator", "Rungekutta9", () => Run(b => b.Rule = Rules.Named("Rungekutta9"))),
        Case("integrator", "two lines", () => Run(b => b.Rule = Rules.Named("two\nlines"))),
        Case("integrator", "labEuler", () => Rules.Named("labEuler")),
        Case("order", "0", () => Rules.Of<LabEuler>(order: 0)),
        Case("name", "", () => Rules.Of<LabEuler>(string.Empty)),
        Case("name", "", () => new BodyDescription(string.Empty, Ball)),
        Case("bodies[1].name", "b", () => new Simulation(TimeSteps.Every(1), Body(), Body())),
        Case("count", "6", () => new Simulation(TimeSteps.Every(1, 5), Body()).Step(6)),
        Case("count", "-1", () => new Simulation(TimeSteps.Every(1, 5), Body()).Step(-1)),
    ];

    private static BodyDescription Body() => new("b", Ball);

    private static BodyState Moving(Vector3d velocity, Vector3d angularVelocity) =>
        new(Vector3d.Zero, Quaterniond.Identity, velocity, angularVelocity);

    private static void Run(Action<BodyDescription> change)
    {
        BodyDescription body = Body();
        change(body);
        _ = new Simulation(TimeSteps.Every(1), body);
    }

    private static IEnumerable<TestCaseData> Numbers(string name, double[] bad, Action<double> use) =>
        bad.Select(value => Case(name, value.ToString("R", CultureInfo.InvariantCulture), () => use(value)));

    // in each component
    private static IEnumerable<TestCaseData> Vectors(string name, double[] bad, Action<Vector3d> use) => bad
        .SelectMany(value => new[] { new Vector3d(value, 1, 2), new Vector3d(1, value, 2), new Vector3d(1, 2, value) })
        .Select(value => Case(name, value.ToString(), () => use(value)));

    private static IEnumerable<TestCaseData> Quaternions(string name, Action<Quaterniond> use) => new[]
    {
        default, new(1e-150, 0, 0, 0), new(0, 1e150, 0, 0), new(double.NaN, 0, 0, 1), new Quaterniond(1, 0, double.PositiveInfinity, 0),
    }.Select(value => Case(name, value.ToString(), () => use(value)));

    private static TestCaseData Case(string name, string value, TestDelegate use) =>
        new TestCaseData(name, value, use).SetArgDisplayNames(name, value);
}
