using System.Reflection;
using System.Text.RegularExpressions;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using RigidBodyDynamics.StudentScripts.Compilation;

namespace RigidBodyDynamics.StudentScripts.Comments;

/// <summary>
/// Which statements were added to the starter, and which of them have a comment: on their own line, above them, or above the block
/// of statements, without a blank line, that contains them.
/// </summary>
internal sealed partial class Coverage
{
    private readonly HashSet<string> _given, _givenComments;

    /// <param name="starter">The text of the starter; null for the sheet's.</param>
    public Coverage(string? starter)
    {
        SyntaxTree tree = Parse(starter ?? Sheets());
        _given = [.. Statements(tree).Select(Plain)];
        _givenComments = [.. Comments(tree).Where(trivia => trivia.Token.Parent?.FirstAncestorOrSelf<BlockSyntax>() != null).Select(trivia => Squeezed(trivia.ToString()))];
    }

    /// <summary>The starter that is handed out with the sheet.</summary>
    public static string Sheets()
    {
        using StreamReader reader = new(Assembly.GetExecutingAssembly().GetManifestResourceStream("starter.txt")!);
        return reader.ReadToEnd();
    }

    public CommentCoverage Of(SyntaxTree tree)
    {
        string[] lines = tree.ToString().Split('\n');
        bool[] hasWords = WithWords(tree, lines.Length);
        HashSet<string> explained = [.. tree.GetRoot().DescendantNodes().OfType<MethodDeclarationSyntax>()
            .Where(method => method.Identifier.ValueText is not ("Update" or "FixedUpdate" or "LateUpdate") && IsCommented(method, lines, hasWords)).Select(method => method.Identifier.ValueText)];
        List<int> bare = [];
        int statements = 0;
        foreach (SyntaxNode added in Statements(tree).Where(statement => !_given.Contains(Plain(statement)) && !IsOfTheKeys(statement)))
        {
            statements++;
            // a method of the script that has a comment at its declaration needs no more, nor do its calls
            string method = added.FirstAncestorOrSelf<MethodDeclarationSyntax>()!.Identifier.ValueText;
            if (!IsCommented(added, lines, hasWords) && !Called(added).Append(method).Any(explained.Contains))
                bare.Add(added.GetLocation().GetLineSpan().StartLinePosition.Line + 1);
        }

        return new CommentCoverage(statements, statements - bare.Count, bare);
    }

    private static bool IsCommented(SyntaxNode node, string[] lines, bool[] hasWords)
    {
        FileLinePositionSpan span = node.GetLocation().GetLineSpan();
        int first = span.StartLinePosition.Line, last = node is MethodDeclarationSyntax ? first : span.EndLinePosition.Line;
        for (int line = first; line <= last; line++)
        {
            if (hasWords[line])
                return true;
        }

        // above it, also above lines that only open or close a block
        int above = first - 1;
        while (above >= 0 && lines[above].Trim() is "{" or "}")
            above--;

        return above >= 0 && hasWords[above] && lines[above].TrimStart() is ['/', ..] or ['*', ..] or ['#', ..];
    }

    /// <summary>
    /// The statements that do something in a frame; blocks count only by their contents, and preparation in Start was given with the
    /// sheet, in any form.
    /// </summary>
    private static IEnumerable<SyntaxNode> Statements(SyntaxTree tree) => tree.GetRoot().DescendantNodes().Where(node =>
        (node is LocalDeclarationStatementSyntax or ExpressionStatementSyntax or ReturnStatementSyntax or ThrowStatementSyntax
            || (node is ArrowExpressionClauseSyntax && node.Parent is MethodDeclarationSyntax))
        && node.FirstAncestorOrSelf<MethodDeclarationSyntax>()?.Identifier.ValueText is not (null or "Start" or "Awake" or "OnEnable" or "Reset"));

    // reading keys was given, too: statements under such a condition, or that read a key, clear force and torque, or call the method that does
    private static bool IsOfTheKeys(SyntaxNode statement) =>
        AsksForKeys(statement)
        || statement.Ancestors().OfType<IfStatementSyntax>().Any(condition => AsksForKeys(condition.Condition))
        || Called(statement).Any(name => statement.SyntaxTree.GetRoot().DescendantNodes().OfType<MethodDeclarationSyntax>().Any(method => method.Identifier.ValueText == name && AsksForKeys(method)))
        || (statement is ExpressionStatementSyntax { Expression: AssignmentExpressionSyntax cleared } && cleared.Right.ToString() is "Vector3.zero" or "new Vector3(0, 0, 0)" or "new(0, 0, 0)");

    private static bool AsksForKeys(SyntaxNode node) => node.DescendantNodesAndSelf().OfType<IdentifierNameSyntax>().Any(name => name.Identifier.ValueText == "Input");

    private static IEnumerable<string> Called(SyntaxNode statement) => statement.DescendantNodes().OfType<InvocationExpressionSyntax>()
        .Select(call => call.Expression).OfType<IdentifierNameSyntax>().Select(name => name.Identifier.ValueText);

    // the starter's own comments do not explain added statements; nor does "//1"
    private bool[] WithWords(SyntaxTree tree, int count)
    {
        bool[] hasWords = new bool[count];
        foreach (SyntaxTrivia trivia in Comments(tree).Where(trivia => HasWord(trivia.ToString()) && !_givenComments.Contains(Squeezed(trivia.ToString()))))
        {
            FileLinePositionSpan span = trivia.GetLocation().GetLineSpan();
            for (int line = span.StartLinePosition.Line; line <= span.EndLinePosition.Line && line < count; line++)
                hasWords[line] = true;
        }

        return hasWords;
    }

    private static IEnumerable<SyntaxTrivia> Comments(SyntaxTree tree) => tree.GetRoot().DescendantTrivia().Where(trivia =>
        trivia.Kind() is SyntaxKind.SingleLineCommentTrivia or SyntaxKind.MultiLineCommentTrivia or SyntaxKind.SingleLineDocumentationCommentTrivia
            or SyntaxKind.MultiLineDocumentationCommentTrivia or SyntaxKind.RegionDirectiveTrivia);

    private static bool HasWord(string comment) => Word().IsMatch(comment) && !Empty().IsMatch(comment);

    private static string Squeezed(string comment) => string.Concat(comment.Where(letter => !char.IsWhiteSpace(letter)));

    private static string Plain(SyntaxNode statement) => string.Concat(statement.DescendantTokens().Select(token => token.Text));

    private static SyntaxTree Parse(string text) => CSharpSyntaxTree.ParseText(text, Symbols.OfTheEditor);

    // a letter: "// I" names the quantity, and so does one Chinese character
    [GeneratedRegex(@"\p{L}")]
    private static partial Regex Word();

    // words without information
    [GeneratedRegex(@"^\s*/[/*]+\s*(comment|注释|代码|code|todo|x+|a+|abc|test|测试|here|line|语句)\s*\d*\s*(\*/)?\s*$", RegexOptions.IgnoreCase)]
    private static partial Regex Empty();
}
