using NUnit.Framework;

namespace RigidBodyDynamics.Tests.Repository;

/// <summary>The public types are those that a user needs, under names that do not collide with Unity's.</summary>
public sealed class PublicTypesTests
{
    private static readonly Type[] Public = typeof(Simulation).Assembly.GetExportedTypes();

    // an effect more is one more for those scenes alone that ask for it
    [Test]
    public void User_has_at_most_42_types_to_know_besides_the_effects()
    {
        Type[] known = [.. Public.Where(type => !(type.IsValueType && typeof(IEffect).IsAssignableFrom(type)))];
        TestContext.Out.WriteLine($"{known.Length} of {Public.Length}: {string.Join(", ", known.Select(type => type.Name).Order(StringComparer.Ordinal))}");
        Assert.That(known, Has.Length.LessThanOrEqualTo(42)); // measured 42
    }

    [Test]
    public void No_type_has_the_name_of_one_of_Unitys()
    {
        string[] unitys = [.. File.ReadLines(Root.File("tests/data/unity-types.txt")).Where(line => !line.StartsWith('#')).Select(line => line[(line.LastIndexOf('.') + 1)..])];

        Assert.That(unitys, Is.SupersetOf(new[] { "Scene", "Hand", "Key", "Keyboard" }), "what ours were called once");
        Assert.That(Public.Select(type => type.Name.Split('`')[0]).Intersect(unitys), Is.Empty);
    }

    [TestCase("README.md")]
    [TestCase("README.zh.md")]
    [TestCase("MyRigidbody.Core/README.md")]
    public void Listing_of_a_first_page_needs_nothing_else(string page)
    {
        IEnumerable<string> listing = File.ReadLines(Root.File(page)).SkipWhile(line => line != "```csharp").Skip(1).TakeWhile(line => line != "```");

        Assert.That(() => Outside.Program("using System;\nusing RigidBodyDynamics;\n" + string.Join('\n', listing)), Throws.Nothing);
    }
}
