using Microsoft.CodeAnalysis.CSharp;
using RigidBodyDynamics.Judging;

namespace RigidBodyDynamics.StudentScripts.Compilation;

/// <summary>A script that the compiler has read.</summary>
/// <param name="Sources">Where it comes from.</param>
/// <param name="Compilation">What the compiler knows of it.</param>
/// <param name="Objections">What keeps it from being run, in the order of the places; empty where nothing does.</param>
/// <param name="IsForbidden">They are about what it reaches for; else about what does not compile.</param>
/// <param name="Notes">What else is to be said of it.</param>
internal sealed record CheckedScript(Sources Sources, CSharpCompilation Compilation, IReadOnlyList<Objection> Objections, bool IsForbidden, IReadOnlyList<Finding> Notes);

/// <summary>A script that was looked at.</summary>
/// <param name="Sources">Where it comes from.</param>
/// <param name="Refusals">Why it is not run; empty where it may be.</param>
/// <param name="Notes">What else is to be said of it.</param>
/// <param name="Assembly">What is run.</param>
/// <param name="DebugSymbols">From its code to the lines.</param>
internal sealed record CompiledScript(Sources Sources, IReadOnlyList<Finding> Refusals, IReadOnlyList<Finding> Notes, byte[]? Assembly, byte[]? DebugSymbols)
{
    public string ClassName => Sources.Script!.Identifier.ValueText;

    /// <summary>Variables that are not each object's own: the assembly is loaded anew for every object.</summary>
    public bool HasStatics => Assembly != null && Sources.Trees.Any(Statics.AreIn);
}
