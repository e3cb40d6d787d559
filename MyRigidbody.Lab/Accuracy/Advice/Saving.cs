namespace RigidBodyDynamics.Lab;

/// <summary>A part left out of a body's motion, and the time that this saves.</summary>
/// <param name="Omission">The part, and the reason.</param>
/// <param name="Without">Time of a step without it, ns; NaN where it was not measured.</param>
/// <param name="With">Time of a step with it, ns; NaN where there is nothing to put back, or it was not measured.</param>
internal sealed record Saving(Omission Omission, double Without, double With)
{
    private const int Turns = 12;
    private const double SecondsPerTurn = 0.004;

    /// <summary>Not below zero: a part that is not computed cannot cost time, so a negative value is an error of measurement.</summary>
    public double Nanoseconds => Math.Max(0, With - Without);

    /// <summary>The parts left out, without the time that this saves.</summary>
    public static IReadOnlyList<Saving> NotMeasured(IReadOnlyList<Omission> leftOut) =>
        [.. leftOut.Select(omission => new Saving(omission, double.NaN, double.NaN))];

    /// <summary>Times a body without the parts, and with each of them put back, alternately.</summary>
    /// <param name="plan">The body.</param>
    /// <param name="leftOut">What is left out.</param>
    /// <param name="report">Receives the finished fraction.</param>
    public static IReadOnlyList<Saving> Measure(BodyPlan plan, IReadOnlyList<Omission> leftOut, Action<double> report)
    {
        // takes every step, because those steps are what a body that coasts saves
        (SceneDescription Scene, Omissions MayLeaveOut)[] runs =
        [
            (Alone(plan.Asked, plan), Omissions.All & ~Omissions.Coasting),
            (Alone(plan.Asked, plan), Omissions.All),
            .. leftOut.Select(omission => (Alone(omission.With ?? plan.Asked, plan), omission.MayLeaveOut)),
        ];
        double[] least = new double[runs.Length];
        for (int turn = 0; turn <= Turns; turn++)
        {
            for (int i = 0; i < runs.Length; i++)
            {
                double time = StepClock.Nanoseconds(runs[i].Scene, runs[i].MayLeaveOut, SecondsPerTurn);
                least[i] = turn < 2 ? time : Math.Min(least[i], time);
            }

            report((turn + 1.0) / (Turns + 1));
        }

        return [.. leftOut.Select((omission, i) => omission.With is null
            ? new Saving(omission, least[0], double.NaN)
            : omission.With == plan.Asked && (plan.LeftOut & ~omission.MayLeaveOut) == 0
                ? new Saving(omission, least[1], least[0])
                : new Saving(omission, least[0], least[i + 2]))];
    }

    private static SceneDescription Alone(BodyDescription body, BodyPlan plan) => new("alone", string.Empty, plan.Steps, [body]);
}
