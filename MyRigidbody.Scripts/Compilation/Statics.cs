using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace RigidBodyDynamics.StudentScripts.Compilation;

/// <summary>Variables that outlive an object of the script.</summary>
internal static class Statics
{
    public static bool AreIn(SyntaxTree tree) => tree.GetRoot().DescendantNodes().OfType<MemberDeclarationSyntax>().Any(member =>
        member is FieldDeclarationSyntax or PropertyDeclarationSyntax or EventFieldDeclarationSyntax or ConstructorDeclarationSyntax && member.Modifiers.Any(SyntaxKind.StaticKeyword));
}
