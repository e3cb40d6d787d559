namespace RigidBodyDynamics.Lab.Report;

/// <summary>
/// A command on a page, safe to be pasted into a shell with any file names. A name with special characters is quoted so that bash,
/// zsh, PowerShell and cmd read it alike; a name that cannot be quoted so is not shown.
/// </summary>
internal static class Shell
{
    /// <summary>Replaces a name that cannot be quoted for every shell.</summary>
    public const string Unquotable = "FILE";

    // within double quotes $ ` " \ ! are special in bash, round quotes in PowerShell, % in cmd
    private const string MeansMoreInDouble = "$`\"\\!%“”„";

    // what ends single quotes, in PowerShell the round ones too; and special characters of cmd, which has no single quotes
    private const string MeansMoreInSingle = "'‘’‚‛&|<>^%";

    /// <summary>A command with its arguments.</summary>
    public static string Line(params IEnumerable<string> arguments) => string.Join(' ', arguments.Select(Quoted));

    private static string Quoted(string argument)
    {
        if (argument.Length > 0 && argument.All(IsPlain))
            return argument;

        bool isVisible = Output.Visible.Line(argument) == argument;
        return isVisible && !argument.Any(MeansMoreInDouble.Contains) ? $"\"{argument}\""
            : isVisible && !argument.Any(MeansMoreInSingle.Contains) ? $"'{argument}'"
            : Unquotable;
    }

    // a backslash belongs to names on Windows alone
    private static bool IsPlain(char letter) =>
        char.IsLetterOrDigit(letter) || "-_./:=".Contains(letter) || (letter == '\\' && OperatingSystem.IsWindows());
}
