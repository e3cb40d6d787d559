namespace RigidBodyDynamics.Lab.Grading.Reading;

/// <summary>
/// Limits for reading. A class of 120 whole projects is far below all of them; an archive made to exhaust the memory exceeds one
/// of them early.
/// </summary>
internal static class Limits
{
    /// <summary>Nesting of archives; a package in the innermost one is still read.</summary>
    public const int Depth = 3;

    /// <summary>Entries of one archive, or files of one folder with its subfolders.</summary>
    public const int Entries = 20_000;

    /// <summary>A script, bytes.</summary>
    public const int Script = 1 << 20;

    /// <summary>Scripts of one submission.</summary>
    public const int Scripts = 300;

    /// <summary>A path inside a package, bytes.</summary>
    public const int PathName = 1 << 12;

    /// <summary>An archive that is read into memory, bytes.</summary>
    public const int Archive = 1 << 28;

    /// <summary>The unpacked size of one package, bytes; scenes and pictures are skipped and not kept.</summary>
    public const long Unpacked = 1L << 30;

    /// <summary>The sum of all archives inside one submitted archive, bytes.</summary>
    public const long Nested = 1L << 31;
}
