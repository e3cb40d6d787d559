using System.Globalization;

namespace RigidBodyDynamics.Lab;

/// <summary>Reads a motion that was solved to 20 digits: its inputs (JSON) and its samples (CSV) beside them.</summary>
internal static class SolvedMotion
{
    // the samples are rounded to double when they are read
    private const double Uncertainty = 1.2e-16, BaseStep = 1, Same = 1e-9;

    /// <summary>The motions that are measured, and up to which time, s.</summary>
    public static readonly IReadOnlyList<(string Name, double Until)> All =
    [
        ("asym_moderate", 100),
        ("sym_top", 100),
        ("dzhanibekov_1e-3", 60),
        ("plate", 100),
        ("needle", 10),
        ("body_torque", 20),
        ("world_torque", 20),
        ("lagrange_top", 20),
        ("cube_sin_torque", 10),
        ("cube_sin_torque_damped", 10),
    ];

    private static string Folder => Path.Combine(AppContext.BaseDirectory, "exact");

    /// <summary>The motion with a name, up to a time in s.</summary>
    public static CostMotion Read(string name, double until) => JsonFile.Read(Path.Combine(Folder, name + ".json"), root =>
    {
        Fields fields = root.Fields(), initial = fields.Required("initial").Fields();
        BodyDescription body = new(name, MassProperties.FromPrincipal(fields.Required("mass").Number(), fields.Required("inertia").Vector()));
        Quaterniond turn = initial.Required("quaternion_wxyz").Turn();
        body.Start = new BodyState(Vector3d.Zero, turn, Vector3d.Zero, Vector3d.Zero);
        body.AngularVelocityInBody = initial.Required("angular_velocity_body").Vector();
        // without drag and limit, which Unity adds to a motion that has none: only the integrator is measured
        body.Unity = new UnitySettings { AngularDrag = 0, MaxAngularVelocity = double.PositiveInfinity, SleepThreshold = 0 };
        if (fields.Optional("torque") is Place torque)
            Add(body, torque.Fields());

        if (fields.Optional("angular_damping_rate") is Place rate)
            body.With(new AngularDamping(rate.Number()));

        string about = fields.Required("description").Text();
        SceneDescription scene = new(name, about, TimeSteps.Until(until, BaseStep), [body]);
        return new CostMotion(scene, new Truth(BaseStep, Uncertainty, Samples(name, until)), IsSolved: true);
    });

    private static void Add(BodyDescription body, Fields torque)
    {
        int frame = torque.Required("frame").OneOf("world", "body", "heavy_top");
        if (frame == 2)
        {
            Vector3d up = new(0, 0, 1);
            body.With(new HeavyTop(up, torque.Required("mgl").Number(), up));
            return;
        }

        body.With(new Torque(Vector("constant"), Vector("sin"), Vector("cos"), 1, inBody: frame == 1));

        Vector3d Vector(string name) => torque.Or(name, Vector3d.Zero, place => place.Vector());
    }

    /// <summary>The samples at whole multiples of the base step, which steps of every offered length reach.</summary>
    private static List<TruthSample> Samples(string name, double until)
    {
        string[] lines = File.ReadAllLines(Path.Combine(Folder, name + ".csv"));
        string[] columns = lines[0].Split(',');
        List<TruthSample> samples = [];
        double floor = 0;
        foreach (string line in lines.Skip(1))
        {
            double[] cells = [.. line.Split(',').Select(cell => double.Parse(cell, CultureInfo.InvariantCulture))];
            double time = Cell("t"), at = Math.Round(time / BaseStep);
            // the largest so far: the floor falls again where neighbouring motions meet
            floor = Math.Max(floor, Cell("double_attainable_error"));
            if (at >= 1 && time <= until + Same && Math.Abs((at * BaseStep) - time) < Same)
            {
                BodyState state = new(Vector("p"), new Quaterniond(Cell("qw"), Vector("q")), Vector("v"), Vector("ww"));
                samples.Add(new TruthSample((long)at, floor, [state]));
            }

            double Cell(string column) => cells[Array.IndexOf(columns, column)];

            Vector3d Vector(string of) => new(Cell(of + "x"), Cell(of + "y"), Cell(of + "z"));
        }

        return samples;
    }
}
