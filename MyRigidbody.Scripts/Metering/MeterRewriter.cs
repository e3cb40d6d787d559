using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace RigidBodyDynamics.StudentScripts.Metering;

/// <summary>
/// Inserts a tick of the meter into every loop, body and catch block and before every goto. No code moves to another line, so line
/// numbers in findings are right.
/// </summary>
internal sealed class MeterRewriter(SemanticModel model) : CSharpSyntaxRewriter
{
    private static readonly ExpressionSyntax
        MeterTick = SyntaxFactory.ParseExpression("global::RigidBodyDynamics.StudentScripts.Metering.Meter.Tick"),
        MeterHere = SyntaxFactory.ParseExpression("global::RigidBodyDynamics.StudentScripts.Metering.Meter.Here");

    // each statement stores its line, for the message about an exception
    public override SyntaxNode? VisitBlock(BlockSyntax node) =>
        ((BlockSyntax)base.VisitBlock(node)!) is var n ? n.WithStatements(Marked(n.Statements, node.Statements)) : null;

    public override SyntaxNode? VisitSwitchSection(SwitchSectionSyntax node) =>
        ((SwitchSectionSyntax)base.VisitSwitchSection(node)!) is var n ? n.WithStatements(Marked(n.Statements, node.Statements)) : null;

    public override SyntaxNode? VisitIfStatement(IfStatementSyntax node) =>
        ((IfStatementSyntax)base.VisitIfStatement(node)!) is var n ? n.WithStatement(Marked(n.Statement, node.Statement)) : null;

    public override SyntaxNode? VisitElseClause(ElseClauseSyntax node) =>
        ((ElseClauseSyntax)base.VisitElseClause(node)!) is var n ? n.WithStatement(Marked(n.Statement, node.Statement)) : null;

    public override SyntaxNode? VisitForStatement(ForStatementSyntax node) =>
        ((ForStatementSyntax)base.VisitForStatement(node)!) is var n ? n.WithStatement(Ticking(n.Statement, node.Statement)) : null;

    public override SyntaxNode? VisitForEachStatement(ForEachStatementSyntax node) =>
        ((ForEachStatementSyntax)base.VisitForEachStatement(node)!) is var n ? n.WithStatement(Ticking(n.Statement, node.Statement)) : null;

    public override SyntaxNode? VisitForEachVariableStatement(ForEachVariableStatementSyntax node) =>
        ((ForEachVariableStatementSyntax)base.VisitForEachVariableStatement(node)!) is var n ? n.WithStatement(Ticking(n.Statement, node.Statement)) : null;

    public override SyntaxNode? VisitWhileStatement(WhileStatementSyntax node) =>
        ((WhileStatementSyntax)base.VisitWhileStatement(node)!) is var n ? n.WithStatement(Ticking(n.Statement, node.Statement)) : null;

    public override SyntaxNode? VisitDoStatement(DoStatementSyntax node) =>
        ((DoStatementSyntax)base.VisitDoStatement(node)!) is var n ? n.WithStatement(Ticking(n.Statement, node.Statement)) : null;

    public override SyntaxNode? VisitGotoStatement(GotoStatementSyntax node) =>
        SyntaxFactory.Block(Tick(node, node.SpanStart), ((GotoStatementSyntax)base.VisitGotoStatement(node)!).WithoutTrivia()).WithTriviaFrom(node);

    public override SyntaxNode? VisitCatchClause(CatchClauseSyntax node) =>
        ((CatchClauseSyntax)base.VisitCatchClause(node)!) is var n ? n.WithBlock((BlockSyntax)Ticking(n.Block, node.Block)) : null;

    public override SyntaxNode? VisitFinallyClause(FinallyClauseSyntax node) =>
        ((FinallyClauseSyntax)base.VisitFinallyClause(node)!) is var n ? n.WithBlock((BlockSyntax)Ticking(n.Block, node.Block)) : null;

    public override SyntaxNode? VisitMethodDeclaration(MethodDeclarationSyntax node) => Ticking(base.VisitMethodDeclaration(node)!, node, IsVoid(node));

