using Microsoft.VisualBasic.FileIO;

namespace RigidBodyDynamics.Figures;

/// <summary>The output of cost and bench in a folder: lines by the names of their columns.</summary>
internal sealed class Measured
{
    private readonly string _folder;

    public Measured(string folder)
    {
        _folder = folder;
        Cost = Read("cost.csv");
        Bench = Read("bench.csv");
        Engines = Read("engines.csv");
    }

    public IReadOnlyList<IReadOnlyDictionary<string, string>> Cost { get; }

    public IReadOnlyList<IReadOnlyDictionary<string, string>> Bench { get; }

    public IReadOnlyList<IReadOnlyDictionary<string, string>> Engines { get; }

    private List<IReadOnlyDictionary<string, string>> Read(string name)
    {
        string path = Path.Combine(_folder, name);
        if (!File.Exists(path))
            throw new FileNotFoundException($"{path}: is missing; cost and bench write it, the latter with Mono and the engines of tests/engines");

        using TextFieldParser csv = new(path) { HasFieldsEnclosedInQuotes = true };
        csv.SetDelimiters(",");
        string[] columns = csv.ReadFields() ?? [];
        List<IReadOnlyDictionary<string, string>> lines = [];
        while (csv.ReadFields() is string[] cells)
            lines.Add(columns.Zip(cells).ToDictionary(cell => cell.First, cell => cell.Second));

        return lines;
    }
}
