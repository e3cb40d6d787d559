using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

public sealed class RulesTests
{
    [Test]
    public void Integrators_like_the_labs_are_told_from_those_that_cost_several_of_its_steps() => Assert.That(
        Rules.All.Where(rule => rule.Cost == Cost.LikeTheLab).Select(rule => rule.Name),
        Is.EquivalentTo(new[] { "ExplicitEuler", "LabEuler", "Exact" }));

    [Test]
    public void Body_that_names_no_integrator_moves_by_the_exact_one() => Assert.That(Rules.Default.Name, Is.EqualTo("Exact"));

    [Test]
    public void Every_integrator_has_a_property_of_its_name_and_stands_in_the_list()
    {
        IEnumerable<(string, object?)> properties = typeof(Rules).GetProperties()
            .Where(property => property.PropertyType == typeof(Rule) && property.Name != nameof(Rules.Default))
            .Select(property => (property.Name, property.GetValue(null)));
        Assert.That(Rules.All.Select(rule => (rule.Name, (object?)rule)), Is.EquivalentTo(properties));
        Assert.That(Rules.All.Select(rule => Rules.Named(rule.Name)), Is.EqualTo(Rules.All));
    }

    [Test]
    public void Integrator_of_ones_own_has_the_name_of_its_struct_and_moves_a_crowd_to_the_same_bits()
    {
        BodyDescription body = Scenery.Body("Exact").With(new KeyPush(LabKey.R));
        body.Rule = Rules.Of<MomentumEuler>();
        Simulation alone = new(TimeSteps.Every(0.02), body);
        alone.Step(50);
        Together batch = new(body, TimeSteps.Every(0.02));
        int id = batch.Add(body.Start);
        batch.Step(50);
        Assert.That(body.Rule.Name, Is.EqualTo("MomentumEuler"));
        Assert.That(batch[id], Is.EqualTo(alone.Bodies[0].State));
        Assert.That(Rules.All, Does.Not.Contain(body.Rule));
    }

    [Test]
    public void Body_without_an_integrator_is_refused()
    {
        BodyDescription body = Scenery.Body("Exact");
        body.Rule = null!;
        Assert.That(() => new Simulation(TimeSteps.Every(0.02), body), Throws.ArgumentNullException.With.Property("ParamName").EqualTo("Rule"));
    }

    [Test]
    public void No_integrator_but_Unitys_lets_a_body_sleep()
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
    public void What_an_integrator_keeps_can_be_told_from_anything_else_it_keeps()
    {
        foreach (Keeps one in Enum.GetValues<Keeps>())
            Assert.That(((int)one & ((int)one - 1)), Is.Zero, one.ToString());
    }
}
