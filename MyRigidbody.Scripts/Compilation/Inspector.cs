using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using RigidBodyDynamics.Judging;

namespace RigidBodyDynamics.StudentScripts.Compilation;

/// <summary>Inspects every name, expression and type of a script by its meaning, not its spelling.</summary>
internal sealed class Inspector(SemanticModel model)
{
    private static readonly SyntaxKind[] NeverAllowed =
    [
        SyntaxKind.DestructorDeclaration, SyntaxKind.UnsafeStatement, SyntaxKind.FixedStatement, SyntaxKind.PointerType, SyntaxKind.FunctionPointerType,
        SyntaxKind.MakeRefExpression, SyntaxKind.RefTypeExpression, SyntaxKind.RefValueExpression, SyntaxKind.ArgListExpression,
        SyntaxKind.StackAllocArrayCreationExpression, SyntaxKind.ImplicitStackAllocArrayCreationExpression, SyntaxKind.ExternAliasDirective,
    ];

    private readonly Dictionary<string, Objection> _objections = [];

    /// <summary>What is not allowed and what does the work in place of the script, the first place of each.</summary>
    public static IReadOnlyList<Objection> Look(Microsoft.CodeAnalysis.Compilation compilation, SyntaxTree tree)
    {
        Inspector inspector = new(compilation.GetSemanticModel(tree));
        foreach (SyntaxNode node in tree.GetRoot().DescendantNodes(node => node is not UsingDirectiveSyntax))
            inspector.Look(node);

        return [.. inspector._objections.Values];
    }

    private void Look(SyntaxNode node)
    {
        if (NeverAllowed.Contains(node.Kind()))
            Add(node, Words.Forbidden(node.IsKind(SyntaxKind.DestructorDeclaration) ? "finalizer" : "unsafe", node.ToString().Split('\n')[0].Trim()));
        if (node is MemberDeclarationSyntax member && member.Modifiers.Any(SyntaxKind.ExternKeyword))
            Add(node, Words.Forbidden("native", "extern"));
        if (node is not (ExpressionSyntax or AttributeSyntax or ConstructorInitializerSyntax or PrimaryConstructorBaseTypeSyntax))
            return;

        SymbolInfo info = model.GetSymbolInfo(node);
        if (info.Symbol is { } symbol)
            Look(node, symbol);
        foreach (ISymbol candidate in info.CandidateSymbols)
            Look(node, candidate);

        TypeInfo type = model.GetTypeInfo(node);
        foreach (ITypeSymbol known in new[] { type.Type, type.ConvertedType }.OfType<ITypeSymbol>())
        {
            if (known.TypeKind == TypeKind.Dynamic)
                Add(node, Words.Forbidden("dynamic", "dynamic"));
            else if (known is not IErrorTypeSymbol && !AllowList.Usual.Allows(known))
                Look(node, known);
        }
    }

    private void Look(SyntaxNode node, ISymbol symbol)
    {
        if (symbol is IDynamicTypeSymbol)
            Add(node, Words.Forbidden("dynamic", "dynamic"));
        else if (Helpers.Finding(symbol, node) is { } cheat)
            Add(node, cheat);
        else if (!AllowList.Usual.Allows(symbol))
            Add(node, Words.Forbidden(Reaches.For(symbol), Reaches.Name(symbol)));
    }

    private void Add(SyntaxNode node, Finding finding) =>
        _objections.TryAdd(finding.Code, Objection.At(node.GetLocation(), finding));
}
