using System.Reflection;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests.Repository;

/// <summary>A program of one's own: it sees nothing of the library but what is public.</summary>
internal static class Outside
{
    /// <summary>Compiles sources, without a warning, as Unity 2019.4 would.</summary>
    public static Assembly Library(params string[] sources) => Compile(OutputKind.DynamicallyLinkedLibrary, LanguageVersion.CSharp7_3, sources);

    /// <summary>Compiles sources, without a warning, the first of which may begin with statements.</summary>
    public static Assembly Program(params string[] sources) => Compile(OutputKind.ConsoleApplication, LanguageVersion.Latest, sources);

    private static Assembly Compile(OutputKind kind, LanguageVersion version, string[] sources)
    {
        CSharpCompilation compilation = CSharpCompilation.Create(
            "Outside" + Guid.NewGuid().ToString("N"),
            sources.Select(source => CSharpSyntaxTree.ParseText(source, new CSharpParseOptions(version))),
            ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!).Split(Path.PathSeparator).Append(typeof(Simulation).Assembly.Location).Distinct()
                .Select(path => MetadataReference.CreateFromFile(path)),
            new CSharpCompilationOptions(kind));
        using MemoryStream image = new();
        Assert.That(compilation.Emit(image).Diagnostics.Where(found => found.Severity >= DiagnosticSeverity.Warning), Is.Empty);
        return Assembly.Load(image.ToArray());
    }
}
