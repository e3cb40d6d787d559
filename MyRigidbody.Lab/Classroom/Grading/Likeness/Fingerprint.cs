using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;

namespace RigidBodyDynamics.Lab.Grading.Likeness;

/// <summary>
/// A script as sequences of tokens in which all identifiers are equal, so that other names, comments or layout change nothing,
/// and other arithmetic does.
/// </summary>
internal sealed class Fingerprint
{
    /// <summary>The number of tokens in a sequence.</summary>
    public const int RunLength = 14;

    private readonly string[] _runs;
    private readonly int[] _lines;

    private Fingerprint(string[] runs, int[] lines) => (_runs, _lines) = (runs, lines);

    /// <summary>The different sequences of the script.</summary>
    public IReadOnlySet<string> Runs => _runs.ToHashSet();

    /// <summary>Of a text.</summary>
    public static Fingerprint Of(string text)
    {
        SyntaxTree tree = CSharpSyntaxTree.ParseText(text);
        SyntaxToken[] tokens = [.. tree.GetRoot().DescendantTokens().Where(token => !token.IsKind(SyntaxKind.EndOfFileToken) && !token.IsMissing && !InUsing(token))];
        string[] blurred = [.. tokens.Select(token => token.IsKind(SyntaxKind.IdentifierToken) ? "i" : token.Text)];
        return new Fingerprint(
            [.. Enumerable.Range(0, Math.Max(0, tokens.Length - RunLength + 1)).Select(start => string.Join(' ', blurred, start, RunLength))],
            [.. tokens.Select(token => tree.GetLineSpan(token.Span).StartLinePosition.Line + 1)]);
    }

    /// <summary>The number of tokens that are in one of some sequences.</summary>
    public int Covered(Predicate<string> runs) => Marked(runs).Count(isIn => isIn);

    /// <summary>The lines of those tokens.</summary>
    public IReadOnlySet<int> Lines(Predicate<string> runs)
    {
        bool[] marked = Marked(runs);
        return Enumerable.Range(0, marked.Length).Where(token => marked[token]).Select(token => _lines[token]).ToHashSet();
    }

    private bool[] Marked(Predicate<string> runs)
    {
        bool[] marked = new bool[_lines.Length];
        for (int start = 0; start < _runs.Length; start++)
        {
            if (runs(_runs[start]))
                marked.AsSpan(start, RunLength).Fill(true);
        }

        return marked;
    }

    // an IDE adds using directives, so they are ignored
    private static bool InUsing(SyntaxToken token) => token.Parent?.AncestorsAndSelf().Any(node => node.IsKind(SyntaxKind.UsingDirective)) == true;
}
