using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Grading.Students;

namespace RigidBodyDynamics.Lab.Grading.Reading;

/// <summary>What one student has handed in as one thing.</summary>
/// <param name="Spot">Where it is.</param>
/// <param name="Student">Whose it is; null where no name can be read.</param>
/// <param name="NameAsAsked">True where it is called <c>学号_姓名</c>.</param>
/// <param name="Scripts">All scripts in it.</param>
/// <param name="Problem">Why it could not be read; null if it was.</param>
/// <param name="Notes">What was read all the same, but is not as it should be.</param>
internal sealed record Submission(
    Spot Spot, Student? Student, bool NameAsAsked, IReadOnlyList<Script> Scripts, Finding? Problem, IReadOnlyList<Finding> Notes);
