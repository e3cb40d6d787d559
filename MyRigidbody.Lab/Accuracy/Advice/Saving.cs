namespace RigidBodyDynamics.Lab;

/// <summary>What is left out of a body's motion, and the time that saves.</summary>
/// <param name="Omission">What, and why.</param>
/// <param name="Without">A step as it is, ns; NaN where it was not measured.</param>
/// <param name="With">A step with it, ns; NaN where there is nothing to put back, or it was not measured.</param>
internal sealed record Saving(Omission Omission, double Without, double With)
{
    private const int Turns = 12;
    private const double SecondsPerTurn = 0.004;

    /// <summary>Never less than nothing: what is not there cannot cost time, only the clock can be wrong.</summary>
    public double Nanoseconds => Math.Max(0, With - Without);

    /// <summary>What is left out, without the time it saves.</summary>
    public static IReadOnlyList<Saving> NotMeasured(IReadOnlyList<Omission> leftOut) =>
        [.. leftOut.Select(omission => new Saving(omission, double.NaN, double.NaN))];

    /// <summary>Takes the time of a body as it is and with each thing put back, in turns.</summary>
    /// <param name="plan">The body.</param>
    /// <param name="leftOut">What is left out.</param>
    /// <param name="report">Told the fraction that is done.</param>
    public static IReadOnlyList<Saving> Measure(BodyPlan plan, IReadOnlyList<Omission> leftOut, Action<double> report)
    {
        // every step taken, whoever looks; the steps themselves are what a body that coasts saves
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
