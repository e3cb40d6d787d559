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

    /// <summary>What is kept in the repository: seeds, and inputs that once found something.</summary>
    public static IReadOnlyList<Input> Corpus() => From(Path.Combine(AppContext.BaseDirectory, "corpus"));

    /// <summary>What mutations start from: the corpus and the scenes that travel with the program.</summary>
    public static IReadOnlyList<Input> Seeds() =>
        [.. Corpus(), .. From(Gallery.Folder).Where(input => !input.Name.Contains("schema", StringComparison.Ordinal))];

    /// <summary>Writes its files; a file beside it that it does not have goes.</summary>
    public void Write(string jsonPath)
    {
        string csvPath = Path.ChangeExtension(jsonPath, ".csv");
        // a file that is made anew need not wait for the disk, as one that is cut to nothing may
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
