using System.Globalization;
using Microsoft.CodeAnalysis;

namespace RigidBodyDynamics.Mutants;

/// <summary>Changes the Core in one place after another and asks whether the tests notice.</summary>
internal static class Program
{
    private static readonly string[] Folders = ["Mathematics", "Bodies", "FreeRotation", "Integrators"];

    private static int Main(string[] arguments)
    {
        CultureInfo.CurrentCulture = new CultureInfo("") { NumberFormat = { PercentPositivePattern = 0 } };
        if (arguments is ["worker"])
            return Worker.Serve();

        Wish? wish = Wish.Read(arguments);
        if (wish == null)
        {
            Console.Error.WriteLine(Wish.Usage);
            return 2;
        }

        string root = Root();
        string scratch = Path.Combine(root, "artifacts", "mutants");
        Directory.CreateDirectory(scratch);
        CoreCompilation core = new(Path.Combine(root, "MyRigidbody.Core"));
        List<SyntaxTree> trees = [.. core.Trees(Folders)];
        Ledger ledger = new(Path.Combine(scratch, "outcomes.json"));
        List<Mutant> all = [.. trees.SelectMany(tree => Mutations.Of(core.Meaning(tree)))];
        IReadOnlyList<Mutant> mutants = wish.Choose(all, ledger);
        Console.WriteLine($"{all.Count} places, {mutants.Count} of them asked for");

        Outcome[]? outcomes = wish.IsPage ? ledger.Of(all) : Judged(root, scratch, core, trees, mutants, wish, ledger);
        if (outcomes == null)
            return 1;

        outcomes = wish.IsWhole ? ledger.Of(all) : outcomes;
        Reasons reasons = Reasons.Read(Path.Combine(root, "tests", "MyRigidbody.Mutants", "reasons.json"));
        string figures = Report.Figures(outcomes, reasons), survivors = Report.Survivors(outcomes, reasons);
        Console.WriteLine((wish.IsWhole ? "" : survivors + "\n") + figures);
        if (wish.IsWhole)
        {
            File.WriteAllText(Path.Combine(root, "docs", "mutants.md"), Page.Of(all.Count, outcomes.Length, figures, survivors));
            foreach (string unused in reasons.Unused)
                Console.WriteLine("a reason nobody needs: " + unused);
        }

        return Report.Share(outcomes, reasons) >= wish.Demanded ? 0 : 1;
    }

    // nothing if the tests fail before anything is changed
    private static Outcome[]? Judged(
        string root, string scratch, CoreCompilation core, List<SyntaxTree> trees, IReadOnlyList<Mutant> mutants, Wish wish, Ledger ledger)
    {
        string testFolder = Path.Combine(root, "artifacts", "bin", "MyRigidbody.Tests", "release");
        Marks marks = new(trees);
        Coverage coverage;
        using (WorkerProcess first = new(scratch, testFolder))
            coverage = first.Cover(marks.Compile(core));
        Console.WriteLine($"{coverage.Tests.Length} tests pass in {coverage.Tests.Sum(test => test.Milliseconds) / 1000:F0} s");
        if (coverage.Failing.Length > 0)
        {
            Console.Error.WriteLine("these fail before anything is changed:\n" + string.Join('\n', coverage.Failing));
            return null;
        }

        Action<IEnumerable<Outcome>> save = wish.IsWhole ? ledger.Add : _ => { };
        Outcome[] outcomes = new Jury(core, new Plan(coverage, marks), scratch, testFolder, wish.WithoutGolden, save).Of(mutants);
        save(outcomes);
        return outcomes;
    }

    private static string Root()
    {
        DirectoryInfo? folder = new(AppContext.BaseDirectory);
        while (folder != null && !File.Exists(Path.Combine(folder.FullName, "MyRigidbody.sln")))
            folder = folder.Parent;
        return folder?.FullName ?? throw new DirectoryNotFoundException("no MyRigidbody.sln above the program");
    }
}
