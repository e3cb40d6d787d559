namespace RigidBodyDynamics.Lab.Report;

/// <summary>
/// A command as a page shows it, to be pasted into a shell, whoever named the files. What a shell would take for more than a
/// name is quoted so that bash, zsh, PowerShell and cmd read it alike; a name that none of them quotes alike is not shown.
/// </summary>
internal static class Shell
{
    /// <summary>Stands for a name that cannot be quoted for every shell.</summary>
    public const string Unquotable = "FILE";

    // within double quotes bash looks for $ ` " \ !, PowerShell for its round quotes too, cmd for %
    private const string MeansMoreInDouble = "$`\"\\!%“”„";

    // what ends single quotes, in PowerShell the round ones too; and what means more in cmd, which has no single quotes
    private const string MeansMoreInSingle = "'‘’‚‛&|<>^%";

    /// <summary>A command with its arguments.</summary>
    public static string Line(params IEnumerable<string> arguments) => string.Join(' ', arguments.Select(Quoted));

    private static string Quoted(string argument)
    {
        if (argument.Length > 0 && argument.All(IsPlain))
        {
            return argument;
        }

        bool isVisible = Output.Visible.Line(argument) == argument;
        return isVisible && !argument.Any(MeansMoreInDouble.Contains) ? $"\"{argument}\""
            : isVisible && !argument.Any(MeansMoreInSingle.Contains) ? $"'{argument}'"
            : Unquotable;
    }

    // a backslash is a name's own on Windows alone
    private static bool IsPlain(char letter) =>
        char.IsLetterOrDigit(letter) || "-_./:=".Contains(letter) || (letter == '\\' && OperatingSystem.IsWindows());
}
