using System.Text.RegularExpressions;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests.Repository;

/// <summary>Our texts call one thing by one name, in both languages: that of docs/terms.md.</summary>
public sealed partial class GlossaryTests
{
    // a term with something in brackets has more than one meaning in English, so no text can be held to it by its letters
    private static readonly Term[] Terms = [.. Glossary.Rows(columns: 7).Select(row => new Term(row[0], row[1], row[4])).Where(term => !term.English.Contains('('))];

    private static readonly string[][] Avoided = [.. Glossary.Rows(columns: 4)];

    private static readonly string[] ChinesePages = [.. Tree.Files(".", "*.zh.md")];

    [Test]
    public void Every_term_is_called_by_its_Chinese_name_wherever_its_English_one_stands()
    {
        Translated[] texts = Glossary.Texts();
        string[] wrong = [.. from term in Terms
                             from text in texts
                             where term.Pattern.IsMatch(text.English) && !text.Chinese.Contains(term.Chinese, StringComparison.Ordinal)
                             // a field or file of that name is called so in Chinese too
                             where !term.Pattern.IsMatch(text.Chinese)
                             select $"{text.File}: {term.English} is {term.Chinese}: {text.English} | {text.Chinese}"];

        Assert.That(texts, Has.Length.GreaterThan(1000));
        Assert.That(Terms, Has.Length.GreaterThan(30));
        Assert.That(wrong, Is.Empty);
    }

    [Test]
    public void No_text_says_a_word_that_the_glossary_gives_up()
    {
        Translated[] texts = Glossary.Texts();

        Assert.That(Avoided, Has.Length.GreaterThan(5));
        foreach (string[] row in Avoided)
        {
            Assert.That(texts.Where(text => Regex.IsMatch(text.English, $@"\b{Regex.Escape(row[0])}\b", RegexOptions.IgnoreCase)), Is.Empty, $"{row[1]}, not {row[0]}");
            Assert.That(texts.Where(text => text.Chinese.Contains(row[2], StringComparison.Ordinal)), Is.Empty, $"{row[3]}, not {row[2]}");
        }
    }

    [TestCaseSource(nameof(ChinesePages))]
    public void No_Chinese_page_says_a_word_that_the_glossary_gives_up(string page) =>
        Assert.That(Avoided.Select(row => row[2]).Append("物体").Where(word => Tree.Text(page).Contains(word, StringComparison.Ordinal)), Is.Empty);

    [Test]
    public void A_body_is_one_thing_in_Chinese() =>
        Assert.That(Glossary.Texts().Where(text => text.Chinese.Contains("物体", StringComparison.Ordinal)), Is.Empty);

    [Test]
    public void What_the_glossary_names_is_in_the_code()
    {
        string code = string.Concat(new[] { "MyRigidbody.Core", "MyRigidbody.Judge", "MyRigidbody.Lab" }.SelectMany(folder => Tree.Files(folder, "*.cs")).Select(Tree.Text));
        string[] names = [.. Glossary.Rows(columns: 7).SelectMany(row => Code().Matches(row[4])).Select(match => match.Groups[1].Value)];

        Assert.That(names, Has.Length.GreaterThan(30));
        Assert.That(names.Where(name => !Regex.IsMatch(code, $@"\b(class|struct|interface|enum|record) {name.Split('.')[0]}\b")), Is.Empty);
        Assert.That(names.Where(name => !Regex.IsMatch(code, $@"\b{name.Split('.')[^1]}\b")), Is.Empty);
    }

    [GeneratedRegex("`([\\w.]+)`")]
    private static partial Regex Code();

    private sealed record Term(string English, string Chinese, string InCode)
    {
        /// <summary>The term by itself, one or many of it.</summary>
        public Regex Pattern { get; } = new($@"(?<![\w-]){Regex.Escape(English.TrimEnd('s'))}(s|es|ies)?(?![\w-])", RegexOptions.IgnoreCase | RegexOptions.CultureInvariant);
    }
}
