using System.Globalization;
using System.Text;

namespace RigidBodyDynamics.Tests;

/// <summary>The page of hard cases, docs/hard-cases.md and the same in Chinese, made from the measurements of the tests.</summary>
internal static class HardCasePage
{
    private const string English = """
        # Hard cases

        [中文](hard-cases.zh.md)

        Motions that break programs which move rigid bodies, and what becomes of them here. Every figure is measured by a test;
        the test of the same name fails if it passes its bound, and another fails if the weak integrator does not. This page is
        written by

            MYRIGIDBODY_WRITE=1 dotnet test -c Release --filter Name~Page_of_hard_cases

        Steps are 1/50 s where nothing else is said. Other programs: one free body, the same steps, damping, sleep and contacts
        off; engines as PhysX 5.1.3, Jolt 5.0.0, Rapier 0.36.1, Bullet 3.24, MuJoCo 4.0.0, ODE 0.16.2, Drake 1.51.1 with their
        gyroscopic terms on.

        | case | elsewhere | what is measured | bound | here, by `Exact` | an integrator that fails |
        | --- | --- | --- | ---: | ---: | --- |

        """;

    private const string Chinese = """
        # 困难情形

        [English](hard-cases.md)

        使刚体运动程序出错的运动，以及本程序的结果。每个数字都由测试测得：超过界限时，同名的测试失败；薄弱的积分器若没有超过，另一个测试失败。
        本页由下面的命令写出：

            MYRIGIDBODY_WRITE=1 dotnet test -c Release --filter Name~Page_of_hard_cases

        没有另外说明时步长为 1/50 s。其他程序：一个自由的刚体，步长相同，没有阻尼、休眠和接触；引擎为 PhysX 5.1.3、Jolt 5.0.0、Rapier 0.36.1、Bullet 3.24、
        MuJoCo 4.0.0、ODE 0.16.2、Drake 1.51.1，陀螺项打开。

        | 情形 | 其他程序 | 测量的量 | 界限 | 本程序，`Exact` | 不能通过的积分器 |
        | --- | --- | --- | ---: | ---: | --- |

        """;

    private const string Solved = """

        ## Solved motions

        Reference solutions to 20 digits; the largest error of the whole motion, rad or m, in steps of 1/50 s. The last bit of
        the inputs alone makes the error of the second column: no integrator can have a smaller one. The third is what `run` gives, where
        a body that coasts is not stepped; in the others every step is taken. `tests/data/hard-cases` has the bounds for five
        divisions of time.

        | motion | last bit | Exact, as run | Exact | Exact6 | Splitting | RungeKutta4 | ImplicitGyroscopic | LabEuler |
        | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |

        """;

    private const string SolvedInChinese = """

        ## 已求解的运动

        参照解有 20 位；表中是步长 1/50 s 时全程的最大误差，rad 或 m。仅输入数据的末位就造成第二列的误差，任何积分器都不能要求更小。第三列是 `run` 的结果，其中没有推动的
        刚体不逐步计算；其余各列每一步都计算。`tests/data/hard-cases` 有五种步长的界限。

        | 运动 | 末位 | Exact，run 的结果 | Exact | Exact6 | Splitting | RungeKutta4 | ImplicitGyroscopic | LabEuler |
        | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |

        """;

    /// <summary>The page in one of the languages.</summary>
    public static string In(bool isChinese)
    {
        StringBuilder page = new(isChinese ? Chinese : English);
        foreach (HardCase hard in HardCaseList.All)
        {
            (string name, string figure, string elsewhere) = isChinese ? HardCaseWords.InChinese[hard.Name] : InEnglish(hard);
            page.Append(CultureInfo.InvariantCulture, $"| {name} | {elsewhere} | {figure} | {Short(hard.Bound)} | {Short(hard.By("Exact"))} | {hard.Weak}: {Short(hard.By(hard.Weak))} |\n");
        }

        page.Append(isChinese ? SolvedInChinese : Solved);
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

    private static (string Name, string Figure, string Elsewhere) InEnglish(HardCase hard) =>
        (hard.Name.Replace('_', ' ').Replace("1e ", "1e-", StringComparison.Ordinal), hard.Figure, hard.Elsewhere.Length > 0 ? hard.Elsewhere : "not measured");

    private static string Short(double figure)
    {
        if (double.IsPositiveInfinity(figure))
            return "∞";

        return figure == 0 || (figure >= 0.01 && figure < 10_000)
            ? figure.ToString("0.##", CultureInfo.InvariantCulture)
            : figure.ToString("0.0e0", CultureInfo.InvariantCulture);
    }
}
