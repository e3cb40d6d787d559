using NUnit.Framework;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.StudentScripts;
using RigidBodyDynamics.Tests.StudentScripts;

namespace RigidBodyDynamics.Tests.Judging;

/// <summary>
/// Right scripts of the sample, changed in one place by a program. A change of the motion must be found, any other must not be flagged.
/// Of 1252 changes 1167 run to their end: 776 make a difference, 391 make none. A few by default; all with
/// MYRIGIDBODY_SEARCH=all, which takes twenty minutes.
/// </summary>
internal sealed class SmallChangesTests
{
    private const int One = 100;

    [TestCase("210840007_学生一")]
    [TestCase("210840014_学生二")]
    [TestCase("210840035_学生五")]
    [TestCase("210840056_学生八")]
    [TestCase("210840070_学生一〇")]
    public void A_small_change_is_found_if_and_only_if_it_makes_a_difference(string student)
    {
        string text = File.ReadAllText(TestData.Path("submissions", "class", student, "MyRigidbody.cs"));
        Recording right = Runner.Run(text).Recording!;
        List<string> wrong = [];
        int tried = 0, differing = 0;
        foreach ((string name, string changed) in SmallChanges.Of(text).Where((_, i) => Search.IsAll || i % One == 0))
        {
            ScriptReport report = Runner.Run(changed);
            if (report.Recording == null)
                continue;
            tried++;
            bool differs = Difference.Between(right, report.Recording), isFlagged = Judge.Decide(report.Recording).Outcome != Outcome.Right;
            differing += differs ? 1 : 0;
            if (differs != isFlagged)
                wrong.Add($"{name} {(differs ? "was not found" : "was flagged and makes no difference")}");
        }

        TestContext.Out.WriteLine($"of {SmallChanges.Of(text).Count()} changes {tried} run to their end, {differing} make a difference");
        Assert.That(wrong, Is.Empty);
    }
}
