using System.Reflection;
using System.Reflection.Metadata;
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
    private const string Framework = "framework/";

    /// <summary>What the script may see.</summary>
    public static IReadOnlyList<MetadataReference> OfScripts { get; } =
    [
        .. typeof(References).Assembly.GetManifestResourceNames().Where(name => name.StartsWith(Framework, StringComparison.Ordinal)).Select(OfFramework),
        Of(typeof(Vector3).Assembly),
        Of(typeof(Simulation).Assembly),
    ];

    /// <summary>The meter as well.</summary>
    public static IReadOnlyList<MetadataReference> OfMeteredScripts { get; } = [.. OfScripts, Of(typeof(Meter).Assembly)];

    private static PortableExecutableReference OfFramework(string resource)
    {
        using Stream assembly = typeof(References).Assembly.GetManifestResourceStream(resource)!;
        return MetadataReference.CreateFromStream(assembly, filePath: resource[Framework.Length..]);
    }

    // from memory: in a browser it has no file
    private static unsafe PortableExecutableReference Of(Assembly assembly)
    {
        if (!assembly.TryGetRawMetadata(out byte* metadata, out int length))
            throw new InvalidOperationException($"{assembly.GetName().Name} has no metadata in memory");

        return AssemblyMetadata.Create(ModuleMetadata.CreateFromMetadata((IntPtr)metadata, length)).GetReference(filePath: assembly.GetName().Name);
    }
}
