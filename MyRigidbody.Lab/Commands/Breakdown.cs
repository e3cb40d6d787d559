using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Commands;

/// <summary>Turns an exception of a running scene into an error of its file.</summary>
internal static class Breakdown
{
    /// <summary>
    /// Runs something. An effect that failed is bad input (exit code 2), named by its place in the file; an integration that diverged
    /// is a result that fell short (1).
    /// </summary>
    public static T Placed<T>(string path, SceneDescription scene, Func<T> run)
    {
        try
        {
            return run();
        }
        catch (BrokenEffectException broken)
        {
            throw new InputException($"{path}: {PlaceOf(broken, scene)}: {broken.Reason}");
        }
        catch (StateOverflowException lost)
        {
            throw new FellShortException($"{path}: {InWords(lost)}");
        }
    }

    /// <summary>Runs something that has no result.</summary>
    public static void Placed(string path, SceneDescription scene, Action run) => Placed(path, scene, () =>
    {
        run();
        return true;
    });

    /// <summary>The body that diverged, the time and the effects.</summary>
    public static string InWords(StateOverflowException lost) =>
        $"body {(lost.Handle is Body one ? ManyBodies.NameOf(one) : lost.Body)}: {lost.Reason}";

    /// <summary>Commands run bodies under other names and with some of their effects only; the place of an effect stays.</summary>
    private static string PlaceOf(BrokenEffectException broken, SceneDescription scene)
    {
        for (int body = 0; body < scene.Bodies.Count; body++)
        {
            for (int effect = 0; effect < scene.Bodies[body].Effects.Count; effect++)
            {
                if (scene.Bodies[body].Effects[effect] == broken.Entry)
                    return $"bodies[{body}].effects[{effect}]";
            }
        }

        return $"body {broken.Body}";
    }
}
