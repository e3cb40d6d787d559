using System.Collections.Immutable;
using System.Reflection;
using System.Text;
using System.Text.Json;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using RigidBodyDynamics.Lab.Package;
using RigidBodyDynamics.Tests.Repository;

namespace RigidBodyDynamics.Tests.Package;

/// <summary>
/// Compiles the assets of a package as an editor would: an assembly for every asmdef, of the files below it, with the
/// references that it names and nothing else; C# 7.3, against .NET Standard 2.0 and a stand-in for the engine.
/// </summary>
internal sealed class UnityCompiler
{
    private static readonly ImmutableArray<MetadataReference> Standard =
        [.. Directory.EnumerateFiles(NetStandard(), "*.dll").Select(path => (MetadataReference)MetadataReference.CreateFromFile(path))];

    private readonly Dictionary<string, JsonElement> _definitions = [];
    private readonly Dictionary<string, string> _folders = [];
    private readonly Dictionary<string, CompilationReference> _compiled = [];
    private readonly IReadOnlyList<Asset> _assets;
    private readonly CSharpParseOptions _options;
    private readonly MetadataReference? _engine;

    /// <summary>Compiles with the symbols of a version.</summary>
    public UnityCompiler(IReadOnlyList<Asset> assets, params string[] symbols)
    {
        _assets = assets;
        _options = new CSharpParseOptions(LanguageVersion.CSharp7_3, preprocessorSymbols: symbols);
        foreach (Asset asset in assets.Where(asset => asset.Path.EndsWith(".asmdef", StringComparison.Ordinal)))
        {
            JsonElement definition = JsonDocument.Parse(asset.Content).RootElement;
            string name = definition.GetProperty("name").GetString()!;
            _folders.Add(name, asset.Path[..(asset.Path.LastIndexOf('/') + 1)]);
            // every package that an asmdef asks the version of is there where its symbol of Unity's is
            IEnumerable<string> versions = definition.GetProperty("versionDefines").EnumerateArray().Select(define => define.GetProperty("define").GetString()!);
            if (definition.GetProperty("defineConstraints").EnumerateArray().Any(symbol => !symbols.Concat(versions).Contains(symbol.GetString())))
                continue;

            _definitions.Add(name, definition);
        }

        _engine = Stub("UnityEngine", "MyRigidbody.Engine/UnityEngine", "tests/UnityStubs/Editor");
        _compiled.Add("Unity.InputSystem", Stub("Unity.InputSystem", "tests/UnityStubs/InputSystem"));
    }

    /// <summary>The names of the assemblies.</summary>
    public IEnumerable<string> Assemblies => _definitions.Keys;

    /// <summary>Scripts outside every asmdef, which belong to the student's own assembly.</summary>
    public IEnumerable<string> Homeless => Scripts().Where(path => Owner(path) == null);

    /// <summary>The compiler's errors and warnings for an assembly.</summary>
    public IEnumerable<string> Complaints(string assembly) =>
        Compile(assembly).Compilation.GetDiagnostics().Where(found => found.Severity >= DiagnosticSeverity.Warning).Select(found => found.ToString());

    /// <summary>The compiler's errors and warnings for the student's own assembly.</summary>
    public IEnumerable<string> ComplaintsOfStudents() => Students().GetDiagnostics().Where(found => found.Severity >= DiagnosticSeverity.Warning).Select(found => found.ToString());

    /// <summary>The members of the engine and the editor that all of it names, as Type.Member; types alone where only they are named.</summary>
    public IEnumerable<string> EngineMembers()
    {
        IEnumerable<Compilation> compilations = [.. Assemblies.Select(name => Compile(name).Compilation), Students()];
        return compilations.SelectMany(compilation => compilation.SyntaxTrees.SelectMany(tree =>
        {
            SemanticModel model = compilation.GetSemanticModel(tree);
            return tree.GetRoot().DescendantNodes().OfType<SimpleNameSyntax>().Select(name => model.GetSymbolInfo(name).Symbol).OfType<ISymbol>();
        })).Select(Named).OfType<string>();
    }

    private static string? Named(ISymbol symbol)
    {
        ISymbol original = symbol is IMethodSymbol { MethodKind: MethodKind.Constructor } ? symbol.ContainingType : symbol.OriginalDefinition;
        INamedTypeSymbol? type = original as INamedTypeSymbol ?? original.ContainingType;
        string? space = type?.ContainingNamespace.ToDisplayString();
        if (space is null || !(space.StartsWith("UnityEngine", StringComparison.Ordinal) || space.StartsWith("UnityEditor", StringComparison.Ordinal)))
            return null;

        string named = type!.ToDisplayString().Split('<')[0];
        return original is INamedTypeSymbol ? named : named + "." + original.Name;
    }

    // it refers to every assembly of the game that does not forbid it
    private CSharpCompilation Students() => Compilation(
        "Assembly-CSharp",
        _assets.Where(asset => Homeless.Contains(asset.Path)),
        [.. Standard, _engine!, .. _definitions.Where(definition => IsForTheGame(definition.Value)).Select(definition => Compile(definition.Key))]);

    private static bool IsForTheGame(JsonElement definition) =>
        definition.GetProperty("autoReferenced").GetBoolean() && definition.GetProperty("includePlatforms").GetArrayLength() == 0;

    private CompilationReference Compile(string assembly)
    {
        if (_compiled.TryGetValue(assembly, out CompilationReference? done))
            return done;

        JsonElement definition = _definitions[assembly];
        List<MetadataReference> references = [.. Standard];
        references.AddRange(definition.GetProperty("references").EnumerateArray().Select(reference => Compile(reference.GetString()!)));
        if (!definition.GetProperty("noEngineReferences").GetBoolean())
            references.Add(_engine!);

        IEnumerable<Asset> scripts = _assets.Where(asset => asset.Path.EndsWith(".cs", StringComparison.Ordinal) && Owner(asset.Path) == assembly);
        return _compiled[assembly] = (CompilationReference)Compilation(assembly, scripts, references).ToMetadataReference();
    }

    private CSharpCompilation Compilation(string assembly, IEnumerable<Asset> scripts, IEnumerable<MetadataReference> references) => CSharpCompilation.Create(
        assembly,
        scripts.Select(script => CSharpSyntaxTree.ParseText(Encoding.UTF8.GetString(script.Content!), _options, script.Path)),
        references,
        new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary));

    // only the signatures of the stand-in are needed, so what its bodies call may be missing; its own projects compile those
    private CompilationReference Stub(string name, params string[] folders) => (CompilationReference)CSharpCompilation.Create(
        name,
        folders.SelectMany(folder => Tree.Files(folder, "*.cs"))
            .Select(path => CSharpSyntaxTree.ParseText(Tree.Text(path), _options, path)),
        [.. Standard, .. _engine == null ? Array.Empty<MetadataReference>() : [_engine]],
        new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary)).ToMetadataReference();

    private IEnumerable<string> Scripts() => _assets.Select(asset => asset.Path).Where(path => path.EndsWith(".cs", StringComparison.Ordinal));

    // the asmdef in the nearest folder above
    private string? Owner(string path) => _folders.Where(folder => path.StartsWith(folder.Value, StringComparison.Ordinal))
        .OrderByDescending(folder => folder.Value.Length).Select(folder => folder.Key).FirstOrDefault();

    private static string NetStandard() => typeof(UnityCompiler).Assembly.GetCustomAttributes<AssemblyMetadataAttribute>()
        .Single(data => data.Key == "NetStandard").Value!;
}
