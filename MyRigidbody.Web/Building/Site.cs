namespace RigidBodyDynamics.Web.Building;

/// <summary>The site, from its sources to a folder that any web server can send.</summary>
/// <param name="project">The sources.</param>
/// <param name="folder">The site.</param>
internal sealed class Site(Project project, string folder)
{
    private const string NoNpm = "npm is not on the path: the page's editor is bundled by it (Node.js 20 or newer has it)";

    // the sources of both programs of the page
    private static readonly string[] Libraries = ["MyRigidbody.Core", "MyRigidbody.Engine", "MyRigidbody.Judge", "MyRigidbody.Scripts", "MyRigidbody.Lab"];

    /// <summary>The folder of the site.</summary>
    public string Folder => folder;

    /// <summary>Builds what has changed.</summary>
    /// <param name="strict">True if compiler warnings are errors.</param>
    public void Build(bool strict)
    {
        Tool.Run(project.Page, "npm", NoNpm, "--version");
        SiteFolder site = new(project, folder);
        site.Create();
        foreach (string program in Project.Programs)
            Publish(program, strict);

        Bundle();
        site.Write();
    }

    private void Publish(string program, bool strict)
    {
        string sources = Path.Combine(project.Web, program);
        string[] inputs =
        [
            .. Libraries.Select(library => Path.Combine(project.Root, library)), sources, Path.Combine(project.Web, "Wasm.props"),
            Path.Combine(project.Root, "Directory.Build.props"), Path.Combine(project.Root, "Directory.Packages.props"), Path.Combine(project.Root, "global.json"),
        ];
        new Stamp(project, program + (strict ? "-strict" : string.Empty)).Do(inputs, project.Published(program), () =>
        {
            Console.WriteLine($"building {program}");
            // removes what an earlier build published and this one does not
            if (Directory.Exists(project.Published(program)))
                Directory.Delete(project.Published(program), recursive: true);

            string[] options = ["publish", sources, "-c", "Release", "-nologo", "-v", "quiet"];
            Tool.Run(project.Root, "dotnet", "dotnet is not on the path", strict ? [.. options, "-warnaserror"] : options);
        });
    }

    private void Bundle()
    {
        string modules = Path.Combine(project.Page, "node_modules");
        new Stamp(project, "npm").Do([Path.Combine(project.Page, "package-lock.json")], modules, () =>
        {
            Console.WriteLine("installing what the page's lock file names");
            Tool.Run(project.Page, "npm", NoNpm, "ci", "--ignore-scripts", "--prefer-offline", "--no-audit", "--no-fund", "--loglevel=error");
        });
        new Stamp(project, "bundle").Do([project.Page, Path.Combine(project.Root, "MyRigidbody.Lab", "Report", "Page"), Path.Combine(project.Root, "UnityProject", "Assets", "MyRigidbodyStarter")], project.Bundle, () =>
        {
            Console.WriteLine("bundling the page");
            if (Directory.Exists(project.Bundle))
                Directory.Delete(project.Bundle, recursive: true);

            Tool.Run(project.Page, "npm", NoNpm, "run", "--silent", "bundle", "--", "--outdir=" + project.Bundle, "--metafile=" + project.BundleList);
        });
    }
}
