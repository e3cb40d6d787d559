using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Grading.Students;

namespace RigidBodyDynamics.Lab.Grading.Reading;

/// <summary>One submission of one student.</summary>
/// <param name="Spot">Its place.</param>
/// <param name="Student">The student; null where no name can be read.</param>
/// <param name="NameAsAsked">True where it is named <c>学号_姓名</c>.</param>
/// <param name="Scripts">All scripts in it.</param>
/// <param name="Problem">Why it could not be read; null if it was.</param>
/// <param name="Notes">Problems that did not prevent reading.</param>
internal sealed record Submission(
    Spot Spot, Student? Student, bool NameAsAsked, IReadOnlyList<Script> Scripts, Finding? Problem, IReadOnlyList<Finding> Notes);
