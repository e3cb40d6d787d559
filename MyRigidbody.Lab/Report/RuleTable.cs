using System.Globalization;
using RigidBodyDynamics.Lab.Comparison;
using RigidBodyDynamics.Lab.Languages;

namespace RigidBodyDynamics.Lab.Report;

/// <summary>The share of each rule in the difference, for every pair; and the result of applying keys in Update.</summary>
internal sealed record RuleTable(IReadOnlyList<RuleTable.Of> Pairs) : Section
{
    private const int MostPairs = 20;

    /// <inheritdoc/>
    public override string Kind => "rules";

    /// <summary>The tables of a comparison.</summary>
    public static RuleTable From(IReadOnlyList<Findings> found) => new([.. found.Take(MostPairs).Select(pair => new Of(pair))]);

    /// <summary>The tables of one pair.</summary>
    internal sealed class Of(Findings found)
    {
        private readonly Apart _whole = found.Shares.Whole;

        public Word Lead => Words.All["rules.lead"].With(Mine, Unitys, CompareTables.Length(_whole.MeanDistance), CompareTables.Degrees(_whole.MeanTurn));

        public string Mine => found.Pair.Mine.Name;

        public string Unitys => found.Pair.Default.Name;

        public Word Note => Words.All["rules.note"].With(Mine, Unitys);

        public IEnumerable<Row> Rows => found.Shares.Shares.Select(share => new Row(
            Words.Phrase(share.Difference.Name),
            Words.Phrase(share.Difference.Mine),
            Words.Phrase(share.Difference.Unitys),
            new Share(share.Distance, _whole.MeanDistance, CompareTables.Length(share.Distance) + " m"),
            new Share(share.Turn, _whole.MeanTurn, CompareTables.Degrees(share.Turn) + "°")));

        public string Distance => CompareTables.Length(_whole.MeanDistance) + " m";

        public string Turn => CompareTables.Degrees(_whole.MeanTurn) + "°";

        public Word FramesCaption => Words.All["frames.caption"].With(Unitys);

        public IEnumerable<string[]> FrameRates => found.FrameRates.Select(rate => new[]
        {
            rate.FramesPerSecond.ToString(CultureInfo.InvariantCulture),
            CompareTables.Ratio(rate.Impulse),
            CompareTables.Ratio(rate.AngularImpulse),
            CompareTables.Length(rate.Apart.Last.Distance) + " m",
            CompareTables.Degrees(rate.Apart.Last.Turn) + "°",
        });
    }

    internal sealed record Row(Word Rule, Word Mine, Word Unitys, Share Distance, Share Turn);

    /// <summary>A share: the number, per cent, and a bar of that length.</summary>
    internal sealed record Share(double Part, double Whole, string Amount)
    {
        // bars of shares that cancel each other are longer than the whole; a cell is not
        private const double Longest = 250;

        public string Percent => CompareTables.Percent(Part, Whole);

        public string Width => (Whole > 0 ? Math.Min(Longest, 100 * Math.Abs(Part / Whole)) * 100 / Longest : 0).ToString("0.#", CultureInfo.InvariantCulture);

        public bool IsNegative => Part < 0;
    }
}
