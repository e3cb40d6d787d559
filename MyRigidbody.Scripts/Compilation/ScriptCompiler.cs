using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using Microsoft.CodeAnalysis.Emit;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.StudentScripts.Metering;

namespace RigidBodyDynamics.StudentScripts.Compilation;

/// <summary>From the files of a submission to an assembly that may be run, or to what stands against that.</summary>
internal static class ScriptCompiler
{
    /// <summary>The path of what is handed out with the lab and not handed in again.</summary>
    public const string Given = "DefaultRigidbody.cs (given)";

    private const string DefaultRigidbody =
        "public class DefaultRigidbody : UnityEngine.MonoBehaviour { public UnityEngine.Rigidbody rb; public UnityEngine.Vector3 force, torque; }";

    // not optimised: a call that ends a method stays a call, so that one without end fills the stack and is seen
    private static readonly CSharpCompilationOptions Options = new(
        OutputKind.DynamicallyLinkedLibrary, optimizationLevel: OptimizationLevel.Debug, concurrentBuild: false, deterministic: true, nullableContextOptions: NullableContextOptions.Disable);

    public static CompiledScript Compile(Sources sources)
    {
        CSharpCompilation compilation = WithoutVainUsings(Create(sources.Trees));
        List<Finding> notes = [.. compilation.SyntaxTrees.SelectMany(HiddenCode.Of)];
        if (sources.Script!.Identifier.ValueText is var name && name != Sources.ClassName)
            notes.Add(Words.ClassName(name).At(LineOf(sources.Script.Identifier.GetLocation())));
        if (sources.Others.Count > 0)
            notes.Add(Words.TwoScripts(sources.Others));

        List<Finding> refusals = [.. compilation.SyntaxTrees.Where(tree => tree.FilePath != Given).SelectMany(tree => Inspector.Look(compilation, tree))];
        if (refusals.Count == 0)
            refusals.AddRange(CompileErrors.Of(compilation));
        if (refusals.Count > 0)
            return new CompiledScript(sources, refusals, notes, null, null);

        using MemoryStream assembly = new(), symbols = new();
        EmitResult result = Metered(compilation).Emit(assembly, symbols, options: new EmitOptions(debugInformationFormat: DebugInformationFormat.PortablePdb));
        return result.Success
            ? new CompiledScript(sources, [], notes, assembly.ToArray(), symbols.ToArray())
            : new CompiledScript(sources, CompileErrors.Of(result.Diagnostics), notes, null, null);
    }

    /// <summary>The line of a place, from 1.</summary>
    public static int LineOf(Location place) => place.GetLineSpan().StartLinePosition.Line + 1;

    private static CSharpCompilation Create(IReadOnlyList<SyntaxTree> trees)
    {
        bool isNamed = trees.Any(tree => tree.GetRoot().DescendantTokens().Any(token => token.ValueText == "DefaultRigidbody"));
        bool isThere = trees.Any(tree => tree.GetRoot().DescendantNodes().OfType<ClassDeclarationSyntax>().Any(type => type.Identifier.ValueText == "DefaultRigidbody"));
        IEnumerable<SyntaxTree> given = isNamed && !isThere ? [CSharpSyntaxTree.ParseText(DefaultRigidbody, Symbols.OfTheEditor, Given, System.Text.Encoding.UTF8)] : [];
        return CSharpCompilation.Create("Script" + Guid.NewGuid().ToString("N"), [.. trees, .. given], References.OfScripts, Options);
    }

    // an editor adds usings by itself; those that nothing here knows are as good as none
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

    // the same length and the same lines: a using of what is always there
    private static SyntaxNode Blank(UsingDirectiveSyntax directive) =>
        SyntaxFactory.UsingDirective(SyntaxFactory.ParseName("System").WithLeadingTrivia(SyntaxFactory.Space)).WithTriviaFrom(directive);

    private static CSharpCompilation Metered(CSharpCompilation compilation)
    {
        CSharpCompilation metered = compilation.WithReferences(References.OfMeteredScripts);
        foreach (SyntaxTree tree in compilation.SyntaxTrees)
        {
            SyntaxNode root = new MeterRewriter(compilation.GetSemanticModel(tree)).Visit(tree.GetRoot());
            metered = metered.ReplaceSyntaxTree(tree, CSharpSyntaxTree.Create((CSharpSyntaxNode)root, Symbols.OfTheEditor, tree.FilePath, System.Text.Encoding.UTF8));
        }

        return metered;
    }
}
