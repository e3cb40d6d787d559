using NUnit.Framework;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Tests.StudentScripts;

namespace RigidBodyDynamics.Tests.Judging;

/// <summary>
/// 72 right, 172 wrong and 15 doubtful ways to write the lab's script. Every tenth by default; all with MYRIGIDBODY_SEARCH=all,
/// which takes three minutes.
/// </summary>
internal sealed class VariationTests
{
    private const int One = 10;

    private static readonly Lazy<(Variation Script, Verdict Verdict)[]> Judged = new(() =>
        [.. Variation.All().Where((_, i) => Search.IsAll || i % One == 0).Select(script => (script, Runner.Run(script.Text).Verdict))]);

    [Test]
    public void Every_script_is_called_what_it_is() =>
        Assert.That(Judged.Value.Where(one => one.Verdict.Outcome != one.Script.Outcome).Select(Told), Is.Empty);

    // of all: 2, which set ω from v, and damp two components of v
    [Test]
    public void The_steps_that_are_wrong_are_among_those_named() =>
        Assert.That(Judged.Value.Where(one => one.Script.Steps.Except(Named(one.Verdict)).Any()).Select(Told).ToArray(), Has.Length.LessThanOrEqualTo(0.01 * Judged.Value.Length));

    // of all: 4
    [Test]
    public void Hardly_ever_is_another_step_named_too() =>
        Assert.That(Judged.Value.Where(one => Named(one.Verdict).Except(one.Script.Steps).Any()).Select(Told).ToArray(), Has.Length.LessThanOrEqualTo(0.05 * Judged.Value.Length));

    // of all: 1
    [Test]
    public void Mistakes_are_called_by_their_words()
    {
        (Variation Script, Verdict Verdict)[] labelled = [.. Judged.Value.Where(one => one.Script.Code != null)];
        Assert.That(labelled.Where(one => !one.Verdict.Findings.Any(finding => finding.Code == one.Script.Code)).Select(Told).ToArray(), Has.Length.LessThanOrEqualTo(0.1 * labelled.Length));
    }

    private static IEnumerable<int> Named(Verdict verdict) =>
        Verdict.FiveSteps.Where(step => verdict[step] != Mark.Right).Select(step => (int)step).Concat(verdict.GivenChanged ? [0] : []);

    private static string Told((Variation Script, Verdict Verdict) one) =>
        $"{one.Script.Outcome} [{string.Join(" ", one.Script.Steps)}] {one.Script.Code} ({one.Script}): {one.Verdict.Outcome} [{string.Join(" ", Named(one.Verdict))}] {string.Join(", ", one.Verdict.Findings.Select(finding => finding.Code))}";
}
