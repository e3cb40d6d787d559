namespace RigidBodyDynamics.Lab.Commands;

/// <summary>What breaks while a scene runs, as an error of its file.</summary>
internal static class Breakdown
{
    /// <summary>
    /// Runs something. An effect that broke is bad input (exit code 2) and named by its place in the file; a rule that ran away
    /// from the scene has fallen short (1).
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

    /// <summary>Which body ran away, when, under what.</summary>
    public static string InWords(StateOverflowException lost) =>
        $"body {(lost.Handle is Body one ? ManyBodies.NameOf(one) : lost.Body)}: {lost.Reason}";

    /// <summary>Commands run bodies under other names and with some of their effects only; an effect stays the one it is.</summary>
    private static string PlaceOf(BrokenEffectException broken, SceneDescription scene)
    {
        for (int body = 0; body < scene.Bodies.Count; body++)
        {
            for (int effect = 0; effect < scene.Bodies[body].Effects.Count; effect++)
            {
                if (scene.Bodies[body].Effects[effect] == broken.Entry)
                {
                    return $"bodies[{body}].effects[{effect}]";
                }
            }
        }

        return $"body {broken.Body}";
    }
}
