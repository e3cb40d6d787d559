using RigidBodyDynamics.Lab;

namespace RigidBodyDynamics.Fuzz;

/// <summary>A file to be read: a scene, or a recording with its rows in a second file.</summary>
/// <param name="Name">What it was made of.</param>
/// <param name="Json">The scene or recording.</param>
/// <param name="Csv">The rows beside a recording.</param>
internal sealed record Input(string Name, byte[] Json, byte[]? Csv)
{
    /// <summary>Bytes in all its files.</summary>
    public long Size => Json.Length + (Csv?.Length ?? 0);

    /// <summary>The corpus of the repository: seeds, and inputs that once found an error.</summary>
    public static IReadOnlyList<Input> Corpus() => From(Path.Combine(AppContext.BaseDirectory, "corpus"));

    /// <summary>The seeds of mutations: the corpus and the scenes of the program.</summary>
    public static IReadOnlyList<Input> Seeds() =>
        [.. Corpus(), .. From(Gallery.Folder).Where(input => !input.Name.Contains("schema", StringComparison.Ordinal))];

    /// <summary>Writes its files; deletes a file beside it that it does not have.</summary>
    public void Write(string jsonPath)
    {
        string csvPath = Path.ChangeExtension(jsonPath, ".csv");
        // a new file need not wait for the disk, as a truncated one may
        File.Delete(jsonPath);
        File.Delete(csvPath);
        File.WriteAllBytes(jsonPath, Json);
        if (Csv != null)
            File.WriteAllBytes(csvPath, Csv);
    }

    private static IReadOnlyList<Input> From(string folder) =>
        [.. Directory.GetFiles(folder, "*.json").Order(StringComparer.Ordinal).Select(Read)];

    private static Input Read(string path)
    {
        string csv = Path.ChangeExtension(path, ".csv");
        return new Input(Path.GetFileNameWithoutExtension(path), File.ReadAllBytes(path), File.Exists(csv) ? File.ReadAllBytes(csv) : null);
    }
}
