namespace RigidBodyDynamics.Lab;

/// <summary>Converts a scene to one whose motion does not depend on the step length, so that step lengths can be compared.</summary>
public static class StepFree
{
    /// <summary>
    /// The scene with rates in place of factors: a factor f once a step becomes damping at the rate −ln(f) / step, 1/s, which
    /// multiplies a velocity by the same factor over a step of the scene's own length.
    /// </summary>
    /// <remarks>Refuses effects without such a counterpart: values for every step, a factor with steps of several lengths, a factor of zero.</remarks>
    public static SceneDescription Of(SceneDescription scene)
    {
        TimeSteps steps = Guard.NotNull(scene, nameof(scene)).Steps;
        BodyDescription[] bodies = new BodyDescription[scene.Bodies.Count];
        for (int i = 0; i < bodies.Length; i++)
        {
            BodyDescription body = scene.Bodies[i];
            bodies[i] = body.Copy(body.Name, body.Mass).Without(effect => true);
            for (int j = 0; j < body.Effects.Count; j++)
                Add(bodies[i], body.Effects[j], steps, Place(i, j));
        }

        return new SceneDescription(scene.Name, scene.About, steps, bodies);
    }

    /// <summary>The places of factors per step in a scene, and the equivalent rates of damping of velocity and angular velocity, 1/s.</summary>
    internal static IEnumerable<(string Place, double Linear, double Angular)> Rates(SceneDescription scene)
    {
        for (int i = 0; i < scene.Bodies.Count; i++)
        {
            for (int j = 0; j < scene.Bodies[i].Effects.Count; j++)
            {
                Coasting coasting = Acts(scene.Bodies[i].Effects[j], scene.Bodies[i].Mass);
                if (HasFactor(coasting))
                    yield return (Place(i, j), Rate(coasting.LinearFactorPerStep, scene.Steps), Rate(coasting.AngularFactorPerStep, scene.Steps));
            }
        }
    }

    /// <summary>The scene with other steps and another integrator for every body.</summary>
    internal static SceneDescription By(SceneDescription scene, Rule rule, TimeSteps steps)
    {
        BodyDescription[] bodies = new BodyDescription[scene.Bodies.Count];
        for (int i = 0; i < bodies.Length; i++)
        {
            bodies[i] = scene.Bodies[i].Copy(scene.Bodies[i].Name, scene.Bodies[i].Mass);
            bodies[i].Rule = rule;
        }

        return new SceneDescription(scene.Name, scene.About, steps, bodies);
    }

    private static void Add(BodyDescription body, Effect effect, TimeSteps steps, string place)
    {
        if (effect.Motion is PerStep)
            throw Guard.Refused(place, effect.Motion, "must not be given step by step");

        Coasting coasting = Acts(effect, body.Mass);
        if (!HasFactor(coasting))
        {
            body.With(effect);
            return;
        }

        if (!(coasting.LinearFactorPerStep > 0 && coasting.AngularFactorPerStep > 0))
            throw Guard.Refused(place, effect.Motion, "must leave something of a velocity after a step");

        long other = steps.FirstOfOtherLength;
        if (other >= 0)
            throw Guard.Refused("step[" + other + "]", steps.Length(other), "must be as long as step[0], because of the factor per step in " + place);

        body.With(new Gravity(coasting.Acceleration), effect.From, effect.To)
            .With(new LinearDamping(coasting.LinearDampingRate + Rate(coasting.LinearFactorPerStep, steps)), effect.From, effect.To)
            .With(new AngularDamping(coasting.AngularDampingRate + Rate(coasting.AngularFactorPerStep, steps)), effect.From, effect.To);
    }

    private static string Place(int body, int effect) => "bodies[" + body + "].effects[" + effect + "]";

    private static Coasting Acts(Effect effect, MassProperties mass)
    {
        Coasting coasting = Coasting.Free;
        (effect.Motion as ICoast)?.AddTo(ref coasting, mass);
        return coasting;
    }

    private static bool HasFactor(in Coasting coasting) => coasting.LinearFactorPerStep != 1 || coasting.AngularFactorPerStep != 1;

    private static double Rate(double factor, TimeSteps steps) => factor == 1 ? 0 : MinusLog(factor) / steps.Length(0);

    /// <summary>−ln x for 0 &lt; x ≤ 1: Halley's iteration for e^(−y) = x, so that all runtimes agree.</summary>
    private static double MinusLog(double x)
    {
        double y = 0, before = double.NaN;
        // far from the root one iteration moves y by two, and the smallest double is e^(−745)
        for (int i = 0; i < 400 && y != before; i++)
        {
            double e = Elementary.Exp(-y);
            before = y;
            y += 2 * (e - x) / (e + x);
        }

        return y;
    }
}
