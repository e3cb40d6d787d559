using System.Globalization;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using Microsoft.CodeAnalysis.Text;

namespace RigidBodyDynamics.Mutants;

/// <summary>
/// A mark at the head of every member, branch and case: a test that sets none of the marks around a mutant need not be run for
/// it. Written into the text, so that the marked Core is the Core with calls in it and nothing else.
/// </summary>
internal sealed class Marks
{
    private readonly Dictionary<string, List<(TextSpan Span, int Number)>> _places = [];
    private readonly Dictionary<string, List<TextChange>> _changes = [];
    private int _count;

    /// <summary>Marks for some files.</summary>
    public Marks(IEnumerable<SyntaxTree> trees)
    {
        foreach (SyntaxTree tree in trees)
        {
            _places[tree.FilePath] = [];
            _changes[tree.FilePath] = [];
            foreach (SyntaxNode node in tree.GetRoot().DescendantNodes())
                Mark(tree.FilePath, node);
        }
    }

    /// <summary>The assembly that sets the marks.</summary>
    public byte[] Compile(CoreCompilation core) => core.With(_changes, string.Create(CultureInfo.InvariantCulture, $$"""
        namespace RigidBodyDynamics
        {
            internal static class Reached
            {
                public static readonly bool[] Marks = new bool[{{_count}}];
                public static void At(int mark) { Marks[mark] = true; }
                public static T At<T>(int mark, T value) { Marks[mark] = true; return value; }
            }
        }
        """));

    /// <summary>The mark closest around a mutant; none where it stands outside all code: a constant, a start value.</summary>
    public int? Around(Mutant mutant)
    {
        IEnumerable<(TextSpan Span, int Number)> around = _places[mutant.File].Where(place => place.Span.Contains(mutant.Span));
        return around.Any() ? around.MinBy(place => place.Span.Length).Number : null;
    }

    /// <summary>All marks of a file.</summary>
    public IEnumerable<int> Of(string file) => _places[file].Select(place => place.Number);

    private void Mark(string file, SyntaxNode node)
    {
        switch (node)
        {
            case BlockSyntax block:
                Insert(file, node.Span, block.OpenBraceToken.Span.End, 0, $" Reached.At({_count});", "");
                break;
            case SwitchSectionSyntax section:
                Insert(file, node.Span, section.Labels.Span.End, 0, $" Reached.At({_count});", "");
                break;
            case ArrowExpressionClauseSyntax { Expression: not ThrowExpressionSyntax } arrow:
                MarkArrow(file, arrow);
                break;
            case StatementSyntax statement when statement is not (IfStatementSyntax or BlockSyntax) && IsAlone(statement):
                Insert(file, node.Span, node.SpanStart, node.Span.End, $"{{ Reached.At({_count}); ", " }");
                break;
            case ConditionalExpressionSyntax choice:
                MarkValue(file, choice.WhenTrue);
                MarkValue(file, choice.WhenFalse);
                break;
            default:
                break;
        }
    }

    private static bool IsAlone(StatementSyntax statement) =>
        statement.Parent is IfStatementSyntax or ElseClauseSyntax or ForStatementSyntax or WhileStatementSyntax or ForEachStatementSyntax;

    private void MarkValue(string file, ExpressionSyntax value)
    {
        // a constant beside a value takes that value's type, which a call would hide
        if (value is not (ThrowExpressionSyntax or LiteralExpressionSyntax))
            Insert(file, value.Span, value.SpanStart, value.Span.End, $"Reached.At({_count}, ", ")");
    }

    private void MarkArrow(string file, ArrowExpressionClauseSyntax arrow)
    {
        bool isVoid = arrow.Parent is ConstructorDeclarationSyntax or AccessorDeclarationSyntax { RawKind: (int)SyntaxKind.SetAccessorDeclaration }
            or MethodDeclarationSyntax { ReturnType: PredefinedTypeSyntax { Keyword.RawKind: (int)SyntaxKind.VoidKeyword } };
        bool isProperty = arrow.Parent is PropertyDeclarationSyntax or IndexerDeclarationSyntax;
        string begin = (isProperty ? "{ get " : "") + $"{{ Reached.At({_count}); " + (isVoid ? "" : "return ");
        _changes[file].Add(new TextChange(arrow.ArrowToken.Span, begin));
        _changes[file].Add(new TextChange(new TextSpan(arrow.Parent!.Span.End, 0), isProperty ? " } }" : " }"));
        _places[file].Add((arrow.Span, _count++));
    }

    private void Insert(string file, TextSpan place, int before, int after, string begin, string end)
    {
        _changes[file].Add(new TextChange(new TextSpan(before, 0), begin));
        if (end.Length > 0)
            _changes[file].Add(new TextChange(new TextSpan(after, 0), end));
        _places[file].Add((place, _count++));
    }
}
