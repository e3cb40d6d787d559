using System.Globalization;
using System.Text;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>docs/hard-cases.md is made of what the tests measure.</summary>
public sealed class PageTests
{
    private static string File => Repository.Root.File("docs/hard-cases.md");

    /// <summary>MYRIGIDBODY_WRITE=1 dotnet test -c Release --filter Name~Page_of_hard_cases writes it anew.</summary>
    [Test]
    public void Page_of_hard_cases_says_what_the_tests_measure()
    {
        string page = Page();
        if (Environment.GetEnvironmentVariable("MYRIGIDBODY_WRITE") == "1")
            System.IO.File.WriteAllText(File, page);

        string[] expected = page.Split('\n'), written = System.IO.File.ReadAllText(File).Split('\n');
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

    private static string Page()
    {
        StringBuilder page = new();
        page.Append("""
            # Hard cases

            Motions that break programs which move rigid bodies, and what becomes of them here. Every figure is measured by a test;
            the test of the same name fails if it passes its bound, and another fails if the weak rule does not. This page is
            written by

                MYRIGIDBODY_WRITE=1 dotnet test -c Release --filter Name~Page_of_hard_cases

            Steps are 1/50 s where nothing else is said. Other programs: one free body, the same steps, damping, sleep and contacts
            off; engines as PhysX 5.1.3, Jolt 5.0.0, Rapier 0.36.1, Bullet 3.24, MuJoCo 4.0.0, ODE 0.16.2, Drake 1.51.1 with their
            gyroscopic terms on.

            | case | elsewhere | what is measured | bound | here, by `Exact` | a rule that fails |
            | --- | --- | --- | ---: | ---: | --- |

            """);
        foreach (HardCase hard in HardCaseList.All)
        {
            page.Append(CultureInfo.InvariantCulture, $"| {hard.Name.Replace('_', ' ').Replace("1e ", "1e-", StringComparison.Ordinal)} | {(hard.Elsewhere.Length > 0 ? hard.Elsewhere : "not measured")} | {hard.Figure} | {Short(hard.Bound)} | {Short(hard.By("Exact"))} | {hard.Weak}: {Short(hard.By(hard.Weak))} |\n");
        }

        page.Append("""

            ## Solved motions

            Reference solutions to 20 digits; the largest error of the whole motion, rad or m, in steps of 1/50 s. The last bit of
            the inputs alone makes the error of the second column: no rule can be held to less. The third is what `run` gives, where
            a body that coasts is not stepped; in the others every step is taken. `tests/data/hard-cases` has the bounds for five
            divisions of time.

            | motion | last bit | Exact, as run | Exact | Exact6 | Splitting | RungeKutta4 | ImplicitGyroscopic | LabEuler |
            | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |

            """);
        foreach (string motion in SolvedRun.Motions)
        {
            SolvedRun exact = SolvedRun.Of(motion, "Exact", "1/50");
            page.Append(CultureInfo.InvariantCulture, $"| {motion} | {Short(exact.Error / exact.Floors)} | {Short(SolvedRun.Of(motion, "Exact", "1/50", Omissions.All).Error)} | {Short(exact.Error)} |");
            foreach (string rule in new[] { "Exact6", "Splitting", "RungeKutta4", "ImplicitGyroscopic", "LabEuler" })
                page.Append(CultureInfo.InvariantCulture, $" {Short(SolvedRun.Of(motion, rule, "1/50").Error)} |");

            page.Append('\n');
        }

        return page.ToString();
    }

    private static string Short(double figure)
    {
        if (double.IsPositiveInfinity(figure))
            return "∞";

        return figure == 0 || (figure >= 0.01 && figure < 10_000)
            ? figure.ToString("0.##", CultureInfo.InvariantCulture)
            : figure.ToString("0.0e0", CultureInfo.InvariantCulture);
    }
}
