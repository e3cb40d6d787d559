namespace RigidBodyDynamics.Lab.Grading.Reading;

/// <summary>
/// How much of a file is read. A class of 120 whole projects is far below all of these; an archive made to fill the memory is
/// told by the first one it reaches.
/// </summary>
internal static class Limits
{
    /// <summary>Archives in archives; a package in the innermost one is still read.</summary>
    public const int Depth = 3;

    /// <summary>Entries of one archive, files of one folder with all below it.</summary>
    public const int Entries = 20_000;

    /// <summary>A script, bytes.</summary>
    public const int Script = 1 << 20;

    /// <summary>Scripts of one submission.</summary>
    public const int Scripts = 300;

    /// <summary>A path inside a package, bytes.</summary>
    public const int PathName = 1 << 12;

    /// <summary>An archive that is read into memory, bytes.</summary>
    public const int Archive = 1 << 28;

    /// <summary>What one package unpacks to, bytes; scenes and pictures pass by and are not kept.</summary>
    public const long Unpacked = 1L << 30;

    /// <summary>All archives inside one that was handed in, bytes.</summary>
    public const long Nested = 1L << 31;
}
