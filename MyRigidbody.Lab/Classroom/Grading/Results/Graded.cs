using System.Security.Cryptography;
using System.Text;
using RigidBodyDynamics.Lab.Grading.Judging;
using RigidBodyDynamics.Lab.Grading.Marks;
using RigidBodyDynamics.Lab.Grading.Reading;
using RigidBodyDynamics.Lab.Grading.Students;

namespace RigidBodyDynamics.Lab.Grading;

/// <summary>A submission with all that is said of it.</summary>
/// <param name="Submission">What was handed in.</param>
/// <param name="Student">Whose it is, as read or as settled; null where nobody knows.</param>
/// <param name="Measured">What was found out.</param>
/// <param name="Judgement">The same with what the instructor has settled.</param>
/// <param name="Marked">Its points.</param>
/// <param name="Decision">What the instructor has settled; null where nothing was.</param>
internal sealed record Graded(Submission Submission, Student? Student, Judgement Measured, Judgement Judgement, Marked Marked, Decision? Decision)
{
    /// <summary>How <c>grade.json</c> and decisions call it.</summary>
    public string File => Measured.File ?? Submission.Spot.Shown;

    /// <summary>A fingerprint of what was judged, so that a decision is not taken for a script that is handed in later.</summary>
    public string Content => Convert.ToHexStringLower(SHA256.HashData(
        Encoding.UTF8.GetBytes(string.Join('\n', Measured.Candidates.Select(one => one.Text).Append(Measured.Text))))).Substring(0, 8);

    /// <summary>True where this is the submission of its student that gives the marks.</summary>
    public bool Counts { get; init; } = true;

    /// <summary>True where an earlier decision was about another script.</summary>
    public bool IsDecisionOld { get; init; }

    /// <summary>The file of the student's page, below <c>students/</c>.</summary>
    public string Page { get; init; } = string.Empty;

    /// <summary>Scripts that have much in common with it.</summary>
    public IReadOnlyList<Alike> Alike { get; init; } = [];
}

/// <summary>Another script that shares much with one.</summary>
/// <param name="File">Its file.</param>
/// <param name="Share">How much, from 0 to 1.</param>
internal sealed record Alike(string File, double Share);
