using System.Collections.Concurrent;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace RigidBodyDynamics.Tests.Repository;

/// <summary>Which folder of a project refers to which, as its compiler understands the code.</summary>
internal static class Arrows
{
    // what the command line's project imports by itself
    private const string Imports =
        "global using System; global using System.Collections.Generic; global using System.IO; global using System.Linq; global using System.Threading; global using System.Threading.Tasks;";

    private static readonly CSharpParseOptions Modern = new(LanguageVersion.Latest, preprocessorSymbols: ["NET", "NET8_0_OR_GREATER", "NET10_0_OR_GREATER"]);

    private static readonly ConcurrentDictionary<string, Lazy<(string From, string To, string What)[]>> Found = [];
    private static readonly ConcurrentDictionary<string, Lazy<CSharpCompilation>> Projects = [];

    /// <summary>Files that refer to one another, by their paths from the project's folder, with an example of what is referred to.</summary>
    public static (string From, string To, string What)[] BetweenFiles(string project) => Found.GetOrAdd(project, name => new(() => Find(name))).Value;

    /// <summary>The code of a folder as its compiler sees it.</summary>
    public static CSharpCompilation Compiled(string project) => Projects.GetOrAdd(project, name => new(() => Compile(name))).Value;

    private static CSharpCompilation Compile(string project) => CSharpCompilation.Create(
        project,
        Tree.Files(project, "*.cs").Where(path => !path.Contains('~')).Select(path => CSharpSyntaxTree.ParseText(Tree.Text(path), Modern, path[(project.Length + 1)..]))
            .Append(CSharpSyntaxTree.ParseText(Imports, Modern, "imports")),
        ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!).Split(Path.PathSeparator)
            .Where(path => Path.GetFileNameWithoutExtension(path) != project).Select(path => MetadataReference.CreateFromFile(path)),
        new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary, allowUnsafe: true));

    private static (string From, string To, string What)[] Find(string project)
    {
        CSharpCompilation compilation = Compiled(project);
        return [.. from tree in compilation.SyntaxTrees
               let model = compilation.GetSemanticModel(tree)
               from expression in tree.GetRoot().DescendantNodes().OfType<ExpressionSyntax>()
               where expression is SimpleNameSyntax or BaseObjectCreationExpressionSyntax or BinaryExpressionSyntax or PrefixUnaryExpressionSyntax or ElementAccessExpressionSyntax
               let symbol = model.GetSymbolInfo(expression).Symbol?.OriginalDefinition
               where symbol is not null and not INamespaceSymbol
               let to = FileOf(symbol)
               where to != null && to != tree.FilePath
               select (tree.FilePath, to, symbol.ToDisplayString(SymbolDisplayFormat.CSharpShortErrorMessageFormat))];
    }

    /// <summary>The folder of a file; empty for one at the root.</summary>
    public static string Folder(string file) => file.Contains('/') ? file[..file.LastIndexOf('/')] : string.Empty;

    /// <summary>Folders from which arrows lead back to themselves.</summary>
    public static IEnumerable<string> Cycles(IReadOnlyCollection<(string From, string To)> arrows) =>
        arrows.Select(arrow => arrow.From).Distinct().Where(folder => Reached(folder, arrows).Contains(folder));

    private static HashSet<string> Reached(string from, IReadOnlyCollection<(string From, string To)> arrows)
    {
        HashSet<string> reached = [];
        Stack<string> next = new([from]);
        while (next.TryPop(out string? folder))
        {
            foreach ((_, string to) in arrows.Where(arrow => arrow.From == folder && reached.Add(arrow.To)))
                next.Push(to);
        }

        return reached;
    }

    // a member by itself; a type of several files by the one that has its name
    private static string? FileOf(ISymbol symbol)
    {
        ISymbol of = symbol switch
        {
            IMethodSymbol { ReducedFrom: { } whole } => whole,
            IMethodSymbol { MethodKind: MethodKind.Constructor } constructor => constructor.ContainingType,
            INamedTypeSymbol or IMethodSymbol or IPropertySymbol or IFieldSymbol => symbol,
            _ => symbol.ContainingType,
        };
        string[] files = [.. (of ?? symbol).DeclaringSyntaxReferences.Select(place => place.SyntaxTree.FilePath)];
        return files.FirstOrDefault(file => Path.GetFileNameWithoutExtension(file) == of?.Name) ?? files.FirstOrDefault();
    }
}
