using System.Text;
using RigidBodyDynamics.Lab.Languages;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace RigidBodyDynamics.Lab.Output;

/// <summary>
/// Output for people: results on standard output, errors and progress on standard error. Nothing else in the program writes
/// there, and every text passes <see cref="Language"/> and <see cref="Visible"/>.
/// </summary>
internal static class Terminal
{
    // wide and plain in a pipe
    private const int PipeWidth = 150, PipeHeight = 24;
    private const int LongestError = 1000;

    /// <summary>A line of any length.</summary>
    public static void WriteLine(string line = "") => Console.Out.WriteLine(Visible.Line(Language.Say(line)));

    /// <summary>A text of one paragraph, wrapped to the width of the terminal.</summary>
    public static void WriteText(string text) => Draw(new Text(Visible.Line(Language.Say(text)) + Environment.NewLine));

    public static void Write(TextTable table) => Draw(table.Drawn);

    /// <summary>An answer in JSON.</summary>
    public static void WriteJson(string json) => Console.Out.WriteLine(Visible.Json(json));

    public static void Error(string line) => Console.Error.WriteLine(Lead("error:") + Visible.Line(Language.Say(line), LongestError));

    public static void Note(string line) => Console.Error.WriteLine(Lead("note:") + Visible.Line(Language.Say(line), LongestError));

    /// <summary>Does long work; with a progress bar on a terminal, without output in a pipe.</summary>
    /// <param name="what">What is being done.</param>
    /// <param name="work">The work, which reports the finished fraction.</param>
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
            ProgressTask task = context.AddTask(Markup.Escape(Visible.Line(Language.Say(what))), maxValue: 1);
            work(done => task.Value = done);
        });
    }

    // the Chinese colon includes its space
    private static string Lead(string word) => Language.IsChinese ? Language.Say(word) : word + " ";

    private static void Draw(IRenderable what)
    {
        // a browser has no terminal: the output is plain text
        if (!OperatingSystem.IsBrowser() && !Console.IsOutputRedirected)
        {
            AnsiConsole.Create(new AnsiConsoleSettings { Out = new AnsiConsoleOutput(Console.Out) }).Write(what);
            return;
        }

        foreach (Segment piece in what.GetSegments(AnsiConsole.Create(new AnsiConsoleSettings { Out = new Pipe(), ColorSystem = ColorSystemSupport.NoColors })))
            Console.Out.Write(piece.Text);
    }

    /// <summary>An output of unknown width.</summary>
    private sealed class Pipe : IAnsiConsoleOutput
    {
        public TextWriter Writer => TextWriter.Null;

        public bool IsTerminal => false;

        public int Width => PipeWidth;

        public int Height => PipeHeight;

        public void SetEncoding(Encoding encoding)
        {
            // the caller has the writer already
        }
    }
}
