using System.CommandLine;
using System.CommandLine.Help;
using System.Globalization;
using System.Text;
using RigidBodyDynamics.Lab.Commands;
using RigidBodyDynamics.Lab.Languages;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.StudentScripts;

namespace RigidBodyDynamics.Lab;

/// <summary>The command line: every command answers bad input with one line on standard error and exit code 2.</summary>
internal static class Program
{
    private const int NarrowestHelp = 40;

    private static int Main(string[] args)
    {
        if (ScriptRunner.WasChild(args, out int exitCode))
            return exitCode;

        Console.OutputEncoding = new UTF8Encoding(encoderShouldEmitUTF8Identifier: false);
        StandardOutput.Use();
        return Run(args);
    }

    /// <summary>Runs a command line as a shell would.</summary>
    internal static int Run(string[] args)
    {
        Language.Choose(args);
        RootCommand root = new("MyRigidbody moves rigid bodies and shows why Unity's own body moves differently.")
        {
            CompareCommand.Create(),
            RunCommand.Create(),
            CostCommand.Create(),
            ChooseCommand.Create(),
            ExplainCommand.Create(),
            InertiaCommand.Create(),
            BenchCommand.Create(),
            IntegratorsCommand.Create(),
            GradeCommand.Create(),
            PackCommand.Create(),
            CheckCommand.Create(),
            Language.Option(),
        };
        Language.Describe(root);
        // without a command: the lab's scene, both bodies
        root.SetAction(_ => CompareCommand.Execute(Gallery.Lab, CompareCommand.DefaultFolder, CompareCommand.DefaultTolerance));
        // in a narrow terminal the library's layout of the help throws
        foreach (HelpAction help in root.Options.Select(option => option.Action).OfType<HelpAction>())
            help.MaxWidth = Math.Max(help.MaxWidth, NarrowestHelp);

        // an argument that begins with @ is a file name
        ParseResult parsed = root.Parse(args, new ParserConfiguration { ResponseFileTokenReplacer = null });
        if (parsed.Errors.Count > 0)
            return Refuse(OneLine(parsed.Errors.Select(error => Language.Say(OneLine([error.Message])))) + " Try --help.");

        try
        {
            InvocationConfiguration plain = new() { EnableDefaultExceptionHandler = false, ProcessTerminationTimeout = null };
            return parsed.Action is HelpAction && Language.IsChinese ? Help(parsed, plain) : parsed.Invoke(plain);
        }
        catch (InputException refused)
        {
            return Refuse(refused.Message);
        }
        catch (BrokenEffectException broken)
        {
            return Refuse(broken.Message);
        }
        catch (Exception lacking) when (lacking.GetBaseException() is OutOfMemoryException)
        {
            return Refuse("out of memory: there are " + (Memory.Available / 1e6).ToString("0", CultureInfo.InvariantCulture) + " MB, and this takes more");
        }
        catch (StateOverflowException lost)
        {
            return FallShort(lost.Message);
        }
        catch (ReaderLeftException)
        {
            return 0;
        }
        catch (Exception full) when (full is IOException or UnauthorizedAccessException)
        {
            // errors of files are reported there, and a reader who closes a pipe is no error; a full disk behind a redirection is
            return Refuse("standard output: cannot be written: " + OneLine([full.Message]));
        }
        catch (FellShortException shortfall)
        {
            return FallShort(shortfall.Message);
        }
    }

    /// <summary>Replaces the headings of the library's help, which are English.</summary>
    private static int Help(ParseResult parsed, InvocationConfiguration configuration)
    {
        using StringWriter help = new();
        configuration.Output = help;
        int code = parsed.Invoke(configuration);
        foreach (string line in help.ToString().TrimEnd().Split('\n'))
            Terminal.WriteLine(line.TrimEnd());

        return code;
    }

    private static int FallShort(string line)
    {
        Terminal.Error(line);
        return 1;
    }

    private static int Refuse(string line)
    {
        Terminal.Error(line);
        return 2;
    }

    private static string OneLine(IEnumerable<string> messages) =>
        string.Join(' ', messages.SelectMany(message => message.Split('\n', '\r')).Select(line => line.Trim()).Where(line => line.Length > 0));
}
