using System.Globalization;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Commands;

/// <summary>The advice of <c>choose</c> for the bodies of a scene, each alone.</summary>
internal static class BodyByBodyReport
{
    /// <summary>One row for each body, and what separate choices save.</summary>
    public static void Print(SceneDescription scene, double error, Advice forAll, BodyByBody found)
    {
        bool sharesStep = found.OneStep.Count > 0;
        string step = sharesStep ? CostTables.Step(found.OneStep[0].Step) : string.Empty;
        TextTable table = new TextTable(["body by body", "integrator", "step, s", "error", "µs per s", .. sharesStep ? [$"all in {step} s", "error", "µs per s"] : Array.Empty<string>()])
            .RightAligned(sharesStep ? [2, 3, 4, 6, 7] : [2, 3, 4]);

        for (int i = 0; i < found.Own.Count; i++)
        {
            Trial own = found.Own[i].Best;
            string[] inOneStep = sharesStep ? Cells(found.OneStep[i]) : [];
            string[] cells = [scene.Bodies[i].Name + (found.Own[i].Reached ? string.Empty : " (closest)"), own.Rule.Name, CostTables.ExactStep(own.Step), .. Cells(own)[1..], .. inOneStep];
            table.AddRow(cells);
        }

        Terminal.WriteLine();
        Terminal.Write(table);
        foreach ((BodyDescription body, Advice own) in scene.Bodies.Zip(found.Own).Where(pair => !pair.Second.Reached))
            Terminal.WriteText(FormattableString.Invariant($"{body.Name}: no integrator and step keep the error below {error:R}: {own.Reason}"));

        string[] sums = [.. Sums(forAll, found)];
        if (sums.Length > 0)
        {
            Terminal.WriteText("All bodies together, µs per s:");
            foreach (string sum in sums)
                Terminal.WriteText("  " + sum);
        }
    }

    /// <summary>The answer for every body.</summary>
    public static object Bodies(SceneDescription scene, BodyByBody found) => scene.Bodies.Zip(found.Own, (body, own) => new
    {
        name = body.Name,
        reached = own.Reached,
        reason = own.Reached ? null : own.Reason,
        integrator = own.Best.Rule.Name,
        step = own.Best.Step,
        measuredError = OrNull(own.Best.Error),
        secondsPerSimulatedSecond = OrNull(own.Best.Cost),
    });

    /// <summary>The common step, as a scene file can have it; null where no step is short enough for all.</summary>
    public static object? OneStep(SceneDescription scene, BodyByBody found) => found.OneStep.Count == 0 ? null : new
    {
        step = found.OneStep[0].Step,
        bodies = scene.Bodies.Zip(found.OneStep, (body, trial) => new
        {
            name = body.Name,
            integrator = trial.Rule.Name,
            measuredError = OrNull(trial.Error),
            secondsPerSimulatedSecond = OrNull(trial.Cost),
        }),
    };

    /// <summary>Seconds per simulated second of all bodies; null where a body has no integrator below the bound.</summary>
    public static object Together(BodyByBody found) => new
    {
        oneRule = found.OneRule.Count > 0 ? OrNull(BodyByBody.CostOf(found.OneRule)) : null,
        oneStep = found.OneStep.Count > 0 ? OrNull(BodyByBody.CostOf(found.OneStep)) : null,
        bodyByBody = found.Reached ? OrNull(BodyByBody.CostOf(found.Own.Select(own => own.Best))) : null,
    };

    private static IEnumerable<string> Sums(Advice forAll, BodyByBody found)
    {
        double oneRule = forAll.Reached ? BodyByBody.CostOf(found.OneRule) : double.NaN;
        if (forAll.Reached)
            yield return $"{Number(oneRule)} by {forAll.Best.Rule.Name} in steps of {CostTables.Step(forAll.Best.Step)} s";

        if (found.Reached)
            yield return Line(BodyByBody.CostOf(found.Own.Select(own => own.Best)), "in its own step, which takes a scene for each");

        if (found.OneStep.Count > 0)
        {
            // all digits, because the number is copied into the file
            string step = found.OneStep[0].Step.ToString("R", CultureInfo.InvariantCulture);
            yield return Line(BodyByBody.CostOf(found.OneStep), $"in one scene, whose file then says \"step\": {step} and the integrators on the right");
        }

        string Line(double cost, string how) => $"{Number(cost)}{Less(cost, oneRule)}, each by its own integrator {how}";
    }

    private static string Less(double cost, double than) => !double.IsFinite(than) ? string.Empty
        : cost * Advisor.SameCost > than ? " (no less)"
        : (1 - cost / than).ToString(" (0 % less)", CultureInfo.InvariantCulture);

    private static string Number(double seconds) => CostTables.Number(1e6 * seconds);

    private static string[] Cells(Trial trial) => [trial.Rule.Name, CostTables.Error(trial.Error), Number(trial.Cost)];

    private static double? OrNull(double value) => Guard.IsFinite(value) ? value : null;
}
