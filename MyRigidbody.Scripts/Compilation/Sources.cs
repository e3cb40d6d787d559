using System.Text;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace RigidBodyDynamics.StudentScripts.Compilation;

/// <summary>The source files of a submission: which of them is the script, and which of the others it needs.</summary>
internal sealed class Sources
{
    /// <summary>The class name of a script.</summary>
    public const string ClassName = "MyRigidbody";

    // a script of the lab has 5 kB
    private const int MostBytes = 500_000, MostNeeded = 40;

    private Sources(IReadOnlyList<SyntaxTree> trees)
    {
        // a class derived from MonoBehaviour; by its name, else the first with a message in which a step is possible
        List<ClassDeclarationSyntax> scripts = [.. trees.SelectMany(tree => tree.GetRoot().DescendantNodes().OfType<ClassDeclarationSyntax>())
            .Where(type => type.BaseList?.Types.Any(parent => parent.Type.ToString().EndsWith("MonoBehaviour", StringComparison.Ordinal)) == true)];
        List<ClassDeclarationSyntax> called = [.. scripts.Where(type => type.Identifier.ValueText == ClassName)];
        Script = called.FirstOrDefault()
            ?? scripts.FirstOrDefault(type => string.Equals(type.Identifier.ValueText, ClassName, StringComparison.OrdinalIgnoreCase))
            ?? scripts.FirstOrDefault(type => type.Identifier.ValueText != "DefaultRigidbody" && type.Members.OfType<MethodDeclarationSyntax>().Any(method => method.Identifier.ValueText is "Update" or "FixedUpdate" or "LateUpdate"));
        Others = [.. called.Skip(1).Select(type => type.SyntaxTree.FilePath).Where(path => path != Script?.SyntaxTree.FilePath).Distinct()];
        Trees = Script == null ? [] : WithWhatTheyName(Script.SyntaxTree, [.. trees.Where(tree => tree != Script.SyntaxTree && !Others.Contains(tree.FilePath))]);
    }

    /// <summary>The class of the script; null where there is none.</summary>
    public ClassDeclarationSyntax? Script { get; }

    /// <summary>Other files that contain a script of that name, too.</summary>
    public IReadOnlyList<string> Others { get; }

    /// <summary>
    /// The script's file and those that declare the names in it, and the names in those. Other files of a project (samples, tools)
    /// could only make a right script fail.
    /// </summary>
    public IReadOnlyList<SyntaxTree> Trees { get; }

    /// <summary>Reads the files, or names one that is too large.</summary>
    /// <param name="files">The most likely script first; others that are too large are left out.</param>
    public static (Sources? Read, string? TooLarge) Read(IReadOnlyList<ScriptFile> files)
    {
        if (files is [var first, ..] && first.Bytes.Length > MostBytes)
            return (null, first.Name);

        Sources sources = new([.. files.Where(file => file.Bytes.Length <= MostBytes)
            .Select(file => CSharpSyntaxTree.ParseText(SourceText.Decode(file.Bytes).Text, Symbols.OfTheEditor, file.Name, Encoding.UTF8))]);
        return sources.Trees.Count > MostNeeded ? (null, sources.Trees[MostNeeded].FilePath) : (sources, null);
    }

    private static List<SyntaxTree> WithWhatTheyName(SyntaxTree script, List<SyntaxTree> others)
    {
        List<SyntaxTree> needed = [script];
        for (int i = 0; i < needed.Count; i++)
        {
            HashSet<string> names = [.. needed[i].GetRoot().DescendantTokens().Where(token => token.IsKind(SyntaxKind.IdentifierToken)).Select(token => token.ValueText)];
            SyntaxTree[] named = [.. others.Where(tree => Declared(tree).Any(names.Contains))];
            needed.AddRange(named);
            others.RemoveAll(named.Contains);
        }

        return needed;
    }

    /// <summary>Names of types, and of extension methods.</summary>
    private static IEnumerable<string> Declared(SyntaxTree tree) => tree.GetRoot().DescendantNodes().SelectMany(node => node switch
    {
        BaseTypeDeclarationSyntax type => [type.Identifier.ValueText],
        DelegateDeclarationSyntax type => [type.Identifier.ValueText],
        MethodDeclarationSyntax { ParameterList.Parameters: [var first, ..] } method when first.Modifiers.Any(SyntaxKind.ThisKeyword) => [method.Identifier.ValueText],
        _ => Array.Empty<string>(),
    });
}
