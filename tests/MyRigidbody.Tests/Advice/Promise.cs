using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Commands;

namespace RigidBodyDynamics.Tests;

/// <summary>The advice for a scene file, compared with <see cref="IndependentMotion"/>: the run of the advised integrator and step.</summary>
/// <param name="Error">The largest angle (rad) or distance (m) at the end of a step, and at places between where a shorter step leads.</param>
/// <param name="Still">How far two independent motions in different steps are apart at the same times: the error is known to this.</param>
internal sealed record Promise(double Error, double Still)
{
    private const int MostRows = 2000, PlacesBetween = 20;
    private const int MostParts = 32;
    private const double Longest = 0.02, StillEnough = 1e-12;

    /// <summary>Runs a scene as <c>run --integrator --step</c> does; a factor per step as the rate that it is in the scene's own steps.</summary>
    /// <remarks>The independent motion is refined until it stands still to a thousandth of the error, or to the last bits.</remarks>
    public static Promise Of(string path, string? integrator = null, double? step = null)
    {
        SceneDescription scene = Overrides.Apply(WithRates(SceneReader.Read(path).Scene), integrator, step);
        TimeSteps steps = scene.Steps;
        List<(double Time, BodyState[] Bodies)> states = [];
        Simulation simulation = new(scene);
        long every = Math.Max(1, steps.Count / MostRows);
        while (simulation.StepsDone < steps.Count)
        {
            simulation.Step(Math.Min(every, steps.Count - simulation.StepsDone));
            states.Add((simulation.Time, [.. simulation.Bodies.Select(body => body.State)]));
        }

        Random random = new(1);
        for (int i = 0; i < PlacesBetween; i++)
        {
            int whole = (int)Math.Min(random.NextInt64(steps.Count), 20_000);
            double part = random.NextDouble() * steps.Length(0);
            TimeSteps shorter = TimeSteps.Of([.. Enumerable.Repeat(steps.Length(0), whole), part]);
            Simulation between = new(new SceneDescription("between", string.Empty, shorter, scene.Bodies));
            between.Step(shorter.Count);
            states.Add(((whole * steps.Length(0)) + part, [.. between.Bodies.Select(body => body.State)]));
        }

        Promise found = new(0, 0);
        states.Sort((a, b) => a.Time.CompareTo(b.Time));
        for (int i = 0; i < scene.Bodies.Count; i++)
        {
            Promise one = new(0, double.PositiveInfinity);
            BodyState[] last = Motion(scene.Bodies[i], 1, states.Select(state => state.Time));
            for (int parts = 2; parts <= MostParts && one.Still > Math.Max(StillEnough, 1e-3 * one.Error); parts *= 2)
            {
                BodyState[] next = Motion(scene.Bodies[i], parts, states.Select(state => state.Time));
                one = new Promise(states.Zip(next, (state, right) => Apart(state.Bodies[i], right)).Max(), last.Zip(next, Apart).Max());
                last = next;
            }

            found = new Promise(Math.Max(found.Error, one.Error), Math.Max(found.Still, one.Still));
        }

        return found;
    }

    private static BodyState[] Motion(BodyDescription body, int parts, IEnumerable<double> times)
    {
        IndependentMotion motion = new(body, Longest, parts);
        return [.. times.Select(motion.At)];
    }

    private static double Apart(BodyState a, BodyState b) =>
        Math.Max(Conserved.AngleBetween(a.Orientation, b.Orientation), (a.Position - b.Position).Length);

    private static SceneDescription WithRates(SceneDescription scene)
    {
        BodyDescription[] bodies = [.. scene.Bodies.Select(body => body.Copy(body.Name, body.Mass).Without(effect => effect.Motion is DecayPerStep))];
        for (int i = 0; i < bodies.Length; i++)
        {
            foreach (Effect effect in scene.Bodies[i].Effects.Where(effect => effect.Motion is DecayPerStep))
            {
                Coasting factor = Coasting.Free;
                ((ICoast)effect.Motion).AddTo(ref factor, bodies[i].Mass);
                bodies[i].With(new LinearDamping(-Math.Log(factor.LinearFactorPerStep) / scene.Steps.Length(0)), effect.From, effect.To)
                    .With(new AngularDamping(-Math.Log(factor.AngularFactorPerStep) / scene.Steps.Length(0)), effect.From, effect.To);
            }
        }

        return new SceneDescription(scene.Name, scene.About, scene.Steps, bodies);
    }
}
