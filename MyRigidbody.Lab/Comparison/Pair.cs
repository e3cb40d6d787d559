using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Comparison;

/// <summary>A body of a scene, and the Rigidbody that Unity would make of it.</summary>
internal sealed record Pair(BodyDescription Mine, BodyDescription Default)
{
    /// <summary>
    /// The pairs of a scene: a body of Unity's belongs to the body before it; a body without one gets one with Unity's defaults.
    /// </summary>
    public static IReadOnlyList<Pair> Of(SceneFile file)
    {
        List<Pair> pairs = [];
        IReadOnlyList<BodyDescription> bodies = file.Scene.Bodies;
        for (int i = 0; i < bodies.Count; i++)
        {
            if (bodies[i].Rule == Rules.UnityRigidbody)
                continue;

            bool isNextUnitys = i + 1 < bodies.Count && bodies[i + 1].Rule == Rules.UnityRigidbody;
            pairs.Add(new Pair(bodies[i], isNextUnitys ? bodies[i + 1] : InUnity(bodies[i], file.SolidBoxes)));
        }

        return pairs.Count > 0
            ? pairs
            : throw new InputException($"{file.Path}: bodies: there is none to compare with {Rules.UnityRigidbody}, all of them are it");
    }

    /// <summary>An object with these settings in Unity: its collider's inertia, drag for damping.</summary>
    private static BodyDescription InUnity(BodyDescription mine, IReadOnlyDictionary<string, MassProperties> solidBoxes)
    {
        BodyDescription unity = mine.Copy(mine.Name + " in Unity", solidBoxes.GetValueOrDefault(mine.Name, mine.Mass));
        Coasting coasting = Coasting.Free;
        foreach (Effect effect in mine.Effects.Where(Difference.IsDamping))
            ((ICoast)effect.Motion).AddTo(ref coasting, mine.Mass);

        unity.Rule = Rules.UnityRigidbody;
        unity.Unity = new UnitySettings();
        // a rate is drag in Unity; a factor per step has no counterpart and is removed
        if (coasting.LinearDampingRate > 0 || coasting.AngularDampingRate > 0)
        {
            unity.Unity.Drag = coasting.LinearDampingRate;
            unity.Unity.AngularDrag = coasting.AngularDampingRate;
        }

        return unity.Without(effect => Difference.IsDamping(effect));
    }
}
