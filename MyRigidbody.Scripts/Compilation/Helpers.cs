using Microsoft.CodeAnalysis;
using RigidBodyDynamics.Judging;

namespace RigidBodyDynamics.StudentScripts.Compilation;

/// <summary>Objects that do the work in place of the script: the engine's body, the library, another object.</summary>
internal static class Helpers
{
    private static readonly string[] Searches =
        ["Find", "FindWithTag", "FindGameObjectWithTag", "FindObjectOfType", "FindObjectsOfType", "FindFirstObjectByType", "FindAnyObjectByType"];

    /// <summary>The finding about it; null where it does no work for the script.</summary>
    public static Finding? Finding(ISymbol symbol, SyntaxNode node)
    {
        INamedTypeSymbol? owner = symbol as INamedTypeSymbol ?? symbol.ContainingType;
        string type = owner?.ToDisplayString() ?? string.Empty, space = symbol.ContainingNamespace?.ToDisplayString() ?? string.Empty;
        // reading the body alone, or its mass, moves nothing: where there is none it throws
        if (type is "UnityEngine.Rigidbody" && symbol is not INamedTypeSymbol && symbol.Name is not "mass")
            return Words.Cheat("uses-rigidbody", "Rigidbody." + symbol.Name);
        if (symbol is IMethodSymbol { Name: "AddComponent" } added && added.TypeArguments.Any(argument => argument.ToDisplayString() == "UnityEngine.Rigidbody"))
            return Words.Cheat("uses-rigidbody", "AddComponent<Rigidbody>");
        if (type is "UnityEngine.Physics" or "UnityEngine.SimulationMode")
            return Words.Cheat("uses-rigidbody", type);
        if (space == "RigidBodyDynamics" || space.StartsWith("RigidBodyDynamics.", StringComparison.Ordinal))
            return Words.Cheat("uses-library", symbol is INamespaceSymbol ? space : Reaches.Name(symbol));
        if (owner is { Name: "DefaultRigidbody" } && node.SyntaxTree.FilePath != ScriptCompiler.Given)
            return Words.Cheat("uses-default-rigidbody", "DefaultRigidbody");
        if (type is "UnityEngine.GameObject" or "UnityEngine.Object" && Searches.Contains(symbol.Name))
            return Words.Cheat("uses-another-object", symbol.Name);
        if (type is "UnityEngine.MonoBehaviour" && symbol.Name is "StartCoroutine" or "Invoke" or "InvokeRepeating")
            return Words.Coroutine(symbol.Name);

        return null;
    }
}
