using System.CommandLine;

namespace RigidBodyDynamics.Lab.Languages;

/// <summary>
/// The language of the program's texts: as --lang says, or else as the system's. Numbers and the output for programs are the same
/// in both. The Chinese of System.CommandLine is half English, so its sentences are translated as ours are.
/// </summary>
internal static class Language
{
    private const string Flag = "--lang", Chinese = "zh", English = "en";

    // per command line, on whatever thread it runs
    private static readonly AsyncLocal<bool> Chosen = new();

    /// <summary>True if the language is Chinese.</summary>
    public static bool IsChinese => Chosen.Value;

    /// <summary>Chooses it before the arguments are parsed, because errors in them are printed in it, too.</summary>
    public static void Choose(string[] arguments)
    {
        string[] own = [.. arguments.TakeWhile(argument => argument != "--")];
        string? chosen = own.Zip(own.Skip(1)).Where(pair => pair.First == Flag).Select(pair => pair.Second)
            .Concat(own.Where(argument => argument.StartsWith(Flag + "=", StringComparison.Ordinal)).Select(argument => argument[(Flag.Length + 1)..]))
            .FirstOrDefault(language => language is Chinese or English);
        Chosen.Value = chosen != null ? chosen == Chinese : Locale.IsChinese;
    }

    /// <summary>The option that chooses it, for every command.</summary>
    public static Option<string?> Option()
    {
        Option<string?> option = new(Flag) { Description = "language of the sentences; that of the system if absent", HelpName = "LANG", Recursive = true };
        option.AcceptOnlyFromAmong(English, Chinese);
        return option;
    }

    /// <summary>An English text of the program in the user's language.</summary>
    public static string Say(string english) => IsChinese ? Sentences.InChinese(english) : english;

    /// <summary>Translates the descriptions of a command and its subcommands.</summary>
    public static void Describe(Command command)
    {
        foreach (Symbol symbol in command.Options.Cast<Symbol>().Concat(command.Arguments).Append(command).Where(symbol => symbol.Description != null))
            symbol.Description = Say(symbol.Description!);

        foreach (Command below in command.Subcommands)
            Describe(below);
    }
}
