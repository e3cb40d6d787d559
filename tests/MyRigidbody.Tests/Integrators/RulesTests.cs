using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

public sealed class RulesTests
{
    [Test]
    public void Rules_like_the_labs_are_told_from_those_that_cost_several_of_its_steps() => Assert.That(
        Rules.All.Where(rule => rule.Cost == Cost.LikeTheLab).Select(rule => rule.Name),
        Is.EquivalentTo(new[] { "ExplicitEuler", "LabEuler", "Exact" }));

    [Test]
    public void Body_that_names_no_rule_moves_by_the_exact_one() => Assert.That(Rules.Default.Name, Is.EqualTo("Exact"));

    [Test]
    public void No_rule_but_Unitys_lets_a_body_sleep()
    {
        foreach (string integrator in Scenery.Integrators)
        {
            BodyDescription body = Scenery.Body(integrator);
            body.Start = BodyState.AtRest;
            Simulation simulation = new(TimeSteps.Every(0.02), body);
            simulation.Step(50);
            Assert.That(simulation.Bodies[0].IsAsleep, Is.EqualTo(integrator.StartsWith("Unity", StringComparison.Ordinal)), integrator);
        }
    }

    [Test]
    public void What_a_rule_keeps_can_be_told_from_anything_else_it_keeps()
    {
        foreach (Keeps one in Enum.GetValues<Keeps>())
            Assert.That(((int)one & ((int)one - 1)), Is.Zero, one.ToString());
    }
}
