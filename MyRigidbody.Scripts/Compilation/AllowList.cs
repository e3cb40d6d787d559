using System.Reflection;
using Microsoft.CodeAnalysis;

namespace RigidBodyDynamics.StudentScripts.Compilation;

/// <summary>What a script may use. Anything else is not allowed, by whatever name it is reached.</summary>
internal sealed class AllowList
{
    private readonly HashSet<string> _namespaces = [], _types = [], _members = [];

    private AllowList(IEnumerable<string> lines)
    {
        foreach (string line in lines.Where(line => line.Length > 0 && line[0] != '#'))
            (line[0] == 'N' ? _namespaces : line[0] == 'T' ? _types : _members).Add(line[2..].Trim());
    }

    public static AllowList Usual { get; } = new(Lines());

    /// <summary>True if a script may use it: a type, or a member of a type.</summary>
    public bool Allows(ISymbol symbol) => symbol switch
    {
        INamespaceSymbol or ILocalSymbol or IParameterSymbol or IRangeVariableSymbol or ILabelSymbol or IDiscardSymbol or ITypeParameterSymbol or IPreprocessingSymbol => true,
        IAliasSymbol alias => Allows(alias.Target),
        ITypeSymbol type => AllowsType(type),
        IMethodSymbol { MethodKind: MethodKind.LocalFunction or MethodKind.AnonymousFunction or MethodKind.BuiltinOperator } => true,
        _ => symbol.ContainingType is not { } owner || AllowsMember(owner, symbol.Name == ".ctor" ? owner.Name : symbol is IMethodSymbol { AssociatedSymbol: { } of } ? of.Name : symbol.Name),
    };

    private bool AllowsType(ITypeSymbol type) => type switch
    {
        IArrayTypeSymbol array => AllowsType(array.ElementType),
        ITypeParameterSymbol or IErrorTypeSymbol => true,
        INamedTypeSymbol named => (IsOwn(named) || AllowsWhole(named) || _members.Contains(Name(named))) && named.TypeArguments.All(AllowsType),
        _ => false, // dynamic, pointers
    };

    private bool AllowsMember(INamedTypeSymbol owner, string member) =>
        IsOwn(owner) || owner.IsTupleType || owner.IsAnonymousType || AllowsWhole(owner) || _members.Contains(Name(owner) + "." + member);

    private bool AllowsWhole(INamedTypeSymbol type) =>
        type.IsAnonymousType || _types.Contains(Name(type)) || _namespaces.Contains(type.ContainingNamespace?.ToDisplayString() ?? string.Empty);

    // declared by the script itself
    private static bool IsOwn(INamedTypeSymbol type) => !type.Locations.IsEmpty && type.Locations.All(location => location.IsInSource);

    private static string Name(INamedTypeSymbol type) => type.ContainingType != null
        ? Name(type.ContainingType) + "." + type.Name
        : type.ContainingNamespace is { IsGlobalNamespace: false } space ? space.ToDisplayString() + "." + type.Name : type.Name;

    private static IEnumerable<string> Lines()
    {
        using StreamReader reader = new(Assembly.GetExecutingAssembly().GetManifestResourceStream("allowed.txt")!);
        while (reader.ReadLine() is { } line)
            yield return line;
    }
}
