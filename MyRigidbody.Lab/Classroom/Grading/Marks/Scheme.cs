using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Grading.Judging;

namespace RigidBodyDynamics.Lab.Grading.Marks;

/// <summary>How a verdict becomes a number.</summary>
/// <param name="Points">For each of the five steps that is right, or doubtful and not yet settled.</param>
/// <param name="Comments">At most taken off where added statements have no comment: all of it where none has.</param>
/// <param name="Name">Taken off where the submission is not called <c>学号_姓名</c>.</param>
/// <param name="Given">Taken off where the given code was changed.</param>
internal sealed record Scheme(IReadOnlyDictionary<Step, double> Points, double Comments, double Name, double Given)
{
    /// <summary>20 points a step, 10 off for comments, nothing for the rest.</summary>
    public static Scheme Default { get; } = new(Verdict.FiveSteps.ToDictionary(step => step, _ => 20.0), 10, 0, 0);

    /// <summary>What a submission without fault gets.</summary>
    public double Full => Points.Values.Sum();

    /// <summary>The points of a judgement, never below zero; halves, because nobody measures finer.</summary>
    public Marked Of(Judgement judgement, bool nameAsAsked)
    {
        double earned = Verdict.FiveSteps.Where(step => judgement.Verdict[step] is Mark.Right or Mark.Doubtful).Sum(step => Points[step]);
        double comments = judgement.Statements == 0 ? 0 : Halves(Comments * judgement.Uncommented.Count / judgement.Statements);
        double name = nameAsAsked ? 0 : Name, given = judgement.Verdict.GivenChanged ? Given : 0;
        return new Marked(earned, comments, name, given, Math.Max(0, earned - comments - name - given));
    }

    private static double Halves(double points) => Math.Round(2 * points, MidpointRounding.AwayFromZero) / 2;
}

/// <summary>Points, and what they are made of.</summary>
/// <param name="Steps">For the steps.</param>
/// <param name="Comments">Taken off for statements without comment.</param>
/// <param name="Name">Taken off for the name.</param>
/// <param name="Given">Taken off for changes of the given code.</param>
/// <param name="Total">What is left, or what the instructor has set.</param>
/// <param name="IsSet">True where the instructor has set it.</param>
internal sealed record Marked(double Steps, double Comments, double Name, double Given, double Total, bool IsSet = false);
