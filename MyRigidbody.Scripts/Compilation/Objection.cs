using Microsoft.CodeAnalysis;
using RigidBodyDynamics.Judging;

namespace RigidBodyDynamics.StudentScripts.Compilation;

/// <summary>Something in a script that keeps it from being run, and the place of it.</summary>
internal sealed record Objection(Finding Finding, Location Place)
{
    /// <summary>With the line of the place.</summary>
    public static Objection At(Location place, Finding finding) => new(finding.At(ScriptCompiler.LineOf(place)), place);
}
