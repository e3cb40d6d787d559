using System.Diagnostics;
using System.Runtime.CompilerServices;
using System.Text.Json;
using NUnit.Framework.Api;
using NUnit.Framework.Interfaces;

namespace RigidBodyDynamics.Mutants;

/// <summary>The process in which mutants run: one errand a line comes in, one answer a line goes out.</summary>
internal static class Worker
{
    private const string Namespace = "RigidBodyDynamics.Tests.";

    // fixtures that start processes, which would not see the mutant, and those about other parts than the four folders
    private static readonly string[] LeftOut =
    [
        "CommandLine.", "Repository.", "UnityProject.", "Package.", "Report.", "Animation.", "SceneFiles.", "Determinism.", "PageTests",
        "StandIn.", "StudentScripts.", "Judging.", "Grading.", "Output.", "Languages.",
        "AdvisorTests", "BodyByBodyTests", "TruthTests", "StepFreeTests", "AllocationTests", "DamagedFileTests",
    ];

    public static int Serve()
    {
        using StreamWriter answers = new(Console.OpenStandardOutput()) { AutoFlush = true };
        Console.SetOut(TextWriter.Null);
        Console.SetError(TextWriter.Null);
        bool isFurnished = false;
        while (Console.In.ReadLine() is string line)
        {
            Errand errand = JsonSerializer.Deserialize<Errand>(line)!;
            if (!isFurnished)
                TestBench.Furnish(errand.TestFolder);
            isFurnished = true;
            answers.WriteLine(errand.Batches.Length == 0 ? JsonSerializer.Serialize(Cover(errand)) : JsonSerializer.Serialize(Judge(errand, answers)));
        }

        return 0;
    }

    private static Verdict Judge(Errand errand, StreamWriter answers)
    {
        string? failed = null;
        using TestBench bench = new(File.ReadAllBytes(errand.Core), errand.TestFolder);
        foreach (Batch batch in errand.Batches)
        {
            using Timer watch = new(_ => GiveUp(batch, answers), null, (long)batch.Milliseconds, Timeout.Infinite);
            failed = bench.FirstFailure(batch.Fixtures, batch.Tests);
            if (failed != null)
                break;
        }

        return new Verdict(failed, false, Environment.WorkingSet);
    }

    // a loop without end cannot be left in any other way
    private static void GiveUp(Batch batch, StreamWriter answers)
    {
        answers.WriteLine(JsonSerializer.Serialize(new Verdict(batch.Tests[0], true, 0)));
        Process.GetCurrentProcess().Kill();
    }

    private static Coverage Cover(Errand errand)
    {
        using TestBench bench = new(File.ReadAllBytes(errand.Core), errand.TestFolder);
        bool[] marks = (bool[])bench.Core.GetType("RigidBodyDynamics.Reached")!.GetField("Marks")!.GetValue(null)!;
        foreach (Type type in bench.Core.GetTypes().Where(type => !type.ContainsGenericParameters))
            RuntimeHelpers.RunClassConstructor(type.TypeHandle);

        HashSet<int> once = [.. Taken(marks)];
        List<KnownTest> tests = [];
        List<string> failing = [];
        foreach (Type fixture in bench.Fixtures.Where(type => !LeftOut.Any(name => type.FullName![Namespace.Length..].StartsWith(name, StringComparison.Ordinal))))
        {
            RuntimeHelpers.RunClassConstructor(fixture.TypeHandle);
            NUnitTestAssemblyRunner runner = bench.List([fixture.FullName!], toFirstFailure: false);
            int[] listing = Taken(marks);
            TestBench.Run(runner, result =>
            {
                if (result.ResultState.Status == TestStatus.Passed)
                    tests.Add(new KnownTest(fixture.FullName!, result.FullName, result.Duration * 1000, [.. Taken(marks).Union(listing)]));
                else
                    failing.Add(result.FullName);
            });
        }

        return new Coverage([.. tests], [.. once], [.. failing]);
    }

    private static int[] Taken(bool[] marks)
    {
        int[] set = [.. Enumerable.Range(0, marks.Length).Where(mark => marks[mark])];
        Array.Clear(marks);
        return set;
    }
}
