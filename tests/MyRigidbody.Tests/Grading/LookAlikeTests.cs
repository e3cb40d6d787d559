using NUnit.Framework;
using RigidBodyDynamics.Lab.Grading.Likeness;
using RigidBodyDynamics.StudentScripts;

namespace RigidBodyDynamics.Tests.Grading;

/// <summary>
/// Likeness of the scripts of the sample. They were written from a dozen bases; labels.json has the base of each.
/// </summary>
public sealed class LookAlikeTests
{
    private static readonly string[] Bases = ["210840014_学生二", "210840035_学生五", "210840056_学生八", "210840070_学生一〇", "210840084_学生一二", "210840119_学生一七", "210840280_学生四〇", "210840357_学生五一"];

    private static string[] Texts => [.. Bases.Select(Text)];

    [Test]
    public void Two_works_of_one_text_with_methods_in_another_order_share_all_and_the_next_pair_little()
    {
        string[] texts = [.. Texts, Text("210840161_学生二三")];

        IReadOnlyList<Pair> pairs = LookAlikes.Of(texts, Owners(texts), string.Empty, least: 0);

        Assert.That((pairs[0].First, pairs[0].Second), Is.EqualTo((1, texts.Length - 1)));
        Assert.That(pairs[0].Share, Is.GreaterThan(0.97)); // measured 1.00
        Assert.That(pairs[1].Share, Is.LessThan(0.3)); // measured 0.23
    }

    [Test]
    public void Other_names_comments_and_layout_hide_nothing()
    {
        string text = Text("210840014_学生二");
        string changed = text.Replace("torque", "M").Replace("force", "zzz").Replace("    ", "\t").Replace("//", "// ...").ReplaceLineEndings("\r\n");
        string[] texts = [.. Texts, changed];

        Pair pair = LookAlikes.Of(texts, Owners(texts), string.Empty)[0];

        Assert.That((pair.First, pair.Second, pair.Share), Is.EqualTo((0, texts.Length - 1, 1.0)));
        Assert.That(pair.FirstLines, Is.EquivalentTo(pair.SecondLines));
    }

    [Test]
    public void What_the_starter_has_and_what_many_have_is_no_likeness()
    {
        string text = Text("210840014_学生二");
        string[] copies = [text, text, text, text, text, .. Texts.Skip(1)];

        Assert.That(LookAlikes.Of([text, text], ["a", "b"], text), Is.Empty, "the starter");
        Assert.That(LookAlikes.Of(copies, Owners(copies), string.Empty), Is.Empty, "five of eleven");
    }

    [Test]
    public void Two_submissions_of_one_student_are_not_compared() =>
        Assert.That(LookAlikes.Of([Texts[0], Texts[0]], ["a", "a"], string.Empty), Is.Empty);

    [Test]
    public void As_few_pairs_as_join_them_are_shown()
    {
        HashSet<int> none = [];
        Pair[] pairs = [.. from i in Enumerable.Range(0, 5) from j in Enumerable.Range(i + 1, 4 - i) select new Pair(i, j, 1, none, none)];

        Assert.That(LookAlikes.Joining(pairs).Count(), Is.EqualTo(4));
    }

    private static string[] Owners(string[] texts) => [.. Enumerable.Range(0, texts.Length).Select(i => $"{i}")];

    private static string Text(string student) => SourceText.Decode(File.ReadAllBytes(TestData.Path("submissions", "class", student, "MyRigidbody.cs"))).Text;
}
