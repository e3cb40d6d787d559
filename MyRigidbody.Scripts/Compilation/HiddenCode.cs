using System.Text.RegularExpressions;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using RigidBodyDynamics.Judging;

namespace RigidBodyDynamics.StudentScripts.Compilation;

/// <summary>Code behind an #if that is not compiled in the editor.</summary>
internal static partial class HiddenCode
{
    /// <summary>A note for the first such place of a file.</summary>
    public static IEnumerable<Finding> Of(SyntaxTree tree) =>
        tree.GetRoot().DescendantTrivia(descendIntoTrivia: true)
            .Where(trivia => trivia.IsKind(SyntaxKind.DisabledTextTrivia) && Code().IsMatch(Comments().Replace(trivia.ToString(), string.Empty)))
            .Take(1)
            .Select(trivia => Words.CodeBehindIf().At(ScriptCompiler.LineOf(trivia.GetLocation())));

    [GeneratedRegex(@"//.*|/\*[\s\S]*?\*/|^\s*(#|using\b).*$", RegexOptions.Multiline)]
    private static partial Regex Comments();

    [GeneratedRegex(@"\w")]
    private static partial Regex Code();
}
