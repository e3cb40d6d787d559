using CsCheck;

namespace RigidBodyDynamics.Tests;

/// <summary>A body of any shape under any one push, with gravity and damping or without, and a step it can be followed with.</summary>
internal sealed record RandomScene(
    Vector3d Parts, double Unit, double Mass, Quaterniond Frame, Vector3d Center, BodyState Start, double Turn, Vector3d Gravity, double Damping, int Push)
{
    private const int Steps = 4;

    public static Gen<RandomScene> Any { get; } = Gen.Select(
        Gen.Select(Digits(-3, 0), Digits(-3, 0), Digits(-3, 0), Gen.Int[0, 4], Shape),
        Digits(-6, 6),
        Digits(-3, 3),
        Gen.Select(Samples.Turns, Gen.OneOf<Vector3d>(Gen.Const(Vector3d.Zero), Samples.Axes.Select(v => 0.3 * v))),
        Gen.Select(Samples.Vectors, Samples.Turns, Samples.Vectors, Samples.Vectors, (x, q, v, w) => new BodyState(x, q, v, w)),
        Gen.Double[0.05, 0.3],
        Gen.Select(Gen.OneOf<Vector3d>(Gen.Const(Vector3d.Zero), Samples.Vectors), Gen.OneOf(Gen.Const(0.0), Gen.Double[0, 1])),
        Gen.Int[0, 8],
        (parts, unit, mass, frame, start, turn, fall, push) => new RandomScene(
            parts, unit, mass, frame.Item1, frame.Item2, start, turn, fall.Item1, fall.Item2, push));

    /// <summary>
    /// The difference of an integrator's end from an independent solution, relative to the uncertainty of both: the change of the integrator's own
    /// answer when its step is halved, and that of Runge and Kutta at an eighth and a sixteenth of it, extrapolated.
    /// </summary>
    public double Off(string integrator)
    {
        BodyState found = Run(integrator, 1), finer = Run(integrator, 2), eighth = Run("RungeKutta4", 8), sixteenth = Run("RungeKutta4", 16);
        double allowed = 3 * Apart(found, finer) + Apart(sixteenth, eighth) / 15 + 1e-11;
        double off = Apart(found, Extrapolated(eighth, sixteenth)) / allowed;
        return double.IsFinite(off) ? off : double.PositiveInfinity;
    }

    /// <summary>True if the error of an integrator exceeds a millionth: its own estimate would excuse slow convergence.</summary>
    public bool OffByFixed(string integrator) => !(Apart(Run(integrator, 1), Run("RungeKutta4", 16)) < 1e-6);

    public BodyState Run(string integrator, int parts)
    {
        double step = Turn / (Start.AngularVelocity.Length + 1);
        return Scenery.Run(TimeSteps.Every(step / parts), Body(integrator), Steps * parts);
    }

    private BodyDescription Body(string integrator)
    {
        // moments that a body can have: sums of two of three positive parts
        Vector3d moments = Unit * new Vector3d(Parts.Y + Parts.Z, Parts.Z + Parts.X, Parts.X + Parts.Y);
        MassProperties mass = MassProperties.FromPrincipal(Mass, moments, Frame, Center);
        BodyDescription body = new("body", mass) { Rule = Rules.Named(integrator), Start = Start };
        if (!Gravity.IsZero)
            body.With(new Gravity(Gravity));

        if (Damping > 0)
            body.With(new LinearDamping(Damping)).With(new AngularDamping(0.5 * Damping));

        // pushes of the size of the body's motion: they change ω in the time of a rotation
        double least = Math.Min(moments.X, Math.Min(moments.Y, moments.Z)), k = Math.Min(Mass, least);
        Vector3d torque = 0.5 * least * new Vector3d(1, -0.5, 0.7);
        return Push switch
        {
            1 => body.With(new Force(Mass * new Vector3d(1, 2, -1))),
            2 => body.With(new Torque(torque, Vector3d.Zero, Vector3d.Zero, 0, inBody: true)),
            3 => body.With(new Torque(Vector3d.Zero, torque, 0.5 * torque, 1.3, inBody: false)),
            4 => body.With(new Torque(0.1 * torque, 0.5 * torque, torque, 0.7, inBody: true)),
            5 => body.With(new QuadraticDrag(0.05 * Mass)),
            6 => body.With(new Spring(new Vector3d(0.1, -0.2, 0.1), new Vector3d(1, 0, 0), 0.1 * k)),
            7 => body.With(new HeavyTop(new Vector3d(0, 0, 1), 0.5 * least, new Vector3d(0, 1, 0))),
            _ => body,
        };
    }

    /// <summary>Richardson: the error of an integrator of order 4 is a fifteenth of the difference between its last two answers.</summary>
    private static BodyState Extrapolated(in BodyState coarse, in BodyState fine) => new(
        fine.Position + (fine.Position - coarse.Position) / 15,
        (fine.Orientation + 1.0 / 15 * (fine.Orientation + -1 * coarse.Orientation)).Normalized,
        fine.Velocity + (fine.Velocity - coarse.Velocity) / 15,
        fine.AngularVelocity + (fine.AngularVelocity - coarse.AngularVelocity) / 15);

    private static double Apart(in BodyState a, in BodyState b) => new[]
    {
        Samples.Apart(a.Position, b.Position) / (1 + b.Position.Length),
        Conserved.AngleBetween(a.Orientation, b.Orientation),
        Samples.Apart(a.Velocity, b.Velocity) / (1 + b.Velocity.Length),
        Samples.Apart(a.AngularVelocity, b.AngularVelocity) / (1 + b.AngularVelocity.Length),
    }.Max();

    private static Gen<double> Digits(double from, double to) => Gen.Double[from, to].Select(digits => Math.Pow(10, digits));

    // any, two equal of three in every order, all equal
    private static Vector3d Shape(double a, double b, double c, int kind) => kind switch
    {
        1 => new Vector3d(a, a, b),
        2 => new Vector3d(a, b, a),
        3 => new Vector3d(b, a, a),
        4 => new Vector3d(a, a, a),
        _ => new Vector3d(a, b, c),
    };
}
