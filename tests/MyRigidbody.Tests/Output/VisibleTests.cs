using System.Text.Json;
using NUnit.Framework;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Tests.Output;

/// <summary>Foreign texts made safe to print.</summary>
public sealed class VisibleTests
{
    [TestCase("\u001b[31mred", @"\u001b[31mred")]
    [TestCase("\u009b31m", @"\u009b31m")]
    [TestCase("a\nerror: b", @"a\u000aerror: b")]
    [TestCase("a\r\n\tb", @"a\u000d\u000a\u0009b")]
    [TestCase("a\u2028b\u2029c\u0085d", @"a\u2028b\u2029c\u0085d")]
    [TestCase("\u202egpj.exe", @"\u202egpj.exe")]
    [TestCase("\u2066a\u2069\u200f\u061c", @"\u2066a\u2069\u200f\u061c")]
    [TestCase("\ufeffa\u00adb", @"\ufeffa\u00adb")]
    [TestCase("tag \U000E0041", @"tag \udb40\udc41")]
    [TestCase("", "")]
    public void What_nobody_sees_is_shown(string text, string shown) => Assert.That(Visible.Line(text), Is.EqualTo(shown));

    [TestCase("MyRigidbody in Unity")]
    [TestCase("刚体 Δt \U0001F469\u200D\U0001F680")]
    [TestCase("می\u200Cخواهم")]
    [TestCase(@"C:\users\name")]
    public void What_people_write_stays_as_it_is(string text) => Assert.That(Visible.Line(text), Is.EqualTo(text));

    [Test]
    public void Half_a_character_is_shown() => Assert.That(Visible.Line("half \ud83d" + "!"), Is.EqualTo(@"half \ud83d!"));

    [Test]
    public void Every_character_of_Unicode_that_moves_a_cursor_is_shown()
    {
        // C0, DEL and C1 are what terminals obey
        for (int code = 0; code < 0xA0; code++)
        {
            if (code is < 0x20 or >= 0x7F)
                Assert.That(Visible.Line(((char)code).ToString()), Has.Length.EqualTo(6), $"U+{code:X4}");
        }
    }

    [Test]
    public void JSON_means_the_same_and_keeps_its_lines()
    {
        const string Name = "a\u001b\u202e\u009b\n\\u0041 刚体 \U000E0041";
        string json = CompareSummary(Name);

        string shown = Visible.Json(json);

        Assert.That(JsonDocument.Parse(shown).RootElement.GetProperty("name").GetString(), Is.EqualTo(Name));
        Assert.That(shown.Count(letter => letter == '\n'), Is.EqualTo(2));
        Assert.That(shown, Does.Contain(@"\u202e").And.Contain("刚体"));
        Assert.That(shown.Any(letter => char.IsControl(letter) && letter is not ('\r' or '\n')), Is.False);
    }

    [Test]
    public void Messages_of_errors_are_one_line_whoever_catches_them()
    {
        Assert.That(new InputException("a\nerror: b\u202e").Message, Is.EqualTo(@"a\u000aerror: b\u202e"));
        Assert.That(new FellShortException("a\nerror: b\u202e").Message, Is.EqualTo(@"a\u000aerror: b\u202e"));
        Assert.That(new InputException(new string('x', 5000)).Message, Has.Length.EqualTo(1001));
    }

    private static string CompareSummary(string name) => JsonSerializer.Serialize(new { name }, Lab.Comparison.CompareSummary.Options);
}