    public override SyntaxNode? VisitLocalFunctionStatement(LocalFunctionStatementSyntax node)
    {
        LocalFunctionStatementSyntax n = (LocalFunctionStatementSyntax)base.VisitLocalFunctionStatement(node)!;
        return n.Body != null ? n.WithBody((BlockSyntax)Ticking(n.Body, node.Body!))
            : n.ExpressionBody is { } arrow ? n.WithExpressionBody(null).WithSemicolonToken(default).WithBody(Body(arrow, node, IsVoid(node)))
            : n;
    }

    public override SyntaxNode? VisitConstructorDeclaration(ConstructorDeclarationSyntax node) => Ticking(base.VisitConstructorDeclaration(node)!, node, isVoid: true);

    public override SyntaxNode? VisitOperatorDeclaration(OperatorDeclarationSyntax node) => Ticking(base.VisitOperatorDeclaration(node)!, node, isVoid: false);

    public override SyntaxNode? VisitConversionOperatorDeclaration(ConversionOperatorDeclarationSyntax node) => Ticking(base.VisitConversionOperatorDeclaration(node)!, node, isVoid: false);

    public override SyntaxNode? VisitAccessorDeclaration(AccessorDeclarationSyntax node)
    {
        AccessorDeclarationSyntax n = (AccessorDeclarationSyntax)base.VisitAccessorDeclaration(node)!;
        return n.Body != null ? n.WithBody((BlockSyntax)Ticking(n.Body, node.Body!))
            : n.ExpressionBody is { } arrow ? n.WithExpressionBody(null).WithSemicolonToken(default).WithBody(Body(arrow, node, !node.IsKind(SyntaxKind.GetAccessorDeclaration)))
            : n;
    }

    public override SyntaxNode? VisitPropertyDeclaration(PropertyDeclarationSyntax node)
    {
        PropertyDeclarationSyntax n = (PropertyDeclarationSyntax)base.VisitPropertyDeclaration(node)!;
        return n.ExpressionBody is { } arrow ? n.WithExpressionBody(null).WithSemicolonToken(default).WithAccessorList(Getter(arrow, node)) : n;
    }

    public override SyntaxNode? VisitIndexerDeclaration(IndexerDeclarationSyntax node)
    {
        IndexerDeclarationSyntax n = (IndexerDeclarationSyntax)base.VisitIndexerDeclaration(node)!;
        return n.ExpressionBody is { } arrow ? n.WithExpressionBody(null).WithSemicolonToken(default).WithAccessorList(Getter(arrow, node)) : n;
    }

    public override SyntaxNode? VisitParenthesizedLambdaExpression(ParenthesizedLambdaExpressionSyntax node)
    {
        ParenthesizedLambdaExpressionSyntax n = (ParenthesizedLambdaExpressionSyntax)base.VisitParenthesizedLambdaExpression(node)!;
        return n.Block != null ? n.WithBlock((BlockSyntax)Ticking(n.Block, node.Block!)) : n.WithExpressionBody(null).WithBlock(Body(n.ExpressionBody!, node));
    }

    public override SyntaxNode? VisitSimpleLambdaExpression(SimpleLambdaExpressionSyntax node)
    {
        SimpleLambdaExpressionSyntax n = (SimpleLambdaExpressionSyntax)base.VisitSimpleLambdaExpression(node)!;
        return n.Block != null ? n.WithBlock((BlockSyntax)Ticking(n.Block, node.Block!)) : n.WithExpressionBody(null).WithBlock(Body(n.ExpressionBody!, node));
    }

    public override SyntaxNode? VisitAnonymousMethodExpression(AnonymousMethodExpressionSyntax node) =>
        ((AnonymousMethodExpressionSyntax)base.VisitAnonymousMethodExpression(node)!) is var n ? n.WithBlock((BlockSyntax)Ticking(n.Block, node.Block)) : null;

    private static BaseMethodDeclarationSyntax Ticking(SyntaxNode visited, BaseMethodDeclarationSyntax original, bool isVoid)
    {
        BaseMethodDeclarationSyntax n = (BaseMethodDeclarationSyntax)visited;
        return n.Body != null ? n.WithBody((BlockSyntax)Ticking(n.Body, original.Body!))
            : n.ExpressionBody is { } arrow ? n.WithExpressionBody(null).WithSemicolonToken(default).WithBody(Body(arrow, original, isVoid))
            : n;
    }

