using Microsoft.CodeAnalysis.CSharp;
using RigidBodyDynamics.Judging;

namespace RigidBodyDynamics.StudentScripts.Compilation;

/// <summary>A script that the compiler has checked.</summary>
/// <param name="Sources">Its sources.</param>
/// <param name="Compilation">The compiler's result.</param>
/// <param name="Objections">What prevents running it, in the order of the places; empty where nothing does.</param>
/// <param name="IsForbidden">True if they are about what it uses; false if about compiler errors.</param>
/// <param name="Notes">Other findings.</param>
internal sealed record CheckedScript(Sources Sources, CSharpCompilation Compilation, IReadOnlyList<Objection> Objections, bool IsForbidden, IReadOnlyList<Finding> Notes);

/// <summary>A script ready to run, or refused.</summary>
/// <param name="Sources">Its sources.</param>
/// <param name="Refusals">Why it is not run; empty where it may be.</param>
/// <param name="Notes">Other findings.</param>
/// <param name="Assembly">The code to run.</param>
/// <param name="DebugSymbols">The lines of the code.</param>
internal sealed record CompiledScript(Sources Sources, IReadOnlyList<Finding> Refusals, IReadOnlyList<Finding> Notes, byte[]? Assembly, byte[]? DebugSymbols)
{
    public string ClassName => Sources.Script!.Identifier.ValueText;

    /// <summary>True if it has static variables: the assembly is then loaded anew for every object.</summary>
    public bool HasStatics => Assembly != null && Sources.Trees.Any(Statics.AreIn);
}
