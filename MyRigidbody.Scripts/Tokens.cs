using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;

namespace RigidBodyDynamics.StudentScripts;

/// <summary>One token of a source text, without the trivia around it.</summary>
/// <param name="Kind">Its kind in the compiler.</param>
/// <param name="Text">As written.</param>
/// <param name="Line">Its line, from 1.</param>
public readonly record struct Token(string Kind, string Text, int Line);

/// <summary>A source text as the compiler's lexer sees it: comments, blanks and code behind #if are left out.</summary>
public static class Tokens
{
    public static IReadOnlyList<Token> Of(string text)
    {
        int line = 1, at = 0;
        List<Token> tokens = [];
        foreach (SyntaxToken token in SyntaxFactory.ParseTokens(text, options: Compilation.Symbols.OfTheEditor))
        {
            for (; at < token.SpanStart && at < text.Length; at++)
            {
                if (text[at] == '\n')
                    line++;
            }

            if (!token.IsKind(SyntaxKind.EndOfFileToken))
                tokens.Add(new Token(token.Kind().ToString(), token.Text, line));
        }

        return tokens;
    }
}
