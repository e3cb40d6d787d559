using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using Microsoft.CodeAnalysis.Emit;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.StudentScripts.Metering;

namespace RigidBodyDynamics.StudentScripts.Compilation;

/// <summary>Checks the files of a submission, and compiles them to an assembly if nothing prevents running it.</summary>
internal static class ScriptCompiler
{
    /// <summary>The path of the file that is given with the lab and not part of a submission.</summary>
    public const string Given = "DefaultRigidbody.cs (given)";

    // later errors mostly follow from the first one
    private const int MostErrors = 3;

    private const string DefaultRigidbody =
        "public class DefaultRigidbody : UnityEngine.MonoBehaviour { public UnityEngine.Rigidbody rb; public UnityEngine.Vector3 force, torque; }";

    // not optimised: a tail call stays a call, so that endless recursion fills the stack and is detected
    private static readonly CSharpCompilationOptions Options = new(
        OutputKind.DynamicallyLinkedLibrary, optimizationLevel: OptimizationLevel.Debug, concurrentBuild: false, deterministic: true, nullableContextOptions: NullableContextOptions.Disable);

    /// <summary>The checked script of a submission; null, with the reason, where there is none.</summary>
    public static CheckedScript? Read(IReadOnlyList<ScriptFile> files, out Finding? noScript)
    {
        (Sources? sources, string? tooLarge) = Sources.Read(files);
        noScript = tooLarge != null ? Words.TooLarge(tooLarge) : sources!.Script == null ? Words.NoScript() : null;
        return noScript == null ? Check(sources!) : null;
    }

    /// <summary>The checked script; nothing that could run is generated yet.</summary>
    private static CheckedScript Check(Sources sources)
    {
        CSharpCompilation compilation = WithoutVainUsings(Create(sources.Trees));
        List<Finding> notes = [.. compilation.SyntaxTrees.SelectMany(HiddenCode.Of)];
        if (sources.Script!.Identifier.ValueText is var name && name != Sources.ClassName)
            notes.Add(Words.ClassName(name).At(LineOf(sources.Script.Identifier.GetLocation())));
        if (sources.Others.Count > 0)
            notes.Add(Words.TwoScripts(sources.Others));

        List<Objection> objections = [.. compilation.SyntaxTrees.Where(tree => tree.FilePath != Given).SelectMany(tree => Inspector.Look(compilation, tree))];
        bool isForbidden = objections.Count > 0;
        if (!isForbidden)
            objections.AddRange(CompileErrors.Of(compilation));

        return new CheckedScript(sources, compilation, objections, isForbidden, notes);
    }

    /// <summary>The script with its meter, to be run unless something prevents it.</summary>
    public static CompiledScript Compile(CheckedScript read)
    {
        if (read.Objections.Count > 0)
            return Refused(read, read.Objections, read.IsForbidden ? int.MaxValue : MostErrors);

        using MemoryStream assembly = new(), symbols = new();
        EmitResult result = Metered(read.Compilation).Emit(assembly, symbols, options: new EmitOptions(debugInformationFormat: DebugInformationFormat.PortablePdb));
        return result.Success
            ? new CompiledScript(read.Sources, [], read.Notes, assembly.ToArray(), symbols.ToArray())
            : Refused(read, CompileErrors.Of(result.Diagnostics), MostErrors);
    }

    /// <summary>The line of a place, from 1.</summary>
    public static int LineOf(Location place) => place.GetLineSpan().StartLinePosition.Line + 1;

    private static CompiledScript Refused(CheckedScript read, IEnumerable<Objection> objections, int most) =>
        new(read.Sources, [.. objections.Take(most).Select(objection => objection.Finding)], read.Notes, null, null);

    private static CSharpCompilation Create(IReadOnlyList<SyntaxTree> trees)
    {
        bool isNamed = trees.Any(tree => tree.GetRoot().DescendantTokens().Any(token => token.ValueText == "DefaultRigidbody"));
        bool isThere = trees.Any(tree => tree.GetRoot().DescendantNodes().OfType<ClassDeclarationSyntax>().Any(type => type.Identifier.ValueText == "DefaultRigidbody"));
        IEnumerable<SyntaxTree> given = isNamed && !isThere ? [CSharpSyntaxTree.ParseText(DefaultRigidbody, Symbols.OfTheEditor, Given, System.Text.Encoding.UTF8)] : [];
        return CSharpCompilation.Create("Script" + Guid.NewGuid().ToString("N"), [.. trees, .. given], References.OfScripts, Options);
    }

    // an editor adds usings by itself; unknown ones are removed
    private static CSharpCompilation WithoutVainUsings(CSharpCompilation compilation)
    {
        foreach (SyntaxTree tree in compilation.SyntaxTrees)
        {
            SemanticModel model = compilation.GetSemanticModel(tree);
            UsingDirectiveSyntax[] vain = [.. tree.GetRoot().DescendantNodes().OfType<UsingDirectiveSyntax>()
                .Where(directive => directive.Name != null && model.GetSymbolInfo(directive.Name).Symbol == null)];
            if (vain.Length > 0)
            {
                SyntaxNode without = tree.GetRoot().ReplaceNodes(vain, (directive, _) => Blank(directive));
                compilation = compilation.ReplaceSyntaxTree(tree, CSharpSyntaxTree.ParseText(without.ToFullString(), Symbols.OfTheEditor, tree.FilePath, System.Text.Encoding.UTF8));
            }
        }

        return compilation;
    }

    // the same length and the same lines: a using that always exists
    private static SyntaxNode Blank(UsingDirectiveSyntax directive) =>
        SyntaxFactory.UsingDirective(SyntaxFactory.ParseName("System").WithLeadingTrivia(SyntaxFactory.Space)).WithTriviaFrom(directive);

    private static CSharpCompilation Metered(CSharpCompilation compilation)
    {
        CSharpCompilation metered = compilation.WithReferences(References.OfMeteredScripts);
        foreach (SyntaxTree tree in compilation.SyntaxTrees)
        {
            SyntaxNode root = Named(new MeterRewriter(compilation.GetSemanticModel(tree)).Visit(tree.GetRoot()), tree.FilePath);
            metered = metered.ReplaceSyntaxTree(tree, CSharpSyntaxTree.Create((CSharpSyntaxNode)root, Symbols.OfTheEditor, encoding: System.Text.Encoding.UTF8));
        }

        return metered;
    }

    /// <summary>
    /// Gives the debug symbols a file name and a dummy checksum. For a file without one they compute it on another thread, and wait
    /// for it; a browser has no other thread.
    /// </summary>
    private static SyntaxNode Named(SyntaxNode root, string path)
    {
        string file = string.Concat(path.Where(letter => letter >= ' ' && letter != '"'));
        SyntaxTriviaList names = SyntaxFactory.ParseLeadingTrivia($"#pragma checksum \"{file}\" \"{{8829d00f-11b8-4213-878b-770e8597ac16}}\" \"00\"\n#line 1 \"{file}\"\n");
        return root.WithLeadingTrivia(names.AddRange(root.GetLeadingTrivia()));
    }
}
