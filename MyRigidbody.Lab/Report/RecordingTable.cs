using RigidBodyDynamics.Lab.Languages;

namespace RigidBodyDynamics.Lab.Report;

/// <summary>The difference between our simulation and a recorded body.</summary>
/// <param name="Lead">Whether it repeats the recording, or the first difference.</param>
/// <param name="Verdict">Whether that is within the tolerance, with both numbers.</param>
/// <param name="Rows">The largest difference of each quantity.</param>
internal sealed record RecordingTable(Word Lead, Word Verdict, IReadOnlyList<RecordingTable.Row> Rows) : Section
{
    /// <inheritdoc/>
    public override string Kind => "recording";

    /// <summary>The largest difference of one quantity.</summary>
    internal sealed record Row(Word What, string Largest);
}
