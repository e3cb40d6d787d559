using Microsoft.CodeAnalysis;
using RigidBodyDynamics.StudentScripts.Metering;
using UnityEngine;

namespace RigidBodyDynamics.StudentScripts.Compilation;

/// <summary>
/// What scripts are compiled against: the engine, the library, and of the framework more than is allowed, so that what a script
/// reaches for can be called by its name.
/// </summary>
internal static class References
{
    private static readonly string[] Framework =
    [
        "System.Private.CoreLib", "System.Runtime", "System.Runtime.Extensions", "System.Runtime.InteropServices", "System.Collections",
        "System.Collections.Concurrent", "System.Linq", "System.Linq.Expressions", "System.Console", "System.Diagnostics.Process",
        "System.ComponentModel.Primitives", "System.Private.Uri", "System.Net.Http", "System.Net.Primitives", "System.Net.Sockets", "System.Net.WebClient",
        "System.Threading", "System.Threading.Thread", "System.Threading.Tasks.Parallel", "System.Text.RegularExpressions", "System.IO.FileSystem",
        "System.Reflection.Emit", "System.Runtime.Numerics", "System.Numerics.Vectors", "System.ObjectModel", "Microsoft.CSharp", "netstandard",
    ];

    /// <summary>What the script may see.</summary>
    public static IReadOnlyList<MetadataReference> OfScripts { get; } =
    [
        .. ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!).Split(Path.PathSeparator)
            .Where(path => Framework.Contains(Path.GetFileNameWithoutExtension(path)))
            .Select(path => MetadataReference.CreateFromFile(path)),
        MetadataReference.CreateFromFile(typeof(Vector3).Assembly.Location),
        MetadataReference.CreateFromFile(typeof(Simulation).Assembly.Location),
    ];

    /// <summary>The meter as well.</summary>
    public static IReadOnlyList<MetadataReference> OfMeteredScripts { get; } =
        [.. OfScripts, MetadataReference.CreateFromFile(typeof(Meter).Assembly.Location)];
}
