using System.CommandLine;

namespace RigidBodyDynamics.Lab.Languages;

/// <summary>
/// In which of two languages the program speaks to its user: as --lang says, or else as the system does. Numbers and what programs
/// read are the same in both. The Chinese of System.CommandLine is half English, so its sentences are translated as ours are.
/// </summary>
internal static class Language
{
    private const string Flag = "--lang", Chinese = "zh", English = "en";

    // of one command line, wherever its work is done
    private static readonly AsyncLocal<bool> Chosen = new();

    /// <summary>True where it speaks Chinese.</summary>
    public static bool IsChinese => Chosen.Value;

    /// <summary>Chooses it before the arguments are parsed, because what is wrong with them is said in it, too.</summary>
    public static void Choose(string[] arguments)
    {
        string[] own = [.. arguments.TakeWhile(argument => argument != "--")];
        string? chosen = own.Zip(own.Skip(1)).Where(pair => pair.First == Flag).Select(pair => pair.Second)
            .Concat(own.Where(argument => argument.StartsWith(Flag + "=", StringComparison.Ordinal)).Select(argument => argument[(Flag.Length + 1)..]))
            .FirstOrDefault(language => language is Chinese or English);
        Chosen.Value = chosen != null ? chosen == Chinese : Locale.IsChinese;
    }

    /// <summary>The option by which a user chooses it, for every command.</summary>
    public static Option<string?> Option()
    {
        Option<string?> option = new(Flag) { Description = "language of the sentences; that of the system if absent", HelpName = "LANG", Recursive = true };
        option.AcceptOnlyFromAmong(English, Chinese);
        return option;
    }

    /// <summary>What stands in the program in English, in the user's language.</summary>
    public static string Say(string english) => IsChinese ? Sentences.InChinese(english) : english;

    /// <summary>Has a command and all below it described in the user's language.</summary>
    public static void Describe(Command command)
    {
        foreach (Symbol symbol in command.Options.Cast<Symbol>().Concat(command.Arguments).Append(command).Where(symbol => symbol.Description != null))
        {
            symbol.Description = Say(symbol.Description!);
        }

        foreach (Command below in command.Subcommands)
        {
            Describe(below);
        }
    }
}
