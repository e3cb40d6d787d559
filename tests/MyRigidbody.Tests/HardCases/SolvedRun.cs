using System.Collections.Concurrent;

namespace RigidBodyDynamics.Tests;

/// <summary>One solved motion by one integrator with one division of time: its largest error.</summary>
/// <param name="Error">The larger of the angle, rad, and the distance, m; infinite if the run broke off.</param>
/// <param name="Floors">The same in units of the effect of the last bit of the inputs (running maximum).</param>
/// <param name="Energy">Kinetic energy against the true one, relative to its largest.</param>
/// <param name="Momentum">The vector L against the true one, relative to its largest.</param>
internal sealed record SolvedRun(double Error, double Floors, double Energy, double Momentum)
{
    /// <summary>All reference solutions of a body that a scene accepts; the lab's own discrete integrator has tests of its own.</summary>
    public static IReadOnlyList<string> Motions { get; } =
    [
        "asym_moderate", "sym_top", "tiny", "dzhanibekov_1e-3", "dzhanibekov_1e-8", "intermediate_axis", "separatrix", "plate",
        "needle", "fast_spin", "body_torque", "body_torque_axis", "world_torque", "cube_sin_torque", "cube_sin_torque_damped",
        "lagrange_top", "fall_linear_drag", "fall_quadratic_drag", "force_then_coast",
    ];

    public static IReadOnlyList<string> Divisions { get; } = ["1/10", "1/50", "1/60", "1/1000", "uneven"];

    public static bool IsFree(string motion) => motion is not ("body_torque" or "body_torque_axis" or "world_torque"
        or "cube_sin_torque" or "cube_sin_torque_damped" or "lagrange_top" or "fall_linear_drag" or "fall_quadratic_drag" or "force_then_coast");

    private static readonly ConcurrentDictionary<(string, string, string, Omissions), SolvedRun> Done = [];

    /// <summary>Run once, however many tests and tables ask.</summary>
    public static SolvedRun Of(string motion, string integrator, string division, Omissions omissions = Omissions.None) =>
        Done.GetOrAdd((motion, integrator, division, omissions), _ => Run(motion, integrator, division, omissions));

    private static SolvedRun Run(string motion, string integrator, string division, Omissions omissions)
    {
        ExactCase solved = ExactCase.Read(motion);
        (TimeSteps steps, List<(long At, ExactCase.Sample Sample, double Floor)> stops) = Divide(solved, division);
        Simulation simulation = new(new SceneDescription(motion, string.Empty, steps, [SolvedScene.Body(solved, integrator)]), omissions);
        Body body = simulation.Bodies[0];
        double largestEnergy = solved.Samples.Max(s => s["kinetic_energy"]), largestMomentum = solved.Samples.Max(s => TrueMomentum(s).Length);
        double error = 0, floors = 0, energy = 0, momentum = 0;
        foreach ((long at, ExactCase.Sample sample, double floor) in stops)
        {
            if (!simulation.TryStep(at - simulation.StepsDone))
                return new SolvedRun(double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity);

            double apart = Larger(
                Conserved.AngleBetween(body.State.Orientation, sample.Orientation), (body.State.Position - sample.Position).Length);
            error = Larger(error, apart);
            floors = Larger(floors, apart / floor);
            energy = Larger(energy, Math.Abs(body.KineticEnergy - sample["kinetic_energy"]) / largestEnergy);
            momentum = largestMomentum > 0 ? Larger(momentum, (body.AngularMomentum - TrueMomentum(sample)).Length / largestMomentum) : 0;
        }

        return new SolvedRun(error, floors, energy, momentum);
    }

    private static (TimeSteps Steps, List<(long At, ExactCase.Sample Sample, double Floor)> Stops) Divide(ExactCase solved, string division)
    {
        List<(long, ExactCase.Sample, double)> stops = [];
        List<double> lengths = [];
        double floor = 0, step = division == "uneven" ? 0 : 1 / double.Parse(division[2..], System.Globalization.CultureInfo.InvariantCulture);
        ExactCase.Sample before = solved.Samples[0];
        foreach (ExactCase.Sample sample in solved.Samples)
        {
            floor = Math.Max(floor, Math.Max(sample["double_attainable_error"], sample.Position.Length > 0 ? sample["double_position_error"] : 0));
            double whole = Math.Round(sample.Time / step);
            if (sample.Time > 0 && step > 0 && whole >= 1 && Math.Abs(whole * step - sample.Time) < 1e-9)
                stops.Add(((long)whole, sample, floor));

            if (sample.Time > 0 && step == 0)
            {
                // nine steps between two samples, from a twentieth of their mean to twice it
                double gap = sample.Time - before.Time;
                double[] parts = [0.0125, 0.2, 0.05, 0.1, 0.2375, 0.1, 0.025, 0.15, 0.125];
                lengths.AddRange(parts.Select(part => part * gap));
                stops.Add((lengths.Count, sample, floor));
                before = sample;
            }
        }

        return (step > 0 ? TimeSteps.Every(step) : TimeSteps.Of(lengths), stops);
    }

    private static Vector3d TrueMomentum(ExactCase.Sample s) => new(s["Lx"], s["Ly"], s["Lz"]);

    private static double Larger(double a, double b) => double.IsFinite(b) ? Math.Max(a, b) : double.PositiveInfinity;
}
