using System.Security.Cryptography;
using System.Text;
using RigidBodyDynamics.Lab.Grading.Judging;
using RigidBodyDynamics.Lab.Grading.Marks;
using RigidBodyDynamics.Lab.Grading.Reading;
using RigidBodyDynamics.Lab.Grading.Students;

namespace RigidBodyDynamics.Lab.Grading;

/// <summary>A submission with its results.</summary>
/// <param name="Submission">The submission.</param>
/// <param name="Student">The student, as read or as decided; null where unknown.</param>
/// <param name="Measured">The judgement.</param>
/// <param name="Judgement">The same with the instructor's decisions.</param>
/// <param name="Marked">Its points.</param>
/// <param name="Decision">The instructor's decision; null where there is none.</param>
internal sealed record Graded(Submission Submission, Student? Student, Judgement Measured, Judgement Judgement, Marked Marked, Decision? Decision)
{
    /// <summary>Its name in <c>grade.json</c> and in decisions.</summary>
    public string File => Measured.File ?? Submission.Spot.Shown;

    /// <summary>A hash of the judged script, so that a decision does not apply to a script that is submitted later.</summary>
    public string Content => Convert.ToHexStringLower(SHA256.HashData(
        Encoding.UTF8.GetBytes(string.Join('\n', Measured.Candidates.Select(one => one.Text).Append(Measured.Text))))).Substring(0, 8);

    /// <summary>True for the submission that gives its student's marks.</summary>
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
/// <param name="Share">The shared part, from 0 to 1.</param>
internal sealed record Alike(string File, double Share);
