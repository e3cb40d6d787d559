using System.Reflection;
using System.Reflection.Metadata;
using System.Runtime.InteropServices.JavaScript;
using System.Runtime.Versioning;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;

[assembly: SupportedOSPlatform("browser")]

namespace RigidBodyDynamics.Web.Write;

/// <summary>What the worker of the page asks of the compiler.</summary>
internal static partial class Scripts
{
    private static readonly Lazy<MetadataReference[]> References = new(() =>
        [.. new[] { typeof(object).Assembly, Assembly.Load("System.Runtime"), typeof(UnityEngine.Vector3).Assembly }.Select(Reference)]);

    private static void Main()
    {
    }

    /// <summary>The compiler's errors in a script, one a line.</summary>
    [JSExport]
    internal static string Errors(string text)
    {
        CSharpCompilation compilation = CSharpCompilation.Create(
            "Script", [CSharpSyntaxTree.ParseText(text)], References.Value, new(OutputKind.DynamicallyLinkedLibrary, concurrentBuild: false));
        return string.Join('\n', compilation.GetDiagnostics().Where(found => found.Severity == DiagnosticSeverity.Error));
    }

    private static unsafe MetadataReference Reference(Assembly assembly) => assembly.TryGetRawMetadata(out byte* start, out int length)
        ? AssemblyMetadata.Create(ModuleMetadata.CreateFromMetadata((nint)start, length)).GetReference()
        : throw new InvalidOperationException($"no metadata of {assembly}");
}
