using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Commands;

/// <summary>Options of the command line that replace values of the scene.</summary>
internal static class Overrides
{
    /// <summary>The scene with another integrator, another step, or both, for every body.</summary>
    public static SceneDescription Apply(SceneDescription scene, string? integrator, double? step)
    {
        if (integrator != null)
        {
            Rule rule = Named("--integrator", () => Rules.Named(integrator));
            foreach (BodyDescription body in scene.Bodies)
                body.Rule = rule;
        }

        if (step == null)
            return scene;

        if (scene.Bodies.Any(body => body.Effects.Any(effect => effect.Motion is PerStep)))
            throw new InputException("--step: the scene gives a force for every step, so its steps cannot be changed");

        double duration = scene.Steps.StartOf(scene.Steps.Count);
        TimeSteps steps = Named("--step", () => TimeSteps.Until(duration, step.Value));
        return new SceneDescription(scene.Name, scene.About, steps, scene.Bodies);
    }

    /// <summary>The simulation of a scene; an exception of the Core becomes an error of the file.</summary>
    public static Simulation Start(string path, SceneDescription scene)
    {
        try
        {
            return new Simulation(scene);
        }
        catch (ArgumentException refused)
        {
            throw new InputException($"{path}: {refused.Message}");
        }
    }

    /// <summary>Runs something; an exception of the Core becomes an error of the option or file of that name.</summary>
    internal static void Named(string option, Action attempt) => Named(option, () =>
    {
        attempt();
        return true;
    });

    /// <summary>Creates something; an exception of the Core becomes an error of the option or file of that name.</summary>
    internal static T Named<T>(string option, Func<T> make)
    {
        try
        {
            return make();
        }
        catch (ArgumentException refused)
        {
            throw new InputException($"{option}: {refused.Message}");
        }
    }
}
