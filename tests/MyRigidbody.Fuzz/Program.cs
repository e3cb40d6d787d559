using System.Globalization;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Fuzz;

/// <summary>
/// Feeds the readers of the command line with damaged files: a refusal in one line or a motion is what they may answer,
/// and nothing else. The last line sums up; exit code 1 if something was found, which then lies in out/fuzz.
/// </summary>
internal static class Program
{
    private const int MostFindings = 10;
    private static readonly TimeSpan Longest = TimeSpan.FromSeconds(20);

    private static int Main(string[] arguments)
    {
        if (arguments is ["large", string into])
        {
            LargeFiles.Write(into);
            return 0;
        }

        int seed = 1;
        if (arguments.Length is 0 or > 2 || !Number(arguments[0], out int count) || (arguments.Length == 2 && !Number(arguments[1], out seed)))
        {
            Console.Error.WriteLine("usage: MyRigidbody.Fuzz COUNT [SEED], or large FOLDER");
            return 2;
        }

        string folder = Path.GetFullPath(Path.Combine("out", "fuzz"));
        Directory.CreateDirectory(folder);
        Tally tally = new();
        int findings = 0, namesShown = 0;
        Terminal.WithProgress("fuzz", report => (findings, namesShown) = Run(count, seed, folder, tally, report));
        Console.WriteLine($"{tally}; {namesShown} names shown or set off in rows");
        return findings == 0 ? 0 : 1;
    }

    private static (int Findings, int NamesShown) Run(int count, int seed, string folder, Tally tally, Action<double> report)
    {
        int findings = 0;
        Input input = null!;
        string name = string.Empty;
        using Watchdog watchdog = new(Longest, () =>
        {
            Found("takes too long");
            Environment.Exit(1);
        });
        Reading reading = new(folder);
        IReadOnlyList<Input> seeds = Input.Seeds();
        Mutations mutations = new(seeds, seed);
        for (int i = -seeds.Count; i < count && findings < MostFindings; i++)
        {
            input = i < 0 ? seeds[i + seeds.Count] : mutations.Make(i);
            name = i < 0 ? input.Name : string.Create(CultureInfo.InvariantCulture, $"{input.Name}-{seed}-{i}");
            watchdog.Next();
            try
            {
                Outcome outcome = reading.Of(input);
                tally.Add(name, outcome, reading.Times, watchdog.Elapsed);
            }
            catch (Exception crash)
            {
                findings++;
                Found(crash is FoundException ? crash.Message : crash.ToString());
            }

            report((double)i / count);
        }

        return (findings, reading.NamesShown);

        void Found(string what)
        {
            string path = Path.Combine(folder, name + ".json");
            input.Write(path);
            Console.Error.WriteLine($"{path}: {what}");
        }
    }

    private static bool Number(string text, out int number) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out number);
}
