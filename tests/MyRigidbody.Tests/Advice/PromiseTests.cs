using NUnit.Framework;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.Tests;

/// <summary>
/// The advice of <c>choose</c> for a scene holds by a method that shares nothing with it. More scenes than a few:
/// <c>dotnet test ... --filter PromiseTests -- TestRunParameters.Parameter(name=\"scenes\",value=\"200\")</c>.
/// </summary>
public sealed class PromiseTests
{
    private static IEnumerable<int> Scenes => Enumerable.Range(0, int.Parse(TestContext.Parameters.Get("scenes", "12")));

    [TestCaseSource(nameof(Scenes))]
    public void Integrator_and_step_that_are_advised_keep_the_error(int number)
    {
        RandomChoice choice = RandomChoice.Of(number);
        using TemporaryFolder folder = new();
        string path = folder.File("scene.json");
        File.WriteAllText(path, choice.Json);

        Advice advice = Advisor.Choose(SceneReader.Read(path).Scene, choice.Error);

        Assert.That(advice.Reason.Length == 0, Is.EqualTo(advice.Reached));
        if (!advice.Reached)
            return;

        Promise found = Promise.Of(path, advice.Best.Rule.Name, advice.Best.Step);
        Assert.That(found.Error - found.Still, Is.LessThan(choice.Error), $"{advice.Best.Rule.Name} in {advice.Best.Step} s");
        Assert.That(found.Still, Is.LessThan(Math.Max(1e-11, 0.01 * choice.Error)), "the independent motion must stand still");
    }

    // an oscillation, a rotation of a body whose centre of mass is not at its origin, and a push that begins, by closed forms
    [Test]
    public void Independent_motion_is_that_of_the_closed_forms()
    {
        BodyDescription swing = new BodyDescription("swing", Solids.Sphere(2, 0.5)) { Start = new BodyState(new Vector3d(0.5, 0, 0), Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero) }
            .With(new Spring(Vector3d.Zero, Vector3d.Zero, 50)).With(new LinearDamping(2));
        BodyDescription turn = new("turn", MassProperties.FromPrincipal(1, new Vector3d(1, 1, 2)).WithCenterOfMass(new Vector3d(0.3, 0, 0)))
        {
            Start = new BodyState(new Vector3d(-0.3, 0, 0), Quaterniond.Identity, Vector3d.Zero, new Vector3d(0, 0, 2)),
        };
        BodyDescription push = new BodyDescription("push", Solids.Sphere(1, 0.5)).With(new Force(new Vector3d(3, 0, 0)), 1.0 / 3);

        // x'' = −25 x − 2 x': e^(−t) (cos νt + sin νt / ν) / 2, ν² = 24
        double nu = Math.Sqrt(24), x = 0.5 * Math.Exp(-3) * (Math.Cos(3 * nu) + (Math.Sin(3 * nu) / nu));
        Assert.That(new IndependentMotion(swing, 0.02).At(3).Position.X, Is.EqualTo(x).Within(1e-14)); // measured 8.2e-16
        Assert.That((new IndependentMotion(turn, 0.02).At(3).Position - (-0.3 * new Vector3d(Math.Cos(6), Math.Sin(6), 0))).Length, Is.LessThan(1e-13)); // measured 3.5e-15
        Assert.That(new IndependentMotion(push, 0.02).At(1).Position.X, Is.EqualTo(1.5 * 4 / 9).Within(1e-14)); // measured 6.7e-15
    }
}
