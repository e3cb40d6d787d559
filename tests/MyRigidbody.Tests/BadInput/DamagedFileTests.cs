using NUnit.Framework;
using RigidBodyDynamics.Fuzz;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.Tests;

/// <summary>The short form of <c>MyRigidbody.Fuzz</c>, which .ci/run lets run for longer.</summary>
public sealed class DamagedFileTests
{
    private const int Inputs = 2000, Seed = 2;

    [Test]
    public void A_damaged_file_is_refused_in_one_line_or_moves_and_takes_little_memory()
    {
        using TemporaryFolder folder = new();
        Reading reading = new(folder.Path);
        Mutations mutations = new(Input.Seeds(), Seed);
        Tally tally = new();

        Assert.That(
            () =>
            {
                for (int i = 0; i < Inputs; i++)
                    tally.Add("", reading.Of(mutations.Make(i)), reading.Times, TimeSpan.Zero);
            },
            Throws.Nothing,
            () => $"input {tally.Inputs}");
        // damage that is always refused, or never, would test nothing: measured 253 of 2000
        Assert.That(Inputs - tally[Outcome.Refused], Is.InRange(150, 600));
    }

    [TestCaseSource(nameof(Kept))]
    public void What_once_found_something_finds_nothing_any_more(object input)
    {
        using TemporaryFolder folder = new();

        Assert.That(() => new Reading(folder.Path).Of((Input)input), Throws.Nothing);
    }

    [Test]
    public void An_input_is_the_same_whenever_it_is_made()
    {
        Mutations mutations = new(Input.Seeds(), Seed), again = new(Input.Seeds(), Seed);
        again.Make(1);

        Assert.That(again.Make(123).Json, Is.EqualTo(mutations.Make(123).Json));
        Assert.That(mutations.Make(124).Json, Is.Not.EqualTo(mutations.Make(123).Json));
    }

    private static IEnumerable<TestCaseData> Kept() => Input.Corpus().Select(input => new TestCaseData(input).SetArgDisplayNames(input.Name));
}
