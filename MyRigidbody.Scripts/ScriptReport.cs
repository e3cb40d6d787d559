using RigidBodyDynamics.Judging;

namespace RigidBodyDynamics.StudentScripts;

/// <summary>The report on one submission.</summary>
/// <param name="Verdict">The marks and the findings, including those about the code and the name.</param>
/// <param name="Comments">The share of added statements with a comment.</param>
/// <param name="File">The judged file; null where no script was found.</param>
/// <param name="Text">Its text; empty where there is none.</param>
/// <param name="Lines">The line of each step that can be found, from 1.</param>
/// <param name="Recording">Its recording; null where it was not run to its end.</param>
public sealed record ScriptReport(Verdict Verdict, CommentCoverage Comments, string? File, string Text, IReadOnlyDictionary<Step, int> Lines, Recording? Recording);

/// <summary>Statements that were added to the starter, and how many of them have a comment.</summary>
/// <param name="Statements">Statements added or changed.</param>
/// <param name="Commented">Those with words of a comment on their line or above it.</param>
/// <param name="Bare">The lines of the others, from 1.</param>
public sealed record CommentCoverage(int Statements, int Commented, IReadOnlyList<int> Bare)
{
    /// <summary>For a script that could not be read.</summary>
    public static CommentCoverage None { get; } = new(0, 0, []);
}