    // a body that is one statement, or none, becomes a block on the same lines
    private static StatementSyntax Ticking(StatementSyntax body, StatementSyntax original) => body is BlockSyntax block
        ? block.WithStatements(block.Statements.Insert(0, Tick(original, ((BlockSyntax)original).OpenBraceToken.FullSpan.End)))
        : SyntaxFactory.Block(Tick(original, original.FullSpan.Start), Mark(original), body);

    private static SyntaxList<StatementSyntax> Marked(SyntaxList<StatementSyntax> statements, SyntaxList<StatementSyntax> originals) =>
        SyntaxFactory.List(statements.Zip(originals, (statement, original) => statement is LocalFunctionStatementSyntax ? [statement] : new[] { Mark(original), statement }).SelectMany(pair => pair));

    private static StatementSyntax Marked(StatementSyntax statement, StatementSyntax original) =>
        statement is BlockSyntax or IfStatementSyntax ? statement : SyntaxFactory.Block(Mark(original), statement);

    private static ExpressionStatementSyntax Mark(StatementSyntax original) =>
        SyntaxFactory.ExpressionStatement(SyntaxFactory.AssignmentExpression(SyntaxKind.SimpleAssignmentExpression, MeterHere, Line(original, original.SpanStart)));

    // stores its line, because not every runtime can find the line of running code
    private static ExpressionStatementSyntax Tick(SyntaxNode original, int position) => SyntaxFactory.ExpressionStatement(SyntaxFactory.InvocationExpression(
        MeterTick, SyntaxFactory.ArgumentList(SyntaxFactory.SingletonSeparatedList(SyntaxFactory.Argument(Line(original, position))))));

    private static LiteralExpressionSyntax Line(SyntaxNode original, int position) => SyntaxFactory.LiteralExpression(
        SyntaxKind.NumericLiteralExpression, SyntaxFactory.Literal(original.SyntaxTree.GetText().Lines.GetLineFromPosition(position).LineNumber + 1));

    private bool IsVoid(SyntaxNode method) => model.GetDeclaredSymbol(method) is IMethodSymbol { ReturnsVoid: true };

    private AccessorListSyntax Getter(ArrowExpressionClauseSyntax arrow, SyntaxNode of) => SyntaxFactory.AccessorList(SyntaxFactory.SingletonList(
        SyntaxFactory.AccessorDeclaration(SyntaxKind.GetAccessorDeclaration, Body(arrow, of, isVoid: false))));

    private static BlockSyntax Body(ArrowExpressionClauseSyntax arrow, SyntaxNode of, bool isVoid) =>
        Body(arrow.Expression, isVoid, arrow.ArrowToken, Tick(of, of.ChildNodes().OfType<ArrowExpressionClauseSyntax>().Single().FullSpan.Start)).WithTrailingTrivia(of.GetTrailingTrivia());

    private BlockSyntax Body(ExpressionSyntax expression, LambdaExpressionSyntax of) =>
        Body(expression, model.GetSymbolInfo(of).Symbol is IMethodSymbol { ReturnsVoid: true }, default, Tick(of, of.ExpressionBody!.FullSpan.Start));

    private static BlockSyntax Body(ExpressionSyntax expression, bool isVoid, SyntaxToken arrow, StatementSyntax tick)
    {
        // trivia between the arrow and the expression may contain line breaks: it is kept
        expression = expression.WithLeadingTrivia(arrow.LeadingTrivia.AddRange(arrow.TrailingTrivia).AddRange(expression.GetLeadingTrivia()));
        StatementSyntax statement =
            expression is ThrowExpressionSyntax thrown ? SyntaxFactory.ThrowStatement(thrown.Expression)
            : isVoid ? SyntaxFactory.ExpressionStatement(expression)
            : SyntaxFactory.ReturnStatement(expression).WithReturnKeyword(SyntaxFactory.Token(SyntaxKind.ReturnKeyword).WithTrailingTrivia(SyntaxFactory.Space));
        return SyntaxFactory.Block(tick, statement);
    }
}
