namespace RigidBodyDynamics.Lab.Grading.Reading;

/// <summary>The kind of a file by its first bytes, independent of its name.</summary>
internal enum FileKind
{
    /// <summary>None of the following: a text, if the name says so.</summary>
    Other,

    /// <summary>gzip, as a Unity package is.</summary>
    Gzip,

    /// <summary>tar without gzip.</summary>
    Tar,

    /// <summary>zip.</summary>
    Zip,

    /// <summary>rar, which is not read.</summary>
    Rar,

    /// <summary>7z, which is not read.</summary>
    SevenZip,
}

/// <summary>Which files are read, and how.</summary>
internal static class FileKinds
{
    private const int TarMagic = 257, TarBlock = 512;

    private static readonly string[] Archives = [".unitypackage", ".zip", ".rar", ".7z", ".tar", ".gz", ".tgz"];

    /// <summary>True for a file that may hold a script: by its extension, or because it has none.</summary>
    public static bool MayHoldScripts(string name) =>
        !name.StartsWith("._", StringComparison.Ordinal) && (IsScript(name) || IsArchive(name) || !name.Contains('.', StringComparison.Ordinal));

    /// <summary>True for the extension of C#.</summary>
    public static bool IsScript(string name) => name.EndsWith(".cs", StringComparison.OrdinalIgnoreCase);

    /// <summary>True for the extension of an archive, including names to which a browser has added something.</summary>
    public static bool IsArchive(string name) =>
        Archives.Any(ending => name.EndsWith(ending, StringComparison.OrdinalIgnoreCase)) || name.Contains(".unitypackage", StringComparison.OrdinalIgnoreCase);

    public static FileKind Of(ReadOnlySpan<byte> bytes)
    {
        if (bytes.StartsWith("PK\x03\x04"u8) || bytes.StartsWith("PK\x05\x06"u8))
            return FileKind.Zip;

        if (bytes.StartsWith("\u001f"u8) && bytes.Length > 1 && bytes[1] == 0x8b)
            return FileKind.Gzip;

        if (bytes.StartsWith("Rar!"u8))
            return FileKind.Rar;

        if (bytes.StartsWith("7z"u8) && bytes.Length > 5 && bytes[2..6].SequenceEqual((ReadOnlySpan<byte>)[0xbc, 0xaf, 0x27, 0x1c]))
            return FileKind.SevenZip;

        return bytes.Length >= TarBlock && bytes[TarMagic..].StartsWith("ustar"u8) ? FileKind.Tar : FileKind.Other;
    }

    /// <summary>The extension for a kind of file.</summary>
    public static string Ending(FileKind kind) => kind switch
    {
        FileKind.Zip => ".zip",
        FileKind.Gzip or FileKind.Tar => ".unitypackage",
        FileKind.Rar => ".rar",
        FileKind.SevenZip => ".7z",
        _ => ".cs",
    };
}
