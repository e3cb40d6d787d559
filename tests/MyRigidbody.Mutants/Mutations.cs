using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using Microsoft.CodeAnalysis.Text;

namespace RigidBodyDynamics.Mutants;

/// <summary>
/// Finds the places of a file where something can be wrong: signs, terms, factors, comparisons, conditions, components,
/// numbers, statements. What only makes text (messages, ToString) or only spreads hash codes is left alone.
/// </summary>
internal sealed class Mutations : CSharpSyntaxWalker
{
    private readonly SemanticModel _meaning;
    private readonly SourceText _text;
    private readonly List<Mutant> _found = [];

    private Mutations(SemanticModel meaning)
    {
        _meaning = meaning;
        _text = meaning.SyntaxTree.GetText();
    }

    /// <summary>All mutants of a file, in the order of the text, none twice.</summary>
    public static IReadOnlyList<Mutant> Of(SemanticModel meaning)
    {
        Mutations walker = new(meaning);
        walker.Visit(meaning.SyntaxTree.GetRoot());
        return [.. walker._found.Distinct().OrderBy(mutant => mutant.Span.Start).ThenBy(mutant => mutant.Span.End)];
    }

    public override void VisitAttributeList(AttributeListSyntax node) { }

    public override void VisitThrowStatement(ThrowStatementSyntax node) { }

    public override void VisitThrowExpression(ThrowExpressionSyntax node) { }

    public override void VisitMethodDeclaration(MethodDeclarationSyntax node)
    {
        if (node.Identifier.Text is not ("ToString" or "GetHashCode"))
            base.VisitMethodDeclaration(node);
    }

    public override void VisitInvocationExpression(InvocationExpressionSyntax node)
    {
        string called = node.Expression.ToString();
        if (called is "nameof" or "Guard.Refused")
            return;

        if (called.EndsWith("Math.Abs", StringComparison.Ordinal))
            Add(node, Bracketed(node.ArgumentList.Arguments[0].Expression));
        else if (node.Expression is MemberAccessExpressionSyntax { Name: SimpleNameSyntax name } && Swaps.Function(name.Identifier.Text) is string other)
            Add(name, other);
        base.VisitInvocationExpression(node);
    }

    public override void VisitBinaryExpression(BinaryExpressionSyntax node)
    {
        base.VisitBinaryExpression(node);
        if (_meaning.GetTypeInfo(node).Type?.SpecialType == SpecialType.System_String)
            return;

        foreach (string other in Swaps.Operator(node.OperatorToken.Text))
            Add(node.OperatorToken.Span, other);
        // in a + b + c each term is dropped once
        bool leads = !Swaps.AreAlike(node.Left.Kind(), node.Kind());
        switch (node.OperatorToken.Text)
        {
            case "+" or "*":
                Add(node, Bracketed(node.Left));
                if (leads)
                    Add(node, Bracketed(node.Right));
                break;
            case "-":
                Add(node, Bracketed(node.Left));
                if (leads)
                    Add(node, "(-" + Bracketed(node.Right) + ")");
                break;
            case "/":
                Add(node, Bracketed(node.Left));
                break;
            default:
                break;
        }
    }

    public override void VisitPrefixUnaryExpression(PrefixUnaryExpressionSyntax node)
    {
        base.VisitPrefixUnaryExpression(node);
        switch (node.OperatorToken.Text)
        {
            case "-" or "!":
                Add(node, Bracketed(node.Operand));
                break;
            case "++" or "--":
                Add(node.OperatorToken.Span, node.OperatorToken.Text == "++" ? "--" : "++");
                break;
            default:
                break;
        }
    }

    public override void VisitPostfixUnaryExpression(PostfixUnaryExpressionSyntax node)
    {
        base.VisitPostfixUnaryExpression(node);
        Add(node.OperatorToken.Span, node.OperatorToken.Text == "++" ? "--" : "++");
    }

    public override void VisitAssignmentExpression(AssignmentExpressionSyntax node)
    {
        base.VisitAssignmentExpression(node);
        foreach (string other in Swaps.Assignment(node.OperatorToken.Text))
            Add(node.OperatorToken.Span, other);
        if (node.OperatorToken.Text == "=")
            AddSign(node.Right);
    }

