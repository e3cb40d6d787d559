using System.Reflection;
using System.Reflection.Metadata;
using Microsoft.CodeAnalysis;
using RigidBodyDynamics.StudentScripts.Metering;
using UnityEngine;

namespace RigidBodyDynamics.StudentScripts.Compilation;

/// <summary>
/// The references of scripts: the engine, the library, and more of the framework than is allowed, so that a forbidden use can be
/// named.
/// </summary>
internal static class References
{
    private const string Framework = "framework/";

    /// <summary>The references without the meter.</summary>
    public static IReadOnlyList<MetadataReference> OfScripts { get; } =
    [
        .. typeof(References).Assembly.GetManifestResourceNames().Where(name => name.StartsWith(Framework, StringComparison.Ordinal)).Select(OfFramework),
        Of(typeof(Vector3).Assembly),
        Of(typeof(Simulation).Assembly),
    ];

    /// <summary>The references with the meter.</summary>
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
