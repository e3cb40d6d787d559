using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace RigidBodyDynamics.StudentScripts.Comments;

/// <summary>A line that assigns a variable, or moves or rotates the object, in a method that runs in every frame.</summary>
/// <param name="Name">The variable; transform.position or transform.rotation for a move or rotation.</param>
/// <param name="Line">From 1.</param>
/// <param name="Damps">True if it multiplies by a number alone, as v *= 0.98f does.</param>
internal sealed record Assignment(string Name, int Line, bool Damps)
{
    public const string Position = "transform.position", Rotation = "transform.rotation";

    /// <summary>A line that creates a quaternion without a real part, such as [0, ½Δt ω].</summary>
    public const string PureQuaternion = "[0, ω]";

    public static IReadOnlyList<Assignment> In(SyntaxTree tree) =>
        [.. tree.GetRoot().DescendantNodes().Where(IsInFrame).Select(Of).OfType<Assignment>().OrderBy(assignment => assignment.Line)];

    private static Assignment? Of(SyntaxNode node) => node switch
    {
        AssignmentExpressionSyntax set when Target(set.Left) is { } name => new Assignment(name, LineOf(node), Multiplies(set)),
        InvocationExpressionSyntax { Expression: MemberAccessExpressionSyntax called } when IsObject(called.Expression) && Moved(called.Name.Identifier.ValueText) is { } moved =>
            new Assignment(moved, LineOf(node), false),
        ObjectCreationExpressionSyntax { Type: IdentifierNameSyntax { Identifier.ValueText: "Quaternion" }, ArgumentList.Arguments: { Count: 4 } parts }
            when parts[3].ToString() is "0" or "0f" or "0.0f" => new Assignment(PureQuaternion, LineOf(node), false),
        _ => null,
    };

    private static bool IsObject(ExpressionSyntax owner) => owner.ToString() is not ("Matrix4x4" or "Quaternion" or "Vector3");

    private static string? Moved(string method) => method switch
    {
        "Translate" => Position,
        "Rotate" or "RotateAround" => Rotation,
        "SetPositionAndRotation" => Position,
        _ => null,
    };

    private static string? Target(ExpressionSyntax left) => left switch
    {
        IdentifierNameSyntax name => name.Identifier.ValueText,
        MemberAccessExpressionSyntax { Name.Identifier.ValueText: "position" or "localPosition" } => Position,
        MemberAccessExpressionSyntax { Name.Identifier.ValueText: "rotation" or "localRotation" or "eulerAngles" or "localEulerAngles" } => Rotation,
        MemberAccessExpressionSyntax { Expression: ThisExpressionSyntax } own => own.Name.Identifier.ValueText,
        MemberAccessExpressionSyntax { Expression: IdentifierNameSyntax of, Name.Identifier.ValueText: "x" or "y" or "z" or "w" } => of.Identifier.ValueText,
        _ => null,
    };

    // v *= 0.98f, v = v * 0.98f, v = 0.98f * v, v *= decay
    private static bool Multiplies(AssignmentExpressionSyntax set) =>
        set.IsKind(SyntaxKind.MultiplyAssignmentExpression)
        || (set.Right is BinaryExpressionSyntax { RawKind: (int)SyntaxKind.MultiplyExpression } product
            && new[] { product.Left, product.Right }.Any(part => part.ToString() == set.Left.ToString())
            && new[] { product.Left, product.Right }.Any(part => part is LiteralExpressionSyntax or IdentifierNameSyntax && part.ToString() != set.Left.ToString()))
        || (set.Right is InvocationExpressionSyntax { Expression: IdentifierNameSyntax { Identifier.ValueText: var method } }
            && (method.Contains("ecay", StringComparison.Ordinal) || method.Contains("amp", StringComparison.Ordinal)));

    private static bool IsInFrame(SyntaxNode node) =>
        node is AssignmentExpressionSyntax or InvocationExpressionSyntax or ObjectCreationExpressionSyntax
        && node.FirstAncestorOrSelf<MethodDeclarationSyntax>() is { Identifier.ValueText: not ("Start" or "Awake" or "OnEnable" or "Reset") };

    private static int LineOf(SyntaxNode node) => node.GetLocation().GetLineSpan().StartLinePosition.Line + 1;
}
