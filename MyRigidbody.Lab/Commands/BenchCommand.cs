using System.CommandLine;
using System.Globalization;
using System.Text;
using RigidBodyDynamics.Lab.Bench;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Commands;

/// <summary>Times everything, each thing together with what it is compared with.</summary>
internal static class BenchCommand
{
    private const string DefaultFile = "out/bench.csv", EnginesFile = "engines.csv";

    public static Command Create()
    {
        Option<string> output = new("--out") { Description = "the CSV file", DefaultValueFactory = _ => DefaultFile };
        Option<bool> quick = new("--quick") { Description = "fewer repeats, and no million bodies" };
        Command command = new("bench", "Time per step of every integrator, of each effect acting, idle and absent, of one body and of many, on Mono, and of other engines") { output, quick };
        command.SetAction(parsed => Execute(parsed.GetRequiredValue(output), parsed.GetValue(quick)));
        return command;
    }

    private static int Execute(string file, bool isQuick)
    {
        string folder = Path.GetDirectoryName(Path.GetFullPath(file.Length > 0 ? file : throw new InputException("--out: must not be empty")))
            ?? throw new InputException($"{file}: is a folder");
        (string Title, IReadOnlyList<Measurement> Group)[] groups =
        [
            ("One body, turning freely", Suite.ByRule()),
            ("The lab's step", Suite.ByHand()),
            ("Torques", Suite.Torques()),
            ("Effects", Suite.Effects()),
            ("What a body is", Suite.Shapes()),
            ("Damped to nothing", Suite.Denormals()),
            ("Steps of a game", LivingSuite.Calls()),
            ("One of many, chosen at random", LivingSuite.OneOf(isQuick ? 1000 : 1_000_000)),
            .. (isQuick ? [1, 1000] : new[] { 1, 1000, 100_000, 1_000_000 }).Select(count =>
                (count.ToString("N0", CultureInfo.InvariantCulture) + (count == 1 ? " body" : " bodies"), Suite.Many(count))),
        ];
        StringBuilder csv = new("what,bodies,threads,nanosecondsPerBodyStep,bytesAllocated\n");
        OnMono onMono = null!;
        OtherEngines others = null!;
        Terminal.WithProgress("measuring times", report =>
        {
            for (int i = 0; i < groups.Length; i++)
            {
                int before = i;
                bool isLong = groups[i].Group[0].Bodies > 10_000;
                Measurement.Take(groups[i].Group, isLong ? 25 : isQuick ? 250 : 1250, isLong ? 0.02 : 0.0002, done => report((before + done) / (groups.Length + 2)));
            }

            onMono = OnMono.Take(isQuick ? 50 : 250, done => report((groups.Length + done) / (groups.Length + 2)));
            others = OtherEngines.Take(groups.SelectMany(group => group.Group), isQuick ? 5 : 25);
        });

        foreach ((string title, IReadOnlyList<Measurement> group) in groups)
        {
            TextTable table = new(title, "threads", "ns a step", "half of them", "bytes");
            foreach (Measurement m in group)
            {
                table.AddRow(
                    m.What, m.Threads.ToString(CultureInfo.InvariantCulture), Short(m.Median),
                    $"{Short(m.Spread.Low)} to {Short(m.Spread.High)}", Short(m.BytesAllocated));
                csv.Append(CultureInfo.InvariantCulture, $"\"{m.What}\",{m.Bodies},{m.Threads},{m.Median:R},{m.BytesAllocated:R}\n");
            }

            Terminal.Write(table);
        }

        if (onMono.Problem.Length > 0)
            Terminal.WriteLine("One body on CoreCLR and on Mono: left out, because " + onMono.Problem);
        else
            Terminal.Write(onMono.Table());

        if (others.Problem.Length > 0)
            Terminal.WriteLine("Other engines: left out, because " + others.Problem);
        else
            Terminal.Write(others.Table());

        csv.Append(onMono.Csv());
        Measurement[] all = [.. groups.SelectMany(group => group.Group)];
        Terminal.Write(Ratios.Table(all));
        Terminal.WriteLine(Ratios.Quiet(all.Select(m => (m.What, m.RatioToItself))));
        using Files files = new(folder, file, []);
        files.Write(Path.GetFileName(file), temporary => File.WriteAllText(temporary, csv.ToString(), new UTF8Encoding(false)));
        if (others.Rows.Count > 0)
            files.Write(EnginesFile, temporary => File.WriteAllText(temporary, others.Csv(), new UTF8Encoding(false)));

        files.Keep();
        Terminal.WriteLine("written: " + file + (others.Rows.Count > 0 ? $", and {EnginesFile} beside it" : string.Empty));
        return 0;
    }

    private static string Short(double figure) =>
        figure.ToString(figure < 0.1 && figure > 0 ? "0.000" : figure < 10 ? "0.0#" : "0", CultureInfo.InvariantCulture);
}
