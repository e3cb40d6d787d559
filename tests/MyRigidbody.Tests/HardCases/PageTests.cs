using System.Globalization;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>docs/hard-cases.md, and the same in Chinese, are made from the measurements of the tests.</summary>
public sealed class PageTests
{
    /// <summary>MYRIGIDBODY_WRITE=1 dotnet test -c Release --filter Name~Page_of_hard_cases writes it anew.</summary>
    [TestCase("docs/hard-cases.md", false)]
    [TestCase("docs/hard-cases.zh.md", true)]
    public void Page_of_hard_cases_says_what_the_tests_measure(string name, bool isChinese)
    {
        string page = HardCasePage.In(isChinese), file = Repository.Root.File(name);
        if (Environment.GetEnvironmentVariable("MYRIGIDBODY_WRITE") == "1")
            File.WriteAllText(file, page);

        string[] expected = page.Split('\n'), written = File.ReadAllText(file).Split('\n');
        Assert.That(written, Has.Length.EqualTo(expected.Length));
        for (int i = 0; i < written.Length; i++)
        {
            string[] found = written[i].Split('|', StringSplitOptions.TrimEntries), right = expected[i].Split('|', StringSplitOptions.TrimEntries);
            Assert.That(found, Has.Length.EqualTo(right.Length), written[i]);
            for (int cell = 0; cell < found.Length; cell++)
                Assert.That(Same(found[cell], right[cell]), $"line {i + 1}: \"{found[cell]}\" is now \"{right[cell]}\"");
        }
    }

    // an arctangent of another system's library may move a last bit, and that moves a figure of 1e-16
    private static bool Same(string a, string b) => a == b
        || (Number(a, out double x) && Number(b, out double y) && Math.Max(x, y) <= 1.5 * Math.Min(x, y));

    private static bool Number(string text, out double number) =>
        double.TryParse(text.Split(' ')[0], NumberStyles.Float, CultureInfo.InvariantCulture, out number);
}
