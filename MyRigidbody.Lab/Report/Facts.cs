using System.Globalization;
using RigidBodyDynamics.Lab.Languages;

namespace RigidBodyDynamics.Lab.Report;

/// <summary>The input of a page, and the machine on which it was made.</summary>
/// <param name="Rows">A name and what it is.</param>
internal sealed record Facts(IReadOnlyList<Facts.Row> Rows) : Section
{
    /// <inheritdoc/>
    public override string Kind => "facts";

    /// <summary>For a page that shows a number of moments of a run.</summary>
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

    /// <summary>For a page without a scene of its own.</summary>
    public static Facts OfMachine() => new(
    [
        new Row(Words.All["facts.machine"], Page.Machine),
        new Row(Words.All["facts.version"], Word.Name(Page.Version)),
    ]);

    private static string Number(double value) => value.ToString("G6", CultureInfo.InvariantCulture);

    /// <summary>A fact.</summary>
    internal sealed record Row(Word Name, Word Value);
}
