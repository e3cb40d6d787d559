using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Unicode;
using RigidBodyDynamics.StudentScripts;

namespace RigidBodyDynamics.Web.Write;

/// <summary>Conversion of data between worker.js and this program.</summary>
internal static class Json
{
    private static readonly JsonSerializerOptions Options = new() { Encoder = JavaScriptEncoder.Create(UnicodeRanges.All) };

    /// <summary>A value for JSON.parse.</summary>
    public static string Of<T>(T value) => JsonSerializer.Serialize(value, Options);

    /// <summary>Files from their names, their lengths, and their bytes one after another.</summary>
    public static IReadOnlyList<ScriptFile> Files(string[] names, int[] lengths, byte[] bytes)
    {
        ScriptFile[] files = new ScriptFile[names.Length];
        for (int i = 0, at = 0; i < files.Length; at += lengths[i++])
            files[i] = new ScriptFile(names[i], bytes[at..(at + lengths[i])]);

        return files;
    }
}
