using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Comparison;

namespace RigidBodyDynamics.Tests.Comparison;

/// <summary>Scenes for the tests of the comparison.</summary>
internal static class Scenes
{
    /// <summary>The lab's keys on a body of the lab's and on one of Unity's.</summary>
    public static Pair Lab(Vector3d edges)
    {
        BodyDescription mine = new("mine", PointMasses.BoxVertices(1, edges)) { Rule = Rules.LabEuler };
        BodyDescription unity = new("unity", Solids.Box(1, edges)) { Rule = Rules.UnityRigidbody };
        return new Pair(Keys(mine).With(new DecayPerStep(0.98, 0.98)), Keys(unity));
    }

    /// <summary>Bodies as if they came from a file.</summary>
    public static SceneFile FileOf(TimeSteps steps, params BodyDescription[] bodies) => new(
        "scene.json",
        new SceneDescription("scene", string.Empty, steps, bodies),
        new Dictionary<string, ManyBodies>(),
        new Dictionary<string, MassProperties>(),
        null);

    private static BodyDescription Keys(BodyDescription body) => body
        .With(new KeyPush(LabKey.R), 0, 3)
        .With(new KeyPush(LabKey.RightArrow), 1, 2)
        .With(new KeyPush(LabKey.UpArrow), 1.5, 2.5);
}
