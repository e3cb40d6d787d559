using System.Globalization;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace RigidBodyDynamics.StudentScripts.Compilation;

/// <summary>Why a script does not compile; the most common mistakes get sentences of their own.</summary>
internal static class CompileErrors
{
    public static IReadOnlyList<Objection> Of(CSharpCompilation compilation)
    {
        IReadOnlyList<Diagnostic> errors = Errors(compilation.GetDiagnostics());
        // where only members are wrong that Unity has and the stand-in lacks, it is not the script's mistake
        string[] unknown = [.. errors.Select(error => UnityNames.NotHere(error, compilation)).OfType<string>()];
        return errors.Count > 0 && unknown.Length == errors.Count
            ? [Objection.At(errors[0].Location, Words.NotInTheStandIn(unknown[0]))]
            : [.. errors.Select(error => Of(error, compilation))];
    }

    public static IReadOnlyList<Objection> Of(IEnumerable<Diagnostic> diagnostics) =>
        [.. Errors(diagnostics).Select(error => Plain("does-not-compile", error))];

    private static IReadOnlyList<Diagnostic> Errors(IEnumerable<Diagnostic> diagnostics) =>
        [.. diagnostics.Where(diagnostic => diagnostic.Severity == DiagnosticSeverity.Error).OrderBy(error => error.Location.SourceSpan.Start)];

    private static Objection Of(Diagnostic error, CSharpCompilation compilation)
    {
        SyntaxNode? node = error.Location.SourceTree?.GetRoot().FindNode(error.Location.SourceSpan, getInnermostNodeForTie: true);
        if (error.Id is "CS0019" or "CS0266" or "CS0664" or "CS1503" or "CS0034" && node != null)
        {
            SemanticModel model = compilation.GetSemanticModel(error.Location.SourceTree!);
            if (node is BinaryExpressionSyntax { RawKind: (int)SyntaxKind.AddExpression } sum && new[] { sum.Left, sum.Right }.Any(part => model.GetTypeInfo(part).Type?.Name == "Quaternion"))
                return Objection.At(error.Location, Words.NoQuaternionSum(Message(error)));
            if (node.DescendantNodesAndSelf().OfType<LiteralExpressionSyntax>().Any(number => number.Token.Value is double))
                return Objection.At(error.Location, Words.DoubleLiteral(Message(error)));
        }

        return Plain(error.Id switch
        {
            "CS1002" => "missing-semicolon",
            "CS0103" or "CS0246" or "CS0234" => "unknown-name",
            "CS0117" or "CS1061" => "unknown-member",
            _ => "does-not-compile",
        }, error);
    }

    private static Objection Plain(string code, Diagnostic error) =>
        Objection.At(error.Location, Words.DoesNotCompile(code, error.Id, Message(error), CompilerInChinese.Message(error)));

    private static string Message(Diagnostic error) => error.GetMessage(CultureInfo.InvariantCulture).TrimEnd('.');
}
