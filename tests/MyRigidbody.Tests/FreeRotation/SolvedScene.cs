using System.Globalization;
using System.Text.Json;

namespace RigidBodyDynamics.Tests;

/// <summary>A reference solution as a body with its torque and damping, and a run of it held against the samples.</summary>
internal static class SolvedScene
{
    public static BodyDescription Body(ExactCase solved, string integrator)
    {
        JsonElement inputs = solved.Inputs, initial = inputs.GetProperty("initial");
        BodyDescription body = inputs.GetProperty("kind").GetString() == "translation" ? Falling(inputs) : Turning(inputs, initial);
        body.Rule = Rules.Named(integrator);
        body.Unity = new UnitySettings
        {
            AngularDrag = 0,
            MaxAngularVelocity = double.PositiveInfinity,
            SleepThreshold = 0,
            InDouble = true,
        };
        if (inputs.TryGetProperty("angular_damping_rate", out JsonElement rate))
            body.With(new AngularDamping(Number(rate)));

        if (!inputs.TryGetProperty("torque", out JsonElement torque))
            return body;

        string frame = torque.GetProperty("frame").GetString()!;
        Vector3d up = new(0, 0, 1);
        return frame == "heavy_top"
            ? body.With(new HeavyTop(up, Number(torque.GetProperty("mgl")), up))
            : body.With(new Torque(Vector(torque, "constant"), Vector(torque, "sin"), Vector(torque, "cos"), 1, frame == "body"));
    }

    private static BodyDescription Turning(JsonElement inputs, JsonElement initial)
    {
        JsonElement turn = initial.GetProperty("quaternion_wxyz");
        Quaterniond q = new(Number(turn[0]), Number(turn[1]), Number(turn[2]), Number(turn[3]));
        return new BodyDescription("body", MassProperties.FromPrincipal(Number(inputs.GetProperty("mass")), Vector(inputs, "inertia")))
        {
            Start = new BodyState(Vector3d.Zero, q, Vector3d.Zero, Vector3d.Zero),
            AngularVelocityInBody = Vector(initial, "angular_velocity_body"),
        };
    }

    private static BodyDescription Falling(JsonElement inputs)
    {
        BodyDescription body = new("body", Solids.Sphere(Number(inputs.GetProperty("mass")), 1));
        if (inputs.TryGetProperty("gravity_down_y", out JsonElement g))
            body.With(new Gravity(new Vector3d(0, -Number(g), 0)));

        if (inputs.TryGetProperty("linear_damping_rate", out JsonElement c))
            body.With(new LinearDamping(Number(c)));

        if (inputs.TryGetProperty("quadratic_drag", out JsonElement k))
            body.With(new QuadraticDrag(Number(k)));

        return inputs.TryGetProperty("force", out JsonElement force)
            ? body.With(new Force(Vector(force, "value")), 0, Number(force.GetProperty("until")))
            : body;
    }

    /// <summary>Runs to every sample that is a whole number of steps away and hands over what was found and what is true.</summary>
    public static void Run(
        ExactCase solved,
        string integrator,
        double step,
        Action<BodyState, ExactCase.Sample, double> compare,
        Omissions omissions = Omissions.None)
    {
        Simulation simulation = new(new SceneDescription(integrator, string.Empty, TimeSteps.Every(step), [Body(solved, integrator)]), omissions);
        double floor = 0;
        foreach (ExactCase.Sample sample in solved.Samples)
        {
            // floors shrink again where neighbouring motions meet: the running maximum counts
            floor = Math.Max(floor, sample["double_attainable_error"]);
            double steps = Math.Round(sample.Time / step);
            if (steps < 1 || Math.Abs(steps * step - sample.Time) > 1e-9)
                continue;

            simulation.Step((long)steps - simulation.StepsDone);
            compare(simulation.Bodies[0].State, sample, floor);
        }
    }

    /// <summary>The angle to the true orientation at the end, rad.</summary>
    public static double ErrorAtEnd(ExactCase solved, string integrator, double step)
    {
        double error = double.NaN;
        Run(solved, integrator, step, (state, sample, _) => error = Conserved.AngleBetween(state.Orientation, sample.Orientation));
        return error;
    }

    private static double Number(JsonElement value) => double.Parse(value.GetRawText(), CultureInfo.InvariantCulture);

    private static Vector3d Vector(JsonElement owner, string name) => owner.TryGetProperty(name, out JsonElement n)
        ? new Vector3d(Number(n[0]), Number(n[1]), Number(n[2]))
        : Vector3d.Zero;
}
