using System.Globalization;

namespace RigidBodyDynamics.Mutants;

/// <summary>What the command line asks for.</summary>
internal sealed record Wish
{
    public const string Usage =
        """
        usage: Mutants [--sample N [--seed S]] [--only PATH] [--go-on | --again | --page] [--without-golden]
          (nothing)         every mutant; writes docs/mutants.md
          --sample N        N of them, drawn by the seed
          --only PATH       those of the files whose path starts so, such as FreeRotation/Orbit
          --go-on           those that a whole run has not come to; writes the page
          --again           these, and what survived, after tests were added; writes the page
          --page            none: writes the page again, with reasons that have been added
          --without-golden  does not ask the fingerprint about survivors
        """;

    /// <summary>Of all mutants, so many must be killed.</summary>
    private const double OfAll = 0.95;

    // a sample of 150 from where 95 % die has 93 % or more in 9 of 10 draws
    private const double OfSample = 0.90;

    public int? Sample { get; private init; }

    public int Seed { get; private init; } = 1;

    public string Only { get; private init; } = "";

    public bool IsGoingOn { get; private init; }

    public bool IsAgain { get; private init; }

    public bool IsPage { get; private init; }

    public bool WithoutGolden { get; private init; }

    /// <summary>The result is that of all mutants.</summary>
    public bool IsWhole => Sample == null && Only.Length == 0;

    public double Demanded => IsWhole ? OfAll : OfSample;

    /// <summary>The wish; nothing if the arguments make none.</summary>
    public static Wish? Read(ReadOnlySpan<string> arguments)
    {
        Wish wish = new();
        while (arguments.Length > 0)
        {
            switch (arguments)
            {
                case ["--go-on", ..]:
                    wish = wish with { IsGoingOn = true };
                    break;
                case ["--again", ..]:
                    wish = wish with { IsAgain = true };
                    break;
                case ["--page", ..]:
                    wish = wish with { IsPage = true };
                    break;
                case ["--without-golden", ..]:
                    wish = wish with { WithoutGolden = true };
                    break;
                case ["--sample", string count, ..] when Number(count) is > 0 and int number:
                    wish = wish with { Sample = number };
                    arguments = arguments[1..];
                    break;
                case ["--seed", string seed, ..] when Number(seed) is int number:
                    wish = wish with { Seed = number };
                    arguments = arguments[1..];
                    break;
                case ["--only", string path, ..]:
                    wish = wish with { Only = path };
                    arguments = arguments[1..];
                    break;
                default:
                    return null;
            }

            arguments = arguments[1..];
        }

        return (wish.IsAgain || wish.IsGoingOn || wish.IsPage) && !wish.IsWhole ? null : wish;
    }

    /// <summary>The mutants asked for, in the order of the text.</summary>
    public IReadOnlyList<Mutant> Choose(IReadOnlyList<Mutant> all, Ledger ledger)
    {
        if (IsAgain || IsGoingOn)
            return [.. all.Where(mutant => ledger[mutant] is null || (IsAgain && ledger[mutant] is Fate.Survived or Fate.KilledByGolden))];

        Mutant[] chosen = [.. all.Where(mutant => mutant.File.StartsWith(Only, StringComparison.Ordinal))];
        if (Sample is not int count || count >= chosen.Length)
            return chosen;

        int[] places = [.. Enumerable.Range(0, chosen.Length)];
        new Random(Seed).Shuffle(places);
        return [.. places.Take(count).Order().Select(place => chosen[place])];
    }

    private static int? Number(string text) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int number) ? number : null;
}
