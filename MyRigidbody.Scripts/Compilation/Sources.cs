using System.Text;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace RigidBodyDynamics.StudentScripts.Compilation;

/// <summary>The source files of a submission, parsed, and which of them is the script.</summary>
internal sealed class Sources
{
    /// <summary>What a script is called.</summary>
    public const string ClassName = "MyRigidbody";

    // a script of the lab has 5 kB
    private const int MostBytes = 500_000, MostFiles = 40;

    private Sources(IReadOnlyList<SyntaxTree> trees) => Trees = trees;

    public IReadOnlyList<SyntaxTree> Trees { get; }

    /// <summary>The file and the class of the script; null where there is none.</summary>
    public ClassDeclarationSyntax? Script { get; private set; }

    /// <summary>Other files that have a script of that name too.</summary>
    public IReadOnlyList<string> Others { get; private set; } = [];

    /// <summary>Reads the files, or says which is too large.</summary>
    public static (Sources? Read, string? TooLarge) Read(IReadOnlyList<ScriptFile> files)
    {
        if (files.FirstOrDefault(file => file.Bytes.Length > MostBytes) is { } large)
            return (null, large.Name);
        if (files.Count > MostFiles)
            return (null, files[MostFiles].Name);

        Sources sources = new([.. files.Select(file => CSharpSyntaxTree.ParseText(SourceText.Decode(file.Bytes).Text, Symbols.OfTheEditor, file.Name, Encoding.UTF8))]);
        sources.FindScript();
        return (sources, null);
    }

    /// <summary>The script's file and those that declare what it names, and what they name in turn.</summary>
    public IReadOnlyList<SyntaxTree> WithWhatTheyName()
    {
        List<SyntaxTree> needed = [Script!.SyntaxTree];
        for (int i = 0; i < needed.Count; i++)
        {
            HashSet<string> names = [.. needed[i].GetRoot().DescendantTokens().Where(token => token.IsKind(SyntaxKind.IdentifierToken)).Select(token => token.ValueText)];
            needed.AddRange(Trees.Where(tree => !needed.Contains(tree) && !Others.Contains(tree.FilePath)
                && tree.GetRoot().DescendantNodes().OfType<BaseTypeDeclarationSyntax>().Any(type => names.Contains(type.Identifier.ValueText))));
        }

        return needed;
    }

    private void FindScript()
    {
        // a class that says it is a script of Unity; by its name, else the first with a message in which one could step
        List<ClassDeclarationSyntax> scripts = [.. Trees.SelectMany(tree => tree.GetRoot().DescendantNodes().OfType<ClassDeclarationSyntax>())
            .Where(type => type.BaseList?.Types.Any(parent => parent.Type.ToString().EndsWith("MonoBehaviour", StringComparison.Ordinal)) == true)];
        List<ClassDeclarationSyntax> called = [.. scripts.Where(type => type.Identifier.ValueText == ClassName)];
        Script = called.FirstOrDefault()
            ?? scripts.FirstOrDefault(type => string.Equals(type.Identifier.ValueText, ClassName, StringComparison.OrdinalIgnoreCase))
            ?? scripts.FirstOrDefault(type => type.Identifier.ValueText != "DefaultRigidbody" && type.Members.OfType<MethodDeclarationSyntax>().Any(method => method.Identifier.ValueText is "Update" or "FixedUpdate" or "LateUpdate"));
        Others = [.. called.Skip(1).Select(type => type.SyntaxTree.FilePath).Where(path => path != Script?.SyntaxTree.FilePath).Distinct()];
    }
}
