using System.Globalization;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;

namespace RigidBodyDynamics.Mutants;

/// <summary>The replacements of each construct.</summary>
internal static class Swaps
{
    /// <summary>
    /// A sign for its opposite, a comparison for the one that differs at equality and for its contrary. A product is not made
    /// a quotient: that a factor matters is asked by leaving it out.
    /// </summary>
    public static string[] Operator(string text) => text switch
    {
        "+" => ["-"],
        "-" => ["+"],
        "/" => ["*"],
        "%" => ["*"],
        "<" => ["<=", ">="],
        "<=" => ["<", ">"],
        ">" => [">=", "<="],
        ">=" => [">", "<"],
        "==" => ["!="],
        "!=" => ["=="],
        "&&" => ["||"],
        "||" => ["&&"],
        "&" => ["|"],
        "|" => ["&"],
        "<<" => [">>"],
        ">>" => ["<<"],
        _ => [],
    };

    /// <summary>The opposite, and the value alone.</summary>
    public static string[] Assignment(string text) => text switch
    {
        "+=" => ["-=", "="],
        "-=" => ["+=", "="],
        "*=" => ["/=", "="],
        "/=" => ["*=", "="],
        "|=" => ["&=", "="],
        _ => [],
    };

    /// <summary>Functions of the same arguments.</summary>
    public static string? Function(string name) => name switch
    {
        "Max" => "Min",
        "Min" => "Max",
        "Floor" => "Ceiling",
        "Ceiling" => "Floor",
        "Rotate" => "RotateInverse",
        "RotateInverse" => "Rotate",
        "FromBody" => "ToBody",
        "ToBody" => "FromBody",
        _ => null,
    };

    /// <summary>The other components of what a name is one component of, the next first.</summary>
    public static string[] Component(string name) => name switch
    {
        "W" => ["X"],
        "X" => ["Y"],
        "Y" => ["Z"],
        "Z" => ["X"],
        "Diagonal" => ["OffDiagonal"],
        "OffDiagonal" => ["Diagonal"],
        [.. string stem, '1'] => [stem + "2", stem + "3"],
        [.. string stem, '2'] => [stem + "3", stem + "1"],
        [.. string stem, '3'] => [stem + "1", stem + "2"],
        _ => [],
    };

    /// <summary>
    /// n + 1. Twice the number where that is 1e3 or more, or below 1e-3: one more in 6227020800 changes no bit, and one
    /// more than 1e-150 has nothing to do with it.
    /// </summary>
    public static string Number(SyntaxToken token)
    {
        if (token.Value is int or long)
        {
            long n = Convert.ToInt64(token.Value, CultureInfo.InvariantCulture);
            return (n < 1000 ? n + 1 : 2 * n).ToString(CultureInfo.InvariantCulture);
        }

        double x = Convert.ToDouble(token.Value, CultureInfo.InvariantCulture);
        string next = x == 0.5 ? "1.0" : (x is >= 1e-3 and < 1e3 ? x + 1 : 2 * x).ToString("R", CultureInfo.InvariantCulture);
        return (next.AsSpan().IndexOfAny(".E") < 0 ? next + ".0" : next) + (token.Value is float ? "f" : "");
    }

    /// <summary>Both sums, or both products: the inner one's operands are operands of the whole.</summary>
    public static bool AreAlike(SyntaxKind a, SyntaxKind b) => IsSum(a) && IsSum(b) || IsProduct(a) && IsProduct(b);

    private static bool IsSum(SyntaxKind kind) => kind is SyntaxKind.AddExpression or SyntaxKind.SubtractExpression;

    private static bool IsProduct(SyntaxKind kind) => kind is SyntaxKind.MultiplyExpression or SyntaxKind.DivideExpression;
}
