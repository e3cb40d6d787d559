using Microsoft.CodeAnalysis;

namespace RigidBodyDynamics.StudentScripts.Compilation;

/// <summary>What a script uses that is not allowed, in one word.</summary>
internal static class Reaches
{
    // the first entry that begins the full name applies
    private static readonly (string Begins, string Word)[] Known =
    [
        ("System.IO", "file"),
        ("System.Diagnostics.Process", "process"),
        ("System.Environment", "process"),
        ("System.AppDomain", "process"),
        ("System.Net", "network"),
        ("System.Threading", "thread"),
        ("System.Reflection", "reflection"),
        ("System.Type.", "reflection"),
        ("System.Activator", "reflection"),
        ("System.Object.GetType", "reflection"),
        ("System.Exception.", "reflection"),
        ("System.Delegate", "reflection"),
        ("System.Linq.Expressions", "reflection"),
        ("System.Runtime", "native"),
        ("System.GC", "process"),
        ("UnityEngine.Application", "process"),
    ];

    private static readonly SymbolDisplayFormat Full =
        SymbolDisplayFormat.FullyQualifiedFormat.WithGlobalNamespaceStyle(SymbolDisplayGlobalNamespaceStyle.Omitted).WithMiscellaneousOptions(SymbolDisplayMiscellaneousOptions.None);

    public static string For(ISymbol symbol)
    {
        string name = Name(symbol);
        return Known.FirstOrDefault(known => name.StartsWith(known.Begins, StringComparison.Ordinal)).Word ?? "not-allowed";
    }

    /// <summary>Its full name, without parameters.</summary>
    public static string Name(ISymbol symbol) => symbol is INamespaceOrTypeSymbol || symbol.ContainingType == null
        ? symbol.ToDisplayString(Full)
        : symbol.ContainingType.ToDisplayString(Full) + (symbol.Name == ".ctor" ? string.Empty : "." + symbol.Name);
}
