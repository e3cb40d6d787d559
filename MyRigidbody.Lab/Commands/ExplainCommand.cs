using System.CommandLine;
using System.Globalization;
using System.Text.Json;
using RigidBodyDynamics.Lab.Languages;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Commands;

/// <summary>The parts of each body's motion, what was left out and why, and the time that this saves.</summary>
internal static class ExplainCommand
{
    // each takes about half a second
    private const int MostMeasured = 10;

    private static readonly JsonSerializerOptions Indented = new() { WriteIndented = true };

    public static Command Create()
    {
        Argument<string> scene = new("SCENE") { Description = "a scene or a recording" };
        Option<bool> json = new("--json") { Description = "as JSON" };
        Command command = new("explain", "What each body's motion consists of, what is left out and why, and what that saves") { scene, json };
        command.SetAction(parsed => Execute(parsed.GetRequiredValue(scene), parsed.GetValue(json)));
        return command;
    }

    private static int Execute(string path, bool json)
    {
        SceneFile read = SceneReader.ReadWithCrowds(path);
        SceneDescription scene = read.Scene;
        Simulation simulation = Overrides.Named(path, () => new Simulation(ManyBodies.WithFirst(scene, read.Crowds)));

        // bodies that move alike are explained once
        List<Explained> bodies = [];
        Dictionary<string, Explained> known = [];
        for (int i = 0; i < simulation.Bodies.Count; i++)
        {
            Body body = simulation.Bodies[i];
            ManyBodies? crowd = read.Crowds.GetValueOrDefault(body.Name);
            Explanation explanation = new(body.Plan);
            string words = explanation.ToString();
            IReadOnlyList<string> notes = read.Notes.GetValueOrDefault(body.Name, []);
            string key = body.Rule.Name + words[words.IndexOf('\n', StringComparison.Ordinal)..] + string.Join('\n', notes);
            string name = crowd is null ? body.Name : $"{body.Name} ({crowd.Count} bodies, together)";
            if (known.TryGetValue(key, out Explained? like))
            {
                like.Names.Add(name);
                like.Masses.Add(body.Mass);
                continue;
            }

            bodies.Add(new Explained(body.Plan, explanation, [.. notes, .. explanation.Notes]));
            bodies[^1].Names.Add(name);
            bodies[^1].Masses.Add(body.Mass);
            known.Add(key, bodies[^1]);
        }

        Breakdown.Placed(path, scene, () => Terminal.WithProgress("measuring what is left out", report =>
        {
            int measured = Math.Min(MostMeasured, bodies.Count);
            for (int i = 0; i < measured; i++)
            {
                int before = i;
                bodies[i].Savings = Saving.Measure(bodies[i].Plan, bodies[i].Explanation.Omitted, done => report((before + done) / measured));
                bodies[i].IsMeasured = true;
            }
        }));

        if (json)
            Terminal.WriteJson(JsonSerializer.Serialize(new { scene = scene.Name, bodies = bodies.Select(body => body.ToJson()) }, Indented));
        else
            Print(bodies);

        return 0;
    }

    private static void Print(List<Explained> bodies)
    {
        foreach (Explained body in bodies)
        {
            if (body != bodies[0])
                Terminal.WriteLine();

            foreach (string line in body.Lines())
                Terminal.WriteLine(line);
        }
    }

    /// <summary>One or more bodies that move alike.</summary>
    private sealed record Explained(BodyPlan Plan, Explanation Explanation, IReadOnlyList<string> Notes)
    {
        private const int MostNames = 5;
        private const int MostStretches = 20;

        public List<string> Names { get; } = [];

        public HashSet<MassProperties> Masses { get; } = [];

        public IReadOnlyList<Saving> Savings { get; set; } = Saving.NotMeasured(Explanation.Omitted);

        /// <summary>False after the first few bodies, because measuring a scene of many would take hours.</summary>
        public bool IsMeasured { get; set; }

        public IEnumerable<string> Lines()
        {
            string names = string.Join(", ", Names.Take(MostNames)) + (Names.Count > MostNames ? $" and {Names.Count - MostNames} bodies more" : string.Empty);
            List<string> lines = [$"{names}, by {Plan.Rule.Name}"];
            foreach (StretchPlan stretch in Plan.Stretches.Take(MostStretches))
            {
                lines.Add($"  {Language.Say(Explanation.Time(stretch))}{(Language.IsChinese ? "：" : ": ")}{string.Join(Language.IsChinese ? "，" : ", ", Explanation.Parts(stretch).Select(Language.Say))}"
                    + (Explanation.Coasts(stretch) ? "; computed when its state is read" : string.Empty));
            }

            if (Plan.Stretches.Count > MostStretches)
                lines.Add($"  and {Plan.Stretches.Count - MostStretches} stretches more");

            if (Savings.Count > 0)
                lines.Add(IsMeasured ? "  left out:" : $"  left out (what that saves is measured for the first {MostMeasured} bodies that move differently):");

            foreach (Saving saving in Savings)
            {
                lines.Add($"    {Language.Say(saving.Omission.What)}{(Language.IsChinese ? "：" : " (")}{Language.Say(saving.Omission.Why)}{(Language.IsChinese ? "" : ")")}"
                    + (double.IsNaN(saving.With) ? string.Empty : $"; saves {Short(saving.Nanoseconds)} ns of {Short(saving.With)} ns a step, measured"));
            }

            lines.Add("  body: " + InWords(Plan.Asked.Mass, Masses.Count));
            lines.AddRange(Notes.Select(note => "  note: " + note));
            return lines;
        }

        public object ToJson() => new
        {
            names = Names,
            integrator = Plan.Rule.Name,
            mass = Plan.Asked.Mass.Mass,
            principalMoments = Numbers(Plan.Asked.Mass.PrincipalMoments),
            centerOfMass = Numbers(Plan.Asked.Mass.CenterOfMass),
            stretches = Plan.Stretches.Select(stretch => new
            {
                from = Plan.Steps.StartOf(stretch.First),
                to = stretch.End == Plan.Steps.Count ? (double?)null : Plan.Steps.StartOf(stretch.End),
                parts = Explanation.Parts(stretch),
                computedWhenLookedAt = Explanation.Coasts(stretch),
            }),
            measured = IsMeasured,
            leftOut = Savings.Select(saving => new
            {
                what = saving.Omission.What,
                why = saving.Omission.Why,
                nanosecondsSaved = Finite(saving.Nanoseconds),
                nanosecondsWithIt = Finite(saving.With),
            }),
            notes = Notes,
        };

        private static string InWords(MassProperties mass, int kinds) => kinds > 1
            ? $"of {kinds} kinds; the first has {InWords(mass, 1)}"
            : string.Create(CultureInfo.InvariantCulture, $"{mass.Mass:g6} kg, principal moments ({mass.PrincipalMoments.X:g6}, {mass.PrincipalMoments.Y:g6}, {mass.PrincipalMoments.Z:g6}) kg m²")
                + (mass.CenterOfMass.IsZero ? string.Empty : string.Create(CultureInfo.InvariantCulture, $", centre of mass ({mass.CenterOfMass.X:g6}, {mass.CenterOfMass.Y:g6}, {mass.CenterOfMass.Z:g6}) m"));

        private static double[] Numbers(Vector3d v) => [v.X, v.Y, v.Z];

        private static double? Finite(double figure) => double.IsFinite(figure) ? Math.Round(figure, 2) : null;

        private static string Short(double nanoseconds) => nanoseconds.ToString(nanoseconds < 10 ? "0.#" : "0", CultureInfo.InvariantCulture);
    }
}
