using System.Globalization;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Bench;

/// <summary>
/// One body on CoreCLR and on Mono, the runtime of Unity's editor. A process has one runtime, so a program of its own
/// (tests/MyRigidbody.StepTimes) measures on each, one after the other.
/// </summary>
/// <param name="Times">The times on both; empty if there is a problem.</param>
/// <param name="Problem">Why there are no times, in one line; empty if there are.</param>
internal sealed record OnMono(IReadOnlyList<OnMono.Row> Times, string Problem)
{
    // a busy machine may need several times the usual ten seconds
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(120);

    /// <summary>The program's folder beside the one that this runs from: bin/PROJECT/release, bin/PROJECT/release_net472.</summary>
    public static string Built(string framework)
    {
        DirectoryInfo own = new(Path.TrimEndingDirectorySeparator(AppContext.BaseDirectory));
        return Path.GetFullPath(Path.Combine(own.FullName, "..", "..", "MyRigidbody.StepTimes", own.Name + "_" + framework));
    }

    /// <summary>Measures, if Mono is on the PATH and the program was built.</summary>
    /// <param name="repeats">The number of repeats.</param>
    /// <param name="report">Receives the finished fraction.</param>
    public static OnMono Take(int repeats, Action<double> report)
    {
        string exe = Path.Combine(Built("net472"), "MyRigidbody.StepTimes.exe"), dll = Path.Combine(Built("net10.0"), "MyRigidbody.StepTimes.dll");
        if (OtherProgram.OnPath("mono") is not string mono)
            return Without("there is no mono on the PATH");

        if ((Path.GetFileNameWithoutExtension(Environment.ProcessPath) == "dotnet" ? Environment.ProcessPath : OtherProgram.OnPath("dotnet")) is not string dotnet)
            return Without("there is no dotnet on the PATH");

        if (new[] { exe, dll }.FirstOrDefault(file => !File.Exists(file)) is string missing)
            return Without($"{missing} is not there; dotnet build makes it");

        string[] arguments = ["rules", repeats.ToString(CultureInfo.InvariantCulture)];
        OtherProgram onMono = OtherProgram.Run(mono, [exe, .. arguments], new Dictionary<string, string>(), Patience);
        report(0.5);
        if (onMono.Problem.Length > 0)
            return Without(onMono.Problem);

        // with the compiler settings of the command line
        OtherProgram onCoreClr = OtherProgram.Run(dotnet, [dll, .. arguments], new Dictionary<string, string> { ["DOTNET_TieredPGO"] = "0" }, Patience);
        report(1);
        return onCoreClr.Problem.Length > 0 ? Without(onCoreClr.Problem) : Of(onCoreClr.Output, onMono.Output);
    }

    /// <summary>The rows for which both programs printed a time.</summary>
    public static OnMono Of(string coreClr, string mono)
    {
        Dictionary<string, double> times = Parse(mono);
        List<Row> rows = [.. Parse(coreClr).Where(line => times.ContainsKey(line.Key)).Select(line => new Row(line.Key, line.Value, times[line.Key]))];
        return rows.Count > 0 ? new OnMono(rows, string.Empty) : Without("the two programs printed no time of the same name");
    }

    /// <summary>The table for the terminal.</summary>
    public TextTable Table()
    {
        TextTable table = new("One body on CoreCLR and on Mono", "CoreCLR, ns", "Mono, ns", "ratio");
        foreach (Row row in Times)
        {
            string[] cells = [row.What, CostTables.Number(row.CoreClr), CostTables.Number(row.Mono), CostTables.Number(row.Mono / row.CoreClr)];
            table.AddRow(cells);
        }

        return table;
    }

    /// <summary>Lines for bench.csv; the allocation of a step there is not known.</summary>
    public string Csv() => string.Concat(Times.Select(row => string.Create(CultureInfo.InvariantCulture, $"\"{row.What}, on Mono\",1,1,{row.Mono:R},\n")));

    /// <summary>Name and time of each line that has both: the name ends at the last comma.</summary>
    private static Dictionary<string, double> Parse(string output)
    {
        Dictionary<string, double> times = [];
        foreach (string line in output.Split('\n'))
        {
            int comma = line.LastIndexOf(',');
            if (comma > 0 && double.TryParse(line[(comma + 1)..], NumberStyles.Float, CultureInfo.InvariantCulture, out double time) && time > 0 && double.IsFinite(time))
                times[line[..comma]] = time;
        }

        return times;
    }

    private static OnMono Without(string problem) => new([], problem);

    /// <summary>The time of a step on each runtime.</summary>
    /// <param name="What">Its name in bench.csv.</param>
    /// <param name="CoreClr">On CoreCLR, ns.</param>
    /// <param name="Mono">On Mono, ns.</param>
    internal sealed record Row(string What, double CoreClr, double Mono);
}
