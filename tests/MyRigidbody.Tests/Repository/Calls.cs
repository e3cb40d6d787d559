using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace RigidBodyDynamics.Tests.Repository;

/// <summary>Which member calls which, by their types' names and their own (<c>Mover.Advance</c>, <c>Mover.new</c>), as the compilers of the projects understand the code.</summary>
internal sealed class Calls
{
    private readonly Dictionary<string, HashSet<string>> _called = [], _made = [];
    private readonly HashSet<string> _callDelegates = [], _handedOver = [];

    /// <summary>The calls of some members, in some projects.</summary>
    public Calls(IEnumerable<string> members, params string[] projects)
    {
        // to bind all files of the projects takes ten seconds
        HashSet<string> types = [.. members.Select(member => member.Split('.')[0])];
        foreach (CSharpCompilation compilation in projects.Select(Arrows.Compiled))
        {
            foreach (SyntaxTree tree in compilation.SyntaxTrees.Where(tree => tree.GetRoot().DescendantNodes().OfType<TypeDeclarationSyntax>().Any(type => types.Contains(type.Identifier.Text))))
                Read(tree.GetRoot(), compilation.GetSemanticModel(tree));
        }
    }

    /// <summary>True if a member calls another: itself, or what it overrides or implements.</summary>
    public bool AreDirect(string from, string to) =>
        _called.GetValueOrDefault(from, []).Any(called => called == to || _made.GetValueOrDefault(called, []).Contains(to));

    /// <summary>True if a member calls a delegate, and another one is passed as a delegate.</summary>
    public bool MayBeThroughDelegate(string from, string to) => _callDelegates.Contains(from) && _handedOver.Contains(to);

    private void Read(SyntaxNode root, SemanticModel model)
    {
        foreach (SyntaxNode node in root.DescendantNodes())
        {
            if (node is MemberDeclarationSyntax && model.GetDeclaredSymbol(node) is { } declared and not INamedTypeSymbol)
            {
                foreach (ISymbol above in Above(declared))
                    Add(_made, Name(above), Name(declared));
            }
            else if (node is SimpleNameSyntax or BaseObjectCreationExpressionSyntax or ConstructorInitializerSyntax
                && model.GetSymbolInfo(node).Symbol is { } symbol and (IMethodSymbol or IPropertySymbol) && IsOurs(symbol))
            {
                string member = Name(Outermost(model.GetEnclosingSymbol(node.SpanStart)!)), called = Name(symbol);
                if (symbol is IMethodSymbol { MethodKind: not MethodKind.Constructor } && !IsInvoked(node))
                    _handedOver.Add(called);
                else
                    Add(_called, member, called);
            }
            else if (node is InvocationExpressionSyntax && model.GetSymbolInfo(node).Symbol is IMethodSymbol { MethodKind: MethodKind.DelegateInvoke })
            {
                _callDelegates.Add(Name(Outermost(model.GetEnclosingSymbol(node.SpanStart)!)));
            }
        }
    }

    private static bool IsOurs(ISymbol symbol) => symbol.Locations.Any(place => place.IsInSource) || symbol.ContainingAssembly?.Name.StartsWith("MyRigidbody", StringComparison.Ordinal) == true;

    private static bool IsInvoked(SyntaxNode name)
    {
        SyntaxNode whole = name.Parent is MemberAccessExpressionSyntax access && access.Name == name ? access : name.Parent is MemberBindingExpressionSyntax ? name.Parent : name;
        return whole.Parent is InvocationExpressionSyntax call && call.Expression == whole;
    }

    private static IEnumerable<ISymbol> Above(ISymbol member)
    {
        for (ISymbol? over = Overridden(member); over != null; over = Overridden(over))
            yield return over;

        foreach (ISymbol promised in member.ContainingType?.AllInterfaces.SelectMany(type => type.GetMembers()) ?? [])
        {
            if (SymbolEqualityComparer.Default.Equals(member.ContainingType!.FindImplementationForInterfaceMember(promised), member))
                yield return promised;
        }
    }

    private static ISymbol? Overridden(ISymbol member) => member switch
    {
        IMethodSymbol method => method.OverriddenMethod,
        IPropertySymbol property => property.OverriddenProperty,
        _ => null,
    };

    // code in a lambda or a local function belongs to the member around it
    private static ISymbol Outermost(ISymbol symbol)
    {
        while (symbol is IMethodSymbol { MethodKind: MethodKind.AnonymousFunction or MethodKind.LocalFunction })
            symbol = symbol.ContainingSymbol;

        return symbol;
    }

    private static string Name(ISymbol symbol)
    {
        ISymbol of = (symbol as IMethodSymbol)?.AssociatedSymbol ?? (symbol as IMethodSymbol)?.ReducedFrom ?? symbol;
        return of is IMethodSymbol { MethodKind: MethodKind.Constructor } ? of.ContainingType.Name + ".new" : $"{of.ContainingType?.Name}.{of.Name}";
    }

    private static void Add(Dictionary<string, HashSet<string>> to, string key, string value)
    {
        if (!to.TryGetValue(key, out HashSet<string>? all))
            to[key] = all = [];

        all.Add(value);
    }
}
