using Microsoft.CodeAnalysis;
using RigidBodyDynamics.Judging;

namespace RigidBodyDynamics.StudentScripts.Compilation;

/// <summary>A part of a script that prevents running it, and its place.</summary>
internal sealed record Objection(Finding Finding, Location Place)
{
    /// <summary>The finding with its line.</summary>
    public static Objection At(Location place, Finding finding) => new(finding.At(ScriptCompiler.LineOf(place)), place);
}
