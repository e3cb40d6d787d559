using RigidBodyDynamics.Lab.Languages;

namespace RigidBodyDynamics.Lab.Report;

/// <summary>The parts of each body's motion and what was left out: the same explanation that <c>explain</c> prints.</summary>
internal sealed record Plan(IReadOnlyList<Plan.Of> Bodies) : Section
{
    private const int MostBodies = 12, MostNames = 5, MostStretches = 20;

    /// <inheritdoc/>
    public override string Kind => "plan";

    /// <summary>The number of kinds of motion that are not shown.</summary>
    public int More { get; private init; }

    /// <summary>The plans of bodies; bodies that move alike share one.</summary>
    public static Plan From(IEnumerable<(string Name, BodyPlan Plan)> bodies)
    {
        List<(List<string> Names, Explanation Explanation, BodyPlan Plan)> kinds = [];
        Dictionary<string, int> known = [];
        foreach ((string name, BodyPlan plan) in bodies)
        {
            Explanation explanation = new(plan);
            string words = explanation.ToString();
            string key = plan.Rule.Name + words[words.IndexOf('\n', StringComparison.Ordinal)..];
            if (known.TryAdd(key, kinds.Count))
                kinds.Add(([], explanation, plan));

            kinds[known[key]].Names.Add(name);
        }

        return new Plan([.. kinds.Take(MostBodies).Select(kind => Make(kind.Names, kind.Explanation, kind.Plan))]) { More = Math.Max(0, kinds.Count - MostBodies) };
    }

    private static Of Make(List<string> names, Explanation explanation, BodyPlan plan)
    {
        string few = string.Join(", ", names.Take(MostNames));
        Word title = names.Count > MostNames ? Words.All["plan.together"].With(few + ", …", names.Count) : Word.Name(few);
        return new Of(
            Words.All["plan.by"].With(title, plan.Rule.Name),
            [.. plan.Stretches.Take(MostStretches).Select(stretch => new Stretch(
                Words.Phrase(explanation.Time(stretch)),
                [.. explanation.Parts(stretch).Select(Words.Phrase)],
                explanation.Coasts(stretch)))],
            Math.Max(0, plan.Stretches.Count - MostStretches),
            [.. explanation.Omitted.Select(omission => new Omitted(Words.Phrase(omission.What), Words.Phrase(omission.Why)))],
            [.. explanation.Notes.Select(Words.Phrase)]);
    }

    /// <summary>One body, or several that move alike.</summary>
    internal sealed record Of(Word Title, IReadOnlyList<Stretch> Stretches, int More, IReadOnlyList<Omitted> LeftOut, IReadOnlyList<Word> Notes);

    /// <summary>A stretch of time in which the same effects act.</summary>
    internal sealed record Stretch(Word When, IReadOnlyList<Word> Parts, bool Coasts);

    /// <summary>A part that is not computed, and the reason.</summary>
    internal sealed record Omitted(Word What, Word Why);
}
