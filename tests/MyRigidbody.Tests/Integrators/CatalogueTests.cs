using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

public sealed class CatalogueTests
{
    [Test]
    public void Rules_like_the_labs_are_told_from_those_that_cost_several_of_its_steps() => Assert.That(
        Catalogue.Rows.Where(row => row.Cost == Cost.LikeTheLab).Select(row => row.Name),
        Is.EquivalentTo(new[] { "ExplicitEuler", "LabEuler", "Exact" }));

    [Test]
    public void Body_that_names_no_rule_moves_by_the_exact_one() => Assert.That(Catalogue.Default.Name, Is.EqualTo("Exact"));
}
