using System.Text.RegularExpressions;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using Microsoft.CodeAnalysis.Text;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests.Repository;

/// <summary>What .editorconfig says of namespaces and braces and no analyser of it finds.</summary>
[Parallelizable(ParallelScope.All)]
public sealed partial class StyleTests
{
    private static readonly string[] Projects = ["MyRigidbody.Core", "MyRigidbody.Judge", "MyRigidbody.Lab", "MyRigidbody.Scripts", "MyRigidbody.Web", "tests/MyRigidbody.Tests"];

    [TestCaseSource(nameof(Projects))]
    public void Files_of_a_folder_have_one_namespace_made_of_names_on_the_way_to_it(string project)
    {
        (string Folder, string Namespace)[] found = [.. Tree.Files(project, "*.cs").Where(path => !path.Contains('~'))
            .Select(path => (Folder: path[..path.LastIndexOf('/')], Namespace: Namespace().Match(Tree.Text(path)).Groups[1].Value)).Where(file => file.Namespace.Length > 0).Distinct()];
        string root = found.Select(file => file.Namespace).MinBy(name => name.Length)!;

        Assert.That(found.GroupBy(file => file.Folder).Where(folder => folder.Count() > 1).Select(folder => folder.Key), Is.Empty);
        Assert.That(found.Where(file => !IsOnTheWay(file.Namespace[root.Length..].Split('.', StringSplitOptions.RemoveEmptyEntries), file.Folder.Split('/'))), Is.Empty);
    }

    [TestCaseSource(nameof(Projects))]
    public void No_statement_of_one_line_has_braces(string project)
    {
        IEnumerable<string> found =
            from path in Tree.Files(project, "*.cs")
            from block in Superfluous(CSharpSyntaxTree.ParseText(Tree.Text(path), new CSharpParseOptions(LanguageVersion.Latest, preprocessorSymbols: ["NET"])).GetRoot())
            select $"{path}:{block.GetLocation().GetLineSpan().StartLinePosition.Line + 1}";

        Assert.That(found, Is.Empty);
    }

    [TestCase("if (a)\n{\n    B();\n}", 1)]
    [TestCase("if (a)\n    B();", 0)]
    [TestCase("if (a)\n{\n    B();\n    C();\n}", 0)]
    [TestCase("if (a)\n{\n    B();\n}\nelse\n{\n    C();\n}", 2)]
    [TestCase("if (a)\n{\n    B();\n}\nelse\n{\n    C();\n    C();\n}", 0)]
    [TestCase("if (a\n    && b)\n{\n    B();\n}", 0)]
    [TestCase("foreach (int i in a)\n{\n    // because\n    B();\n}", 0)]
    [TestCase("while (a)\n{\n    B();\n}", 1)]
    public void Braces_are_needed_where_something_takes_more_than_one_line(string code, int superfluous) =>
        Assert.That(Superfluous(CSharpSyntaxTree.ParseText(code).GetRoot()).Count(), Is.EqualTo(superfluous));

    // names of folders, some of which may be left out
    private static bool IsOnTheWay(string[] names, string[] folders)
    {
        int next = 0;
        foreach (string folder in folders)
            next += next < names.Length && names[next] == folder ? 1 : 0;

        return next == names.Length;
    }

    private static IEnumerable<BlockSyntax> Superfluous(SyntaxNode root) =>
        from statement in root.DescendantNodes().OfType<StatementSyntax>()
        where statement is CommonForEachStatementSyntax or ForStatementSyntax or WhileStatementSyntax or IfStatementSyntax { Parent: not ElseClauseSyntax }
        let branches = Branches(statement).ToArray()
        where branches.All(IsOneLine)
        from block in branches.OfType<BlockSyntax>()
        select block;

    private static IEnumerable<StatementSyntax> Branches(StatementSyntax statement) => statement switch
    {
        IfStatementSyntax { Else.Statement: { } other } choice => Branches(other).Prepend(choice.Statement),
        IfStatementSyntax choice => [choice.Statement],
        ForStatementSyntax loop => [loop.Statement],
        CommonForEachStatementSyntax loop => [loop.Statement],
        WhileStatementSyntax loop => [loop.Statement],
        _ => [statement],
    };

    // with what stands before it
    private static bool IsOneLine(StatementSyntax branch)
    {
        StatementSyntax? only = branch is not BlockSyntax block ? branch
            : block.Statements.Count == 1 && block.Statements[0] is not (LocalDeclarationStatementSyntax or LocalFunctionStatementSyntax) && !block.DescendantTrivia().Any(IsCommentOrDirective) ? block.Statements[0]
            : null;
        return only != null && Lines(only.Span) == 1 && Lines(TextSpan.FromBounds(branch.Parent!.SpanStart, branch.GetFirstToken().GetPreviousToken().Span.End)) == 1;

        int Lines(TextSpan span) => branch.SyntaxTree.GetLineSpan(span) is var lines ? lines.EndLinePosition.Line - lines.StartLinePosition.Line + 1 : 0;
    }

    private static bool IsCommentOrDirective(SyntaxTrivia trivia) => trivia.IsDirective || trivia.IsKind(SyntaxKind.SingleLineCommentTrivia);

    [GeneratedRegex(@"^namespace ([\w.]+)", RegexOptions.Multiline)]
    private static partial Regex Namespace();
}
