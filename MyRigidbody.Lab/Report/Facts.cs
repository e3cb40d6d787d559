using System.Globalization;
using RigidBodyDynamics.Lab.Languages;

namespace RigidBodyDynamics.Lab.Report;

/// <summary>What the page was made of, and on what.</summary>
/// <param name="Rows">A name and what it is.</param>
internal sealed record Facts(IReadOnlyList<Facts.Row> Rows) : Section
{
    /// <inheritdoc/>
    public override string Kind => "facts";

    /// <summary>Of a page that shows so many moments of a run.</summary>
    public static Facts Of(SceneDescription scene, string file, int moments)
    {
        TimeSteps steps = scene.Steps;
        string count = steps.Count.ToString(CultureInfo.InvariantCulture), whole = Number(steps.StartOf(steps.Count));
        return new Facts(
        [
            new Row(Words.All["facts.scene"], Word.Name(scene.Name)),
            new Row(Words.All["facts.file"], Word.Name(file)),
            new Row(Words.All["facts.steps"], steps.FirstOfOtherLength < 0
                ? Words.All["facts.equal"].With(count, Number(steps.Length(0)), whole)
                : Words.All["facts.unequal"].With(count, whole)),
            new Row(Words.All["facts.shown"], Word.Name(moments.ToString(CultureInfo.InvariantCulture))),
            .. OfMachine().Rows,
        ]);
    }

    /// <summary>Of a page that is about no one scene.</summary>
    public static Facts OfMachine() => new(
    [
        new Row(Words.All["facts.machine"], Page.Machine),
        new Row(Words.All["facts.version"], Word.Name(Page.Version)),
    ]);

    private static string Number(double value) => value.ToString("G6", CultureInfo.InvariantCulture);

    /// <summary>A fact.</summary>
    internal sealed record Row(Word Name, Word Value);
}