    public override void VisitExpressionStatement(ExpressionStatementSyntax node)
    {
        base.VisitExpressionStatement(node);
        Add(node, ";");
    }

    public override void VisitReturnStatement(ReturnStatementSyntax node)
    {
        base.VisitReturnStatement(node);
        if (node.Expression == null)
            Add(node, ";");
        else
            AddSign(node.Expression);
    }

    public override void VisitEqualsValueClause(EqualsValueClauseSyntax node)
    {
        base.VisitEqualsValueClause(node);
        AddSign(node.Value);
    }

    public override void VisitArrowExpressionClause(ArrowExpressionClauseSyntax node)
    {
        base.VisitArrowExpressionClause(node);
        AddSign(node.Expression);
    }

    public override void VisitArgument(ArgumentSyntax node)
    {
        base.VisitArgument(node);
        if (node.Parent?.Parent is ObjectCreationExpressionSyntax)
            AddSign(node.Expression);
    }

    public override void VisitIfStatement(IfStatementSyntax node)
    {
        AddNegation(node.Condition);
        base.VisitIfStatement(node);
    }

    public override void VisitWhileStatement(WhileStatementSyntax node)
    {
        AddNegation(node.Condition);
        base.VisitWhileStatement(node);
    }

    public override void VisitConditionalExpression(ConditionalExpressionSyntax node)
    {
        AddNegation(node.Condition);
        base.VisitConditionalExpression(node);
    }

    public override void VisitLiteralExpression(LiteralExpressionSyntax node)
    {
        if (node.Kind() is SyntaxKind.TrueLiteralExpression or SyntaxKind.FalseLiteralExpression)
            Add(node, node.Kind() == SyntaxKind.TrueLiteralExpression ? "false" : "true");
        else if (node.Kind() == SyntaxKind.NumericLiteralExpression)
            Add(node, Swaps.Number(node.Token));
    }

    public override void VisitIdentifierName(IdentifierNameSyntax node)
    {
        if (_meaning.GetSymbolInfo(node).Symbol is (IFieldSymbol or IPropertySymbol) and ISymbol { ContainingType: INamedTypeSymbol type })
        {
            foreach (string other in Swaps.Component(node.Identifier.Text).Where(name => !type.GetMembers(name).IsEmpty).Take(1))
                Add(node, other);
        }
    }

    private static string Bracketed(SyntaxNode node) =>
        node is IdentifierNameSyntax or LiteralExpressionSyntax or ParenthesizedExpressionSyntax or MemberAccessExpressionSyntax or InvocationExpressionSyntax
            ? node.ToString()
            : "(" + node + ")";

    // a comparison has mutants enough of its own
    private void AddNegation(ExpressionSyntax condition)
    {
        if (Swaps.Operator((condition as BinaryExpressionSyntax)?.OperatorToken.Text ?? "").Length < 1 || condition.Kind() is SyntaxKind.LogicalAndExpression or SyntaxKind.LogicalOrExpression)
            Add(condition, "!(" + condition + ")");
    }

    private void AddSign(ExpressionSyntax value)
    {
        // a sum or a product has signs enough of its own, and zero has none
        bool isZero = value is LiteralExpressionSyntax { Token.Value: 0 or 0.0 } || value.ToString() == "Vector3d.Zero";
        if (isZero || value is BinaryExpressionSyntax or PrefixUnaryExpressionSyntax)
            return;

        ITypeSymbol? type = _meaning.GetTypeInfo(value).Type;
        if (type?.SpecialType is SpecialType.System_Double or SpecialType.System_Int32 || type?.GetMembers("op_UnaryNegation").IsEmpty == false)
            Add(value, "-(" + value + ")");
    }

    private void Add(SyntaxNode node, string replacement) => Add(node.Span, replacement);

    private void Add(TextSpan span, string replacement)
    {
        string line = _text.Lines.GetLineFromPosition(span.Start).ToString().Trim();
        _found.Add(new Mutant(_meaning.SyntaxTree.FilePath, span.Start, span.Length, line, _text.ToString(span), replacement));
    }
}
