namespace RigidBodyDynamics.Lab;

/// <summary>Makes of a scene one whose motion is the same however its time is divided, so that steps can be compared.</summary>
public static class StepFree
{
    /// <summary>
    /// The scene with rates in place of factors: a factor f once a step becomes damping at the rate −ln(f) / step,
    /// 1/s, which leaves as much of a velocity after each step of the scene's own length.
    /// </summary>
    /// <remarks>Refuses what has no such counterpart: values for every step, steps of several lengths, a factor of zero.</remarks>
    public static Scene Of(Scene scene)
    {
        TimeSteps steps = Guard.NotNull(scene, nameof(scene)).Steps;
        long other = steps.FirstOfOtherLength;
        if (other >= 0)
            throw Guard.Refused("step[" + other + "]", steps.Length(other), "must be as long as step[0]");

        BodyDescription[] bodies = new BodyDescription[scene.Bodies.Count];
        for (int i = 0; i < bodies.Length; i++)
        {
            BodyDescription body = scene.Bodies[i];
            bodies[i] = body.Copy(body.Name, body.Mass).Without(effect => true);
            for (int j = 0; j < body.Effects.Count; j++)
                Add(bodies[i], body.Effects[j], steps.Length(0), "bodies[" + i + "].effects[" + j + "]");
        }

        return new Scene(scene.Name, scene.About, steps, bodies);
    }

    /// <summary>The scene with other steps and another rule for every body.</summary>
    internal static Scene By(Scene scene, string integrator, TimeSteps steps)
    {
        BodyDescription[] bodies = new BodyDescription[scene.Bodies.Count];
        for (int i = 0; i < bodies.Length; i++)
        {
            bodies[i] = scene.Bodies[i].Copy(scene.Bodies[i].Name, scene.Bodies[i].Mass);
            bodies[i].Integrator = integrator;
        }

        return new Scene(scene.Name, scene.About, steps, bodies);
    }

    private static void Add(BodyDescription body, Effect effect, double step, string place)
    {
        if (effect.Motion is PerStep)
            throw Guard.Refused(place, effect.Motion, "must not be given step by step");

        Coasting coasting = Coasting.Free;
        (effect.Motion as ICoast)?.AddTo(ref coasting);
        double linear = coasting.LinearFactorPerStep, angular = coasting.AngularFactorPerStep;
        if (linear == 1 && angular == 1)
        {
            body.With(effect);
            return;
        }

        if (!(linear > 0 && angular > 0))
            throw Guard.Refused(place, effect.Motion, "must leave something of a velocity after a step");

        body.With(new Gravity(coasting.Acceleration), effect.From, effect.To)
            .With(new LinearDamping(coasting.LinearDampingRate + MinusLog(linear) / step), effect.From, effect.To)
            .With(new AngularDamping(coasting.AngularDampingRate + MinusLog(angular) / step), effect.From, effect.To);
    }

    /// <summary>−ln x for 0 &lt; x ≤ 1: Halley's rule on e^(−y) = x, so that all runtimes agree.</summary>
    private static double MinusLog(double x)
    {
        double y = 0;
        // far from the root it goes by steps of two, and the smallest double is e^(−745)
        for (int i = 0; i < 400; i++)
        {
            double e = Elementary.Exp(-y);
            y += 2 * (e - x) / (e + x);
        }

        return y;
    }
}
