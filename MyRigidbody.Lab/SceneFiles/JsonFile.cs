using System.Text.Json;
using System.Text.Unicode;

namespace RigidBodyDynamics.Lab;

/// <summary>Reads a JSON file; whatever is wrong with it becomes one line.</summary>
internal static class JsonFile
{
    private const long LargestFile = 1L << 28;

    private static readonly JsonDocumentOptions Options = new()
    {
        AllowTrailingCommas = true,
        CommentHandling = JsonCommentHandling.Skip,
        AllowDuplicateProperties = false,
    };

    /// <summary>The root of the file.</summary>
    public static T Read<T>(string path, Func<Place, T> read)
    {
        byte[] bytes = Bytes(path);
        int start = bytes.AsSpan().StartsWith("\uFEFF"u8) ? 3 : 0;
        if (!Utf8.IsValid(bytes.AsSpan(start)))
        {
            throw new InputException($"{path}: is not text in UTF-8");
        }

        try
        {
            using JsonDocument document = JsonDocument.Parse(bytes.AsMemory(start), Options);
            return read(new Place(path, string.Empty, document.RootElement));
        }
        catch (JsonException broken)
        {
            string line = broken.LineNumber == null ? string.Empty : $"line {broken.LineNumber + 1}, column {broken.BytePositionInLine + 1}: ";
            string what = broken.Message.Split(" LineNumber:")[0].Split(" Path:")[0].ReplaceLineEndings(" ");
            throw new InputException($"{path}: {line}{what}");
        }
        catch (InvalidOperationException)
        {
            // half a surrogate pair, escaped: the one text that passes as JSON and is none
            throw new InputException($"{path}: has a name or text that is not valid Unicode");
        }
    }

    private static byte[] Bytes(string path)
    {
        try
        {
            if (Directory.Exists(path))
            {
                throw new InputException($"{path}: is a folder, not a file");
            }

            FileInfo file = new(path);
            return file.Exists && file.Length > LargestFile
                ? throw new InputException($"{path}: is larger than {LargestFile >> 20} MB")
                : File.ReadAllBytes(path);
        }
        catch (Exception missing) when (missing is FileNotFoundException or DirectoryNotFoundException)
        {
            throw new InputException($"{path}: there is no such file");
        }
        catch (Exception problem) when (problem is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw new InputException($"{path}: cannot be read: {problem.Message.ReplaceLineEndings(" ")}");
        }
    }
}
