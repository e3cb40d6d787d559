using Spectre.Console;

namespace RigidBodyDynamics.Lab.Output;

/// <summary>Where people read: tables on standard output, progress on standard error.</summary>
internal static class Terminal
{
    private const int PipeWidth = 150;

    /// <summary>Standard output; wide and plain in a pipe.</summary>
    public static IAnsiConsole Out
    {
        get
        {
            IAnsiConsole console = AnsiConsole.Create(new AnsiConsoleSettings { Out = new AnsiConsoleOutput(Console.Out) });
            if (Console.IsOutputRedirected)
            {
                console.Profile.Width = PipeWidth;
            }

            return console;
        }
    }

    /// <summary>A table with the given headings.</summary>
    public static Table NewTable(params string[] headings)
    {
        Table table = new Table().Border(TableBorder.Rounded);
        foreach (string heading in headings)
        {
            table.AddColumn(new TableColumn(new Text(heading, new Style(decoration: Decoration.Bold))));
        }

        return table;
    }

    /// <summary>Does long work; a bar on a terminal, silence in a pipe.</summary>
    /// <param name="what">What is being done.</param>
    /// <param name="work">The work, which reports the fraction that is done.</param>
    public static void WithProgress(string what, Action<Action<double>> work)
    {
        if (Console.IsErrorRedirected)
        {
            work(_ => { });
            return;
        }

        IAnsiConsole error = AnsiConsole.Create(new AnsiConsoleSettings { Out = new AnsiConsoleOutput(Console.Error) });
        error.Progress().AutoClear(true).Start(context =>
        {
            ProgressTask task = context.AddTask(Markup.Escape(what), maxValue: 1);
            work(done => task.Value = done);
        });
    }
}
