using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using Microsoft.CodeAnalysis.Text;
using RigidBodyDynamics.Judging;

namespace RigidBodyDynamics.Tests.Judging;

/// <summary>Scripts that differ from a right one in one place: a number, an operator, a component, a statement left out.</summary>
internal static class SmallChanges
{
    private static readonly Dictionary<SyntaxKind, string[]> Operators = new()
    {
        [SyntaxKind.PlusToken] = ["-"],
        [SyntaxKind.MinusToken] = ["+"],
        [SyntaxKind.AsteriskToken] = ["/"],
        [SyntaxKind.SlashToken] = ["*"],
        [SyntaxKind.PlusEqualsToken] = ["-=", "="],
        [SyntaxKind.MinusEqualsToken] = ["+="],
        [SyntaxKind.AsteriskEqualsToken] = ["/=", "="],
        [SyntaxKind.EqualsEqualsToken] = ["!="],
        [SyntaxKind.ExclamationEqualsToken] = ["=="],
        [SyntaxKind.LessThanToken] = ["<="],
    };

    private static readonly Dictionary<string, string[]> Words = new()
    {
        ["x"] = ["y"],
        ["y"] = ["z"],
        ["z"] = ["x"],
        ["transpose"] = ["inverse"],
        ["inverse"] = ["transpose"],
        ["force"] = ["torque"],
        ["torque"] = ["force"],
        ["v"] = ["w"],
        ["w"] = ["v"],
        ["Sin"] = ["Cos"],
        ["LeftArrow"] = ["RightArrow"],
        ["R"] = ["I_ref"],
    };

    /// <summary>Numbers that a script may choose freely: its mass and its time step.</summary>
    private static readonly string[] Free = ["mass", "dt", "timeStep", "deltaT", "h", "m"];

    public static IEnumerable<(string Name, string Text)> Of(string text)
    {
        SourceText source = SourceText.From(text);
        SyntaxNode root = CSharpSyntaxTree.ParseText(source).GetRoot();
        foreach (SyntaxToken token in root.DescendantTokens().Where(t => !IsFree(t)))
        {
            foreach (string other in Others(token))
                yield return (Name(source, token.Span, other), source.Replace(token.Span, other).ToString());
        }

        foreach (StatementSyntax statement in root.DescendantNodes().OfType<ExpressionStatementSyntax>())
            yield return (Name(source, statement.Span, ""), source.Replace(statement.Span, ";").ToString());
        foreach (BinaryExpressionSyntax product in root.DescendantNodes().OfType<BinaryExpressionSyntax>().Where(b => b.IsKind(SyntaxKind.MultiplyExpression)))
            yield return (Name(source, product.Span, "turned round"), source.Replace(product.Span, $"({product.Right}) * ({product.Left})").ToString());
    }

    private static IEnumerable<string> Others(SyntaxToken token)
    {
        if (token.IsKind(SyntaxKind.NumericLiteralToken))
            return [$"(2*{token.Text})", $"({token.Text}+1)"];
        if (token.IsKind(SyntaxKind.IdentifierToken) && token.Parent is IdentifierNameSyntax or MemberAccessExpressionSyntax)
            return Words.GetValueOrDefault(token.Text, []);
        return token.Parent is ExpressionSyntax ? Operators.GetValueOrDefault(token.Kind(), []) : [];
    }

    private static bool IsFree(SyntaxToken token) =>
        token.Parent?.AncestorsAndSelf().OfType<VariableDeclaratorSyntax>().FirstOrDefault() is { } variable && Free.Contains(variable.Identifier.Text)
        || token.Parent?.AncestorsAndSelf().OfType<AssignmentExpressionSyntax>().FirstOrDefault()?.Left is IdentifierNameSyntax { Identifier.Text: "mass" };

    private static string Name(SourceText source, TextSpan span, string other) =>
        $"line {source.Lines.GetLineFromPosition(span.Start).LineNumber + 1}: {source.ToString(span)} -> {other}";
}

/// <summary>True if two scripts move differently in the same experiments.</summary>
internal static class Difference
{
    /// <summary>More than the effect of other roundings in single precision, and less than any change that matters: in m, m/s, rad, rad/s.</summary>
    private const double Tolerance = 2e-4;

    public static bool Between(Recording a, Recording b) => a.Runs.Zip(b.Runs).Any(pair =>
        pair.First.Frames.Zip(pair.Second.Frames).Any(frames => IsApart(frames.First.After, frames.Second.After)));

    private static bool IsApart(Snapshot a, Snapshot b) =>
        IsApart(a.Position - b.Position, a.Position.Length)
        || !(Orientation.Angle(a.Orientation, b.Orientation) < Tolerance)
        || (a.Velocity.HasValue && b.Velocity.HasValue && IsApart(a.Velocity.Value - b.Velocity.Value, a.Velocity.Value.Length))
        || (a.AngularVelocity.HasValue && b.AngularVelocity.HasValue && IsApart(a.AngularVelocity.Value - b.AngularVelocity.Value, a.AngularVelocity.Value.Length));

    private static bool IsApart(Vector difference, double size) => !(difference.Length < Tolerance * (1 + size));
}
