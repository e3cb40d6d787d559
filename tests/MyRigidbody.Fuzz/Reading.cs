using System.Buffers;
using System.Globalization;
using System.Text;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Lab.Report;

namespace RigidBodyDynamics.Fuzz;

/// <summary>The result of an input.</summary>
internal enum Outcome
{
    /// <summary>The reader reported the error in one line.</summary>
    Refused,

    /// <summary>It was read and simulated, and all numbers stayed finite.</summary>
    Ran,

    /// <summary>It was read, and its simulation diverged and was reported.</summary>
    RanAway,
}

/// <summary>An error found by an input.</summary>
internal sealed class FoundException(string what) : Exception(what);

/// <summary>Reads an input as a user's file, and simulates what was accepted.</summary>
internal sealed class Reading(string folder)
{
    /// <summary>What reading any file may allocate beside its multiple of the file, bytes.</summary>
    public const long Base = 64 << 10;

    /// <summary>The allocation allowed for every object { … } of the file in addition: a body or an effect is larger than its text.</summary>
    public const long BaseOfObject = 2 << 10;

    /// <summary>The allocation allowed when reading, as a multiple of the file's size.</summary>
    public const double MostTimes = 20;

    private const int MostSteps = 5, MostBodies = 50, MostOfOneKind = 20, Cells = 21;

    /// <summary>Where the input lies while it is read.</summary>
    public string Path { get; } = System.IO.Path.Combine(folder, "input.json");

    /// <summary>All allocation beyond the bases, garbage included, by size of the file.</summary>
    public double Times { get; private set; }

    /// <summary>Reads; an exception if the input is answered by anything but a refusal or a motion.</summary>
    public Outcome Of(Input input)
    {
        input.Write(Path);
        long free = Base + (BaseOfObject * input.Json.LongCount(letter => letter == '{'));
        SceneFile? file = Read(input.Size, out long allocated);
        if (allocated > free + (MostTimes * input.Size))
        {
            // what the program makes once, tables and texts of errors, is not the file's and is there the second time
            file = Read(input.Size, out allocated);
        }

        Times = Math.Max(0, allocated - free) / (double)Math.Max(1, input.Size);
        if (Times > MostTimes)
            throw new FoundException($"takes {allocated} bytes to read {input.Size}");

        return file == null ? Outcome.Refused : Simulate(file);
    }

    /// <summary>What is in the file; null if it is refused.</summary>
    private SceneFile? Read(long size, out long allocated)
    {
        WarmPool(size);
        SceneFile? file = null;
        long before = GC.GetAllocatedBytesForCurrentThread();
        try
        {
            file = SceneReader.ReadWithCrowds(Path);
        }
        catch (InputException refused)
        {
            if (!refused.Message.StartsWith(folder, StringComparison.Ordinal) || HasHidden(refused.Message))
                throw new FoundException("is refused, but not in one line that names the file: " + refused.Message);
        }

        allocated = GC.GetAllocatedBytesForCurrentThread() - before;
        return file;
    }

    /// <summary>A row is a line of 21 cells, sends nothing to a terminal, is no formula, and its name reads back.</summary>
    private void Look(string table, string[] names)
    {
        string[] lines = table.Split('\n');
        if (lines.Length != names.Length + 1)
            throw new FoundException($"has {names.Length} bodies and {lines.Length - 1} rows");

        for (int i = 0; i < names.Length; i++)
        {
            // all other cells are numbers
            int end = lines[i].Length;
            for (int cell = 1; cell < Cells; cell++)
                end = lines[i].LastIndexOf(',', end - 1);

            string first = lines[i][..end], bare = first.StartsWith('"') ? first[1..^1].Replace("\"\"", "\"", StringComparison.Ordinal) : first;
            if (HasHidden(lines[i]) || Csv.Text(bare) != names[i] || ("=+-@".Contains(bare[0]) && !double.TryParse(bare, CultureInfo.InvariantCulture, out _)))
                throw new FoundException("has a row that is not what it seems: " + lines[i]);

            NamesShown += first == names[i] ? 0 : 1;
        }
    }

    private static bool HasHidden(string text) => text.Any(letter => letter is not ('\u200C' or '\u200D')
        && char.GetUnicodeCategory(letter) is UnicodeCategory.Control or UnicodeCategory.Format or UnicodeCategory.LineSeparator or UnicodeCategory.ParagraphSeparator);

    /// <summary>
    /// The JSON library rents its table of tokens, 12 bytes each, and gives it back; whether the pool has one or makes one
    /// depends on what was read before. <see cref="LargeFiles"/> measures with the table.
    /// </summary>
    private static void WarmPool(long size)
    {
        for (long length = 256; length < 64 * size; length *= 2)
            ArrayPool<byte>.Shared.Return(ArrayPool<byte>.Shared.Rent((int)length));
    }

    /// <summary>How many names would have reached a terminal or a spreadsheet as something else than text.</summary>
    public int NamesShown { get; private set; }

    private Outcome Simulate(SceneFile file)
    {
        SceneDescription scene = new(file.Scene.Name, file.Scene.About, file.Scene.Steps, [.. file.Scene.Bodies.Take(MostBodies)]);
        using MemoryStream table = new();
        using TrajectoryCsv csv = new(table);
        try
        {
            Simulation bodies = ManyBodies.Simulate(scene, file.Crowds.ToDictionary(crowd => crowd.Key, crowd => crowd.Value with { Count = Math.Min(MostOfOneKind, crowd.Value.Count) }));
            long steps = Math.Min(MostSteps, scene.Steps.Count);
            for (int i = 0; i < steps; i++)
            {
                bodies.Step(1);
                RunAway.MustBeFinite(bodies, Path);
            }

            csv.WriteRows(bodies);
            csv.Flush();
            Look(Encoding.UTF8.GetString(table.ToArray()), [.. bodies.Bodies.Select(ManyBodies.NameOf)]);
            return Outcome.Ran;
        }
        catch (ArgumentException)
        {
            return Outcome.Refused;
        }
        catch (Exception noticed) when (noticed is FellShortException or BrokenEffectException or StateOverflowException)
        {
            return Outcome.RanAway;
        }
    }
}
