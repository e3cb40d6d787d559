using System.Text.Json;
using System.Text.Unicode;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab;

/// <summary>Reads a JSON file; any error in it is one line.</summary>
internal static class JsonFile
{
    private static readonly JsonDocumentOptions Options = new()
    {
        AllowTrailingCommas = true,
        CommentHandling = JsonCommentHandling.Skip,
        AllowDuplicateProperties = false,
    };

    /// <summary>The root of the file.</summary>
    public static T Read<T>(string path, Func<Place, T> read)
    {
        ArraySegment<byte> bytes = InputFile.Bytes(path), text = bytes.AsSpan().StartsWith("\uFEFF"u8) ? bytes[3..] : bytes;
        if (!Utf8.IsValid(text))
            throw new InputException($"{path}: is not text in UTF-8");

        try
        {
            using JsonDocument document = JsonDocument.Parse(text.AsMemory(), Options);
            return read(new Place(path, null, string.Empty, document.RootElement));
        }
        catch (JsonException broken)
        {
            string line = broken.LineNumber == null ? string.Empty : $"line {broken.LineNumber + 1}, column {broken.BytePositionInLine + 1}: ";
            string what = broken.Message.Split(" LineNumber:")[0].Split(" Path:")[0].ReplaceLineEndings(" ");
            throw new InputException($"{path}: {line}{what}");
        }
        catch (InvalidOperationException)
        {
            // half a surrogate pair, escaped: the one text that is valid JSON and not valid Unicode
            throw new InputException($"{path}: has a name or text that is not valid Unicode");
        }
    }
}
