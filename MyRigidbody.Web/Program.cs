using System.CommandLine;
using RigidBodyDynamics.Web.Building;
using RigidBodyDynamics.Web.Server;

namespace RigidBodyDynamics.Web;

/// <summary>Builds the lab in a browser and serves it to this machine, or writes it as a folder for any web server.</summary>
internal static class Program
{
    private static int Main(string[] args)
    {
        Option<string?> folder = new("--out") { Description = "Write the site into this folder, for any web server, and end.", HelpName = "FOLDER" };
        Option<int> port = new("--port") { Description = "The port on this machine; 0 for any that is free.", DefaultValueFactory = _ => 5210 };
        Option<bool> noBrowser = new("--no-browser") { Description = "Open no browser." };
        Option<bool> strict = new("--warnaserror") { Description = "Take the compiler's warnings for errors." };
        RootCommand root = new("The lab in a browser: builds its site, if that has changed, and serves it on this machine.") { folder, port, noBrowser, strict };
        port.Validators.Add(result =>
        {
            if (result.Tokens is [var token] && !(int.TryParse(token.Value, out int number) && number is >= 0 and <= 65535))
                result.AddError($"--port must be a number from 0 to 65535, found \"{token.Value}\".");
        });
        root.SetAction((parsed, stop) => Execute(parsed.GetValue(folder), parsed.GetValue(port), !parsed.GetValue(noBrowser), parsed.GetValue(strict), stop));

        ParseResult parsed = root.Parse(args, new ParserConfiguration { ResponseFileTokenReplacer = null });
        if (parsed.Errors.Count > 0)
            return Refuse(string.Join(' ', parsed.Errors.Select(error => error.Message)) + " Try --help.");

        try
        {
            return parsed.Invoke(new InvocationConfiguration { EnableDefaultExceptionHandler = false });
        }
        catch (RefusedException refused)
        {
            return Refuse(refused.Message);
        }
    }

    private static async Task<int> Execute(string? folder, int port, bool openBrowser, bool strict, CancellationToken stop)
    {
        // before the build, which takes a minute
        if (folder == null)
            StaticServer.MustBeFree(port);

        Project project = Project.OfThisProgram();
        Site site = new(project, Path.GetFullPath(folder ?? project.Site));
        site.Build(strict);
        if (folder != null)
            Console.WriteLine($"the site is in {folder}");
        else
            await StaticServer.Run(site.Folder, port, openBrowser, stop);

        return 0;
    }

    private static int Refuse(string message)
    {
        Console.Error.WriteLine("error: " + message.ReplaceLineEndings(" "));
        return 2;
    }
}
