using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using RigidBodyDynamics.Tests.Repository;

namespace RigidBodyDynamics.Tests.Languages;

/// <summary>What the source of the command line and of the library's refusals can say, with a 7 for what only a run knows.</summary>
internal static class SaidInSource
{
    private const string Unknown = "7";

    // who is handed a sentence for the user
    private static readonly HashSet<string> Speakers =
    [
        "InputException", "FellShortException", "OmittedException", "Wrong", "Not", "Refused", "Refuse", "Finding", "Without",
        "WriteText", "WriteLine", "Note", "Error", "TextTable", "WithProgress", "Command", "RootCommand", "MustHold", "OnlyIf", "Say",
    ];

    /// <summary>Every sentence, and the file in which it stands.</summary>
    public static IEnumerable<(string File, string Text)> All() =>
        from file in Tree.Files("MyRigidbody.Lab", "*.cs").Concat(Tree.Files("MyRigidbody.Core", "*.cs"))
        from sentence in In(Tree.Text(file))
        select (file, sentence);

    private static IEnumerable<string> In(string source) => CSharpSyntaxTree.ParseText(source).GetRoot().DescendantNodes().SelectMany(Handed).SelectMany(Texts).Where(text => text.Length > 0).Distinct();

    private static IEnumerable<ExpressionSyntax> Handed(SyntaxNode node) => node switch
    {
        InvocationExpressionSyntax call when Speakers.Contains(NameOf(call.Expression)) => call.ArgumentList.Arguments.Select(argument => argument.Expression),
        ObjectCreationExpressionSyntax made when Speakers.Contains(NameOf(made.Type)) => made.ArgumentList?.Arguments.Select(argument => argument.Expression) ?? [],
        AssignmentExpressionSyntax set when set.Left.ToString() == "Description" => [set.Right],
        _ => [],
    };

    private static string NameOf(ExpressionSyntax called) => called switch
    {
        MemberAccessExpressionSyntax member => member.Name.Identifier.Text,
        GenericNameSyntax generic => generic.Identifier.Text,
        _ => called.ToString(),
    };

    /// <summary>What an expression may be: the branches of a choice one by one, the parts of a sum together.</summary>
    private static IEnumerable<string> Texts(ExpressionSyntax expression) => expression switch
    {
        LiteralExpressionSyntax literal when literal.Token.Value is string text => [text],
        InterpolatedStringExpressionSyntax interpolated => interpolated.Contents.Aggregate<InterpolatedStringContentSyntax, IEnumerable<string>>([string.Empty], (before, part) =>
            from start in before
            from end in part is InterpolatedStringTextSyntax text ? [text.TextToken.ValueText] : Texts(((InterpolationSyntax)part).Expression)
            select start + end),
        BinaryExpressionSyntax sum when sum.IsKind(SyntaxKind.AddExpression) => from left in Texts(sum.Left) from right in Texts(sum.Right) select left + right,
        ConditionalExpressionSyntax choice => Texts(choice.WhenTrue).Concat(Texts(choice.WhenFalse)),
        ParenthesizedExpressionSyntax inner => Texts(inner.Expression),
        InvocationExpressionSyntax formatted when NameOf(formatted.Expression) is "Invariant" or "Create" => Texts(formatted.ArgumentList.Arguments[^1].Expression),
        _ when expression.ToString() == "string.Empty" => [string.Empty],
        _ => [Unknown],
    };
}
