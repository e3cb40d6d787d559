using System.CommandLine;
using System.Text.Json;
using System.Text.Json.Nodes;
using RigidBodyDynamics.Lab.Comparison;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Lab.Report;

namespace RigidBodyDynamics.Lab.Commands;

/// <summary>The cheapest integrator and step that keep the error of a scene below a bound, and those for each body alone.</summary>
internal static class ChooseCommand
{
    private const double SecondsPerTurn = 0.001;
    private const int Turns = 40;

    public static Command Create()
    {
        Argument<string> scene = new("SCENE") { Description = "a scene file" };
        Option<double> error = new("--error")
        {
            Description = "the larger of the angle (rad) and the distance (m) to the true motion, at any time",
            HelpName = "E",
            Required = true,
            CustomParser = Numbers.Parse,
        };
        Option<bool> json = new("--json") { Description = "as JSON" };
        Command command = new("choose", "The cheapest integrator and step that keep the error below E, by measurement: for all bodies, and body by body")
        {
            scene,
            error,
            json,
        };
        command.SetAction(parsed => Execute(parsed.GetValue(scene)!, parsed.GetValue(error), parsed.GetValue(json)));
        return command;
    }

    private static int Execute(string path, double error, bool asJson)
    {
        Overrides.Named("--error", () => Guard.Positive(error, "error"));
        SceneDescription asked = SceneReader.Read(path).Told().Scene, scene = Overrides.Named(path, () => StepFree.Of(asked));
        Advice advice = null!;
        Trial lab = null!;
        BodyByBody? each = null;
        Breakdown.Placed(path, scene, () => Terminal.WithProgress("choose " + scene.Name, report =>
        {
            // a scene of one body has no separate choice
            double share = scene.Bodies.Count == 1 ? 1 : 0.5;
            advice = Overrides.Named(path, () => Advisor.Choose(scene, error, done => report(share * done)));
            // the lab's step and the chosen one, timed alternately
            lab = Trial.Of(scene, advice.Truth, Rules.LabEuler, advice.Best.Step);
            StepClock.Take([lab, advice.Best], SecondsPerTurn, Turns);
            if (scene.Bodies.Count > 1)
                each = Overrides.Named(path, () => BodyByBody.Of(scene, advice, error, done => report(share + ((1 - share) * done))));
        }));

        if (asJson)
        {
            Terminal.WriteJson(Json(asked, error, advice, lab, each));
        }
        else
        {
            Print(asked, error, advice, lab, path);
            if (each != null)
                BodyByBodyReport.Print(scene, error, advice, each);
        }

        return advice.Reached
            ? 0
            : throw new FellShortException(FormattableString.Invariant($"{path}: no integrator and step keep the error below {error:R}: {advice.Reason}")
                + (each is { Reached: true } ? "; body by body they do" : string.Empty));
    }

    private static void Print(SceneDescription scene, double error, Advice advice, Trial lab, string path)
    {
        TextTable table = new TextTable("", "integrator", "step, s", "error", "µs per s", "× lab").RightAligned(2, 3, 4, 5);

        Add(advice.Reached ? "cheapest" : "closest", advice.Best);
        if (advice.RunnerUp != null)
            Add("next", advice.RunnerUp);

        Terminal.WriteText(FormattableString.Invariant($"{scene.Name}: error below {error:R} (the larger of rad and m)"));
        Terminal.Write(table);
        Terminal.WriteText("µs per s: per simulated second and body. × lab: a step, in steps of LabEuler.");
        if (advice.RunnerUp != null)
        {
            string how = FormattableString.Invariant($"in {advice.RoundsWon} of {advice.Rounds} rounds of measurement {advice.Best.Rule.Name} was the cheaper");
            Terminal.WriteText($"{advice.RunnerUp.Rule.Name} costs {CostTables.Number(advice.Factor)} times as much as {advice.Best.Rule.Name}: {how}{(advice.IsTie ? "; a tie, to this clock" : string.Empty)}.");
        }

        if (advice.Reached)
        {
            Terminal.WriteText($"To have it: {Shell.Line("run", path, "--integrator", advice.Best.Rule.Name, "--step", CostTables.ExactStep(advice.Best.Step))}");
            foreach ((string place, double linear, double angular) in StepFree.Rates(scene))
                Terminal.WriteText(FormattableString.Invariant($$"""with, in place of {{place}}, { "linearDamping": {{linear:R}} }, { "angularDamping": {{angular:R}} }: with other steps its factor is another damping."""));
        }

        void Add(string what, Trial trial) => table.AddRow(
            what,
            trial.Rule.Name,
            CostTables.ExactStep(trial.Step),
            CostTables.Error(trial.Error),
            CostTables.Number(1e6 * trial.Cost),
            CostTables.Number(trial.NanosecondsPerStep / lab.NanosecondsPerStep));
    }

    private static string Json(SceneDescription scene, double error, Advice advice, Trial lab, BodyByBody? each)
    {
        JsonObject answer = Node(new
        {
            scene = scene.Name,
            error,
            reached = advice.Reached,
            reason = advice.Reached ? null : advice.Reason,
            integrator = advice.Best.Rule.Name,
            step = advice.Best.Step,
            measuredError = OrNull(advice.Best.Error),
            secondsPerSimulatedSecond = OrNull(advice.Best.Cost),
            steps = advice.Best.Steps,
            stepsOfTheLab = OrNull(advice.Best.NanosecondsPerStep / lab.NanosecondsPerStep),
            runnerUp = advice.RunnerUp == null ? null : new
            {
                integrator = advice.RunnerUp.Rule.Name,
                step = advice.RunnerUp.Step,
                measuredError = advice.RunnerUp.Error,
                secondsPerSimulatedSecond = advice.RunnerUp.Cost,
                timesAsDear = advice.Factor,
                rounds = advice.Rounds,
                roundsDearer = advice.RoundsWon,
                isTie = advice.IsTie,
            },
            inPlaceOfFactors = StepFree.Rates(scene).Select(rate => new { effect = rate.Place, linearDamping = rate.Linear, angularDamping = rate.Angular }),
            truth = new { uncertainty = advice.Truth.Uncertainty, attainable = advice.Truth.Floor },
        }).AsObject();
        if (each != null)
        {
            answer.Add("bodies", Node(BodyByBodyReport.Bodies(scene, each)));
            answer.Add("oneStep", Node(BodyByBodyReport.OneStep(scene, each)));
            answer.Add("secondsTogether", Node(BodyByBodyReport.Together(each)));
        }

        return answer.ToJsonString(CompareSummary.Options);
    }

    private static JsonNode Node(object? value) => JsonSerializer.SerializeToNode(value, CompareSummary.Options)!;

    private static double? OrNull(double value) => Guard.IsFinite(value) ? value : null;
}
