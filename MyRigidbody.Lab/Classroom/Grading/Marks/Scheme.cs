using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Grading.Judging;

namespace RigidBodyDynamics.Lab.Grading.Marks;

/// <summary>How a verdict becomes a number.</summary>
/// <param name="Points">For each of the five steps that is right, or doubtful and not yet decided.</param>
/// <param name="Comments">The largest deduction for added statements without a comment: the whole where none has one.</param>
/// <param name="Name">The deduction where the submission is not named <c>学号_姓名</c>.</param>
/// <param name="Given">The deduction where the given code was changed.</param>
internal sealed record Scheme(IReadOnlyDictionary<Step, double> Points, double Comments, double Name, double Given)
{
    /// <summary>20 points a step, up to 10 deducted for comments, nothing for the rest.</summary>
    public static Scheme Default { get; } = new(Verdict.FiveSteps.ToDictionary(step => step, _ => 20.0), 10, 0, 0);

    /// <summary>The points of a submission without errors.</summary>
    public double Full => Points.Values.Sum();

    /// <summary>The points of a judgement, never below zero, in halves.</summary>
    public Marked Of(Judgement judgement, bool nameAsAsked)
    {
        double earned = Verdict.FiveSteps.Where(step => judgement.Verdict[step] is Mark.Right or Mark.Doubtful).Sum(step => Points[step]);
        double comments = judgement.Statements == 0 ? 0 : Halves(Comments * judgement.Uncommented.Count / judgement.Statements);
        double name = nameAsAsked ? 0 : Name, given = judgement.Verdict.GivenChanged ? Given : 0;
        return new Marked(earned, comments, name, given, Math.Max(0, earned - comments - name - given));
    }

    private static double Halves(double points) => Math.Round(2 * points, MidpointRounding.AwayFromZero) / 2;
}

/// <summary>Points, and their parts.</summary>
/// <param name="Steps">For the steps.</param>
/// <param name="Comments">Deducted for statements without a comment.</param>
/// <param name="Name">Deducted for the name.</param>
/// <param name="Given">Deducted for changes of the given code.</param>
/// <param name="Total">The sum, or the instructor's number.</param>
/// <param name="IsSet">True where the instructor has set it.</param>
internal sealed record Marked(double Steps, double Comments, double Name, double Given, double Total, bool IsSet = false);
