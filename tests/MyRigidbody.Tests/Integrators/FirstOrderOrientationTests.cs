using NUnit.Framework;
using RigidBodyDynamics.Tests.SceneFiles;

namespace RigidBodyDynamics.Tests;

/// <summary>
/// The sheet's q + [0, ½Δt ω] q rotates by 2 atan(ω Δt / 2), Unity by ω Δt. A homework script may use either formula: scenes say which, for
/// the lab's integrators and for Unity's.
/// </summary>
public sealed class FirstOrderOrientationTests
{
    // a ball that rotates at 6 rad/s about none of its own axes, 50 steps of 0.02 s
    private const double Spin = 6, Step = 0.02;

    [TestCase("LabEuler", "", true)]
    [TestCase("LabEuler", "\"lab\": { \"firstOrderOrientation\": true },", true)]
    [TestCase("LabEuler", "\"lab\": { \"firstOrderOrientation\": false },", false)]
    [TestCase("ExplicitEuler", "", true)]
    [TestCase("ExplicitEuler", "\"lab\": { \"firstOrderOrientation\": false },", false)]
    [TestCase("ExplicitEuler", "\"lab\": { \"firstOrderOrientation\": false, \"normalise\": false },", false)]
    [TestCase("UnityRigidbody", "\"unity\": { \"angularDrag\": 0, \"precision\": \"double\" },", false)]
    [TestCase("UnityRigidbody", "\"unity\": { \"angularDrag\": 0, \"precision\": \"double\", \"firstOrderOrientation\": true },", true)]
    public void Body_turns_by_the_angle_of_the_formula_that_the_scene_names(string rule, string settings, bool isFirstOrder)
    {
        Simulation simulation = Spinning(rule, settings);
        simulation.Step(50);

        double angle = 50 * (isFirstOrder ? 2 * Math.Atan(0.5 * Spin * Step) : Spin * Step);
        foreach (Body body in simulation.Bodies)
        {
            Quaterniond q = body.State.Orientation, expected = new(Math.Cos(0.5 * angle), Math.Sin(0.5 * angle) * new Vector3d(0.6, 0, 0.8));
            Assert.That(Math.Abs(Math.Abs(Quaterniond.Dot(q, expected)) - 1), Is.LessThan(1e-14)); // measured 2.2e-16
            Assert.That((q.Vector - Quaterniond.Dot(q, expected) * expected.Vector).Length, Is.LessThan(1e-14)); // measured 3.6e-16
        }
    }

    [TestCase("LabEuler", true)]
    [TestCase("LabEuler", false)]
    [TestCase("UnityRigidbody", true)]
    [TestCase("UnityRigidbody", false)]
    public void Many_turn_as_one_does_to_the_bit(string rule, bool isFirstOrder)
    {
        string settings = $"\"{(rule == "LabEuler" ? "lab" : "unity")}\": {{ \"firstOrderOrientation\": {(isFirstOrder ? "true" : "false")} }},";
        Simulation simulation = Spinning(rule, settings);
        simulation.Step(50);

        Assert.That(simulation.Bodies.Select(body => body.State), Has.All.EqualTo(simulation.Bodies[0].State));
    }

    [TestCase("LabEuler", "\"lab\": { \"firstOrderOrientation\": false },", "turned by the whole angle ω Δt")]
    [TestCase("UnityRigidbody", "\"unity\": { \"firstOrderOrientation\": true },", "turned by q + [0, ½Δt ω] q")]
    public void Explanation_says_what_differs_from_the_rule_s_own(string rule, string settings, string words)
    {
        Assert.That(new Explanation(Spinning(rule, settings).Bodies[0].Plan).ToString(), Does.Contain(words));
        Assert.That(new Explanation(Spinning(rule, string.Empty).Bodies[0].Plan).ToString(), Does.Not.Contain("turned by"));
    }

    /// <summary>Nine alike: the first has a mover of its own, the others are stepped together.</summary>
    private static Simulation Spinning(string rule, string settings)
    {
        BodyDescription body = SceneText.Read($$"""
            { "schema": "rigid-body-scene/1", "name": "n", "step": 0.02, "steps": 50, "bodies": [
              { "name": "ball", "integrator": "{{rule}}", {{settings}} "inertia": { "solidSphere": 1 }, "angularVelocity": [3.6, 0, 4.8] } ] }
            """).Scene.Bodies[0];
        Simulation simulation = new(TimeSteps.Every(Step));
        for (int i = 0; i < 9; i++)
            simulation.Add(body);

        return simulation;
    }
}
