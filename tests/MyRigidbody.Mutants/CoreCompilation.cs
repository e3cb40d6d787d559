using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.Text;

namespace RigidBodyDynamics.Mutants;

/// <summary>
/// The whole Core, compiled in memory; a mutant replaces the text of one tree. So a constant, a default value and a table
/// made when its type is first used change like any other code, and nothing is slower than what is shipped.
/// </summary>
internal sealed class CoreCompilation
{
    private readonly CSharpCompilation _whole;
    private readonly Dictionary<string, SyntaxTree> _trees = [];
    private readonly byte[] _unchanged;

    public CoreCompilation(string core)
    {
        CSharpParseOptions asUnity = new(LanguageVersion.CSharp7_3, DocumentationMode.None, preprocessorSymbols: ["NET", "NET10_0"]);
        foreach (string path in Directory.EnumerateFiles(core, "*.cs", SearchOption.AllDirectories).Order(StringComparer.Ordinal))
        {
            string file = Path.GetRelativePath(core, path).Replace('\\', '/');
            // folders of that ending are for Unity's package manager alone
            if (file.Contains("~/", StringComparison.Ordinal))
                continue;

            _trees.Add(file, CSharpSyntaxTree.ParseText(SourceText.From(File.ReadAllText(path)), asUnity, file));
        }

        // the tests, and what they load
        string friends = string.Concat(new[] { "Tests", "Lab", "Engine" }
            .Select(name => $"[assembly: System.Runtime.CompilerServices.InternalsVisibleTo(\"MyRigidbody.{name}\")]"));
        IEnumerable<MetadataReference> runtime = ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!)
            .Split(Path.PathSeparator)
            .Where(path => Path.GetFileName(path).StartsWith("System.", StringComparison.Ordinal) || Path.GetFileName(path) == "netstandard.dll")
            .Select(path => MetadataReference.CreateFromFile(path));
        _whole = CSharpCompilation.Create(
            "MyRigidbody.Core",
            [.. _trees.Values, CSharpSyntaxTree.ParseText(friends, asUnity)],
            runtime,
            new CSharpCompilationOptions(
                OutputKind.DynamicallyLinkedLibrary,
                optimizationLevel: OptimizationLevel.Release,
                allowUnsafe: true, // the Core's SkipLocalsInit asks for it
                deterministic: true,
                concurrentBuild: false));
        _unchanged = Compile(_whole) ?? throw new InvalidOperationException("the Core does not compile: " + Errors(_whole));
    }

    /// <summary>The files of some folders.</summary>
    public IEnumerable<SyntaxTree> Trees(IReadOnlyCollection<string> folders) =>
        _trees.Where(pair => folders.Contains(pair.Key.Split('/')[0])).Select(pair => pair.Value);

    /// <summary>What the names in a file stand for.</summary>
    public SemanticModel Meaning(SyntaxTree tree) => _whole.GetSemanticModel(tree);

    /// <summary>The assembly with one mutant in it; nothing where the compiler refuses it or makes the same code of it.</summary>
    public byte[]? With(Mutant mutant)
    {
        SyntaxTree tree = _trees[mutant.File];
        SourceText text = tree.GetText().WithChanges(new TextChange(mutant.Span, mutant.Replacement));
        byte[]? image = Compile(_whole.ReplaceSyntaxTree(tree, tree.WithChangedText(text)));
        return image != null && image.AsSpan().SequenceEqual(_unchanged) ? null : image;
    }

    /// <summary>The assembly with many changes that change nothing it computes, and a file more.</summary>
    public byte[] With(IReadOnlyDictionary<string, List<TextChange>> changes, string more)
    {
        CSharpCompilation all = _whole;
        foreach ((string file, List<TextChange> inFile) in changes)
        {
            SyntaxTree tree = _trees[file];
            all = all.ReplaceSyntaxTree(tree, tree.WithChangedText(tree.GetText().WithChanges(inFile)));
        }

        all = all.AddSyntaxTrees(CSharpSyntaxTree.ParseText(more, (CSharpParseOptions)_trees.Values.First().Options));
        return Compile(all) ?? throw new InvalidOperationException("the marked Core does not compile: " + Errors(all));
    }

    private static byte[]? Compile(CSharpCompilation compilation)
    {
        using MemoryStream image = new();
        return compilation.Emit(image).Success ? image.ToArray() : null;
    }

    private static string Errors(CSharpCompilation compilation) =>
        string.Join('\n', compilation.GetDiagnostics().Where(found => found.Severity == DiagnosticSeverity.Error).Take(5));
}
