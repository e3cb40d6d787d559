using RigidBodyDynamics.Lab.Languages;

namespace RigidBodyDynamics.Lab.Report;

/// <summary>How far our simulation is from a recorded body.</summary>
/// <param name="Lead">Whether it repeats the recording, or where they part.</param>
/// <param name="Verdict">Whether that is within the tolerance, and what both are.</param>
/// <param name="Rows">What, and the largest difference in it.</param>
internal sealed record RecordingTable(Word Lead, Word Verdict, IReadOnlyList<RecordingTable.Row> Rows) : Section
{
    /// <inheritdoc/>
    public override string Kind => "recording";

    /// <summary>The largest difference in one thing.</summary>
    internal sealed record Row(Word What, string Largest);
}
