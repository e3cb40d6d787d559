using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using RigidBodyDynamics.Lab.Grading.Reading;
using RigidBodyDynamics.StudentScripts;

namespace RigidBodyDynamics.Lab.Grading.Judging;

/// <summary>
/// Which scripts of a package are compiled along: those whose types the student's script uses, and what those use. What else
/// lies in a project (samples, editor tools) could only make a right script fail.
/// </summary>
internal static class Companions
{
    /// <summary>A script, and what of the others it needs.</summary>
    public static IReadOnlyList<Script> With(Script main, IEnumerable<Script> others)
    {
        List<Script> needed = [main];
        Queue<SyntaxNode> open = new([Parse(main)]);
        List<(Script Script, SyntaxNode Tree)> left =
            [.. others.Where(script => script != main && !IsOfEditor(script)).Select(script => (script, Parse(script)))];
        while (open.TryDequeue(out SyntaxNode? tree))
        {
            HashSet<string> used = [.. tree.DescendantTokens().Where(token => token.IsKind(SyntaxKind.IdentifierToken)).Select(token => token.ValueText)];
            foreach ((Script Script, SyntaxNode Tree) found in left.Where(one => Declared(one.Tree).Any(used.Contains)).ToArray())
            {
                left.Remove(found);
                needed.Add(found.Script);
                open.Enqueue(found.Tree);
            }
        }

        return needed;
    }

    private static SyntaxNode Parse(Script script) => CSharpSyntaxTree.ParseText(SourceText.Decode(script.Bytes).Text).GetRoot();

    /// <summary>Names of types, and of methods that extend others' types.</summary>
    private static IEnumerable<string> Declared(SyntaxNode tree) => tree.DescendantNodes().SelectMany(node => node switch
    {
        BaseTypeDeclarationSyntax type => [type.Identifier.ValueText],
        DelegateDeclarationSyntax type => [type.Identifier.ValueText],
        MethodDeclarationSyntax { ParameterList.Parameters: [var first, ..] } method when first.Modifiers.Any(SyntaxKind.ThisKeyword) => [method.Identifier.ValueText],
        _ => Array.Empty<string>(),
    });

    private static bool IsOfEditor(Script script) => script.Spot.Names.SkipLast(1).Contains("Editor");
}
