using System.Text.Json;
using AngleSharp.Html.Dom;
using AngleSharp.Html.Parser;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Comparison;
using RigidBodyDynamics.Lab.Report;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.Tests.Report;

/// <summary>A page and what it holds.</summary>
internal sealed class Parsed
{
    /// <summary>Reads a page as a browser does; what a browser would have to mend is an exception.</summary>
    public Parsed(string html)
    {
        Html = html;
        Document = new HtmlParser(new HtmlParserOptions { IsStrictMode = true }).ParseDocument(html);
        Data = JsonDocument.Parse(Document.GetElementById("data")!.TextContent).RootElement;
    }

    /// <summary>The page of <c>compare</c> for a scene of the gallery.</summary>
    public static Parsed Compared(string scene) => Comparison(SceneReader.Read(Path.Combine(Gallery.Folder, scene)));

    /// <summary>The page of <c>run</c> for a scene.</summary>
    public static Parsed Ran(string name, double step, long steps, params string[] bodies) => InFile(name, step, steps, bodies, file =>
    {
        Simulation simulation = ManyBodies.Simulate(file.Scene, file.Crowds);
        return new Parsed(PageWriter.Html(Reports.Of(file, file.Scene, simulation, "run " + Page.Shown(file.Path))));
    });

    /// <summary>The page of <c>compare</c> for a scene.</summary>
    public static Parsed Compared(string name, double step, long steps, params string[] bodies) => InFile(name, step, steps, bodies, Comparison);

    public string Html { get; }

    public IHtmlDocument Document { get; }

    /// <summary>What the scripts read.</summary>
    public JsonElement Data { get; }

    public double[] Column(int body, string name) => Numbers(Data.GetProperty("bodies")[body].GetProperty(name));

    public static double[] Numbers(JsonElement list) => [.. list.EnumerateArray().Select(number => number.GetDouble())];

    private static Parsed Comparison(SceneFile file)
    {
        Findings[] found = [.. Pair.Of(file).Select(pair => Findings.Of(pair, file.Scene.Steps, _ => { }))];
        return new Parsed(PageWriter.Html(Reports.Of(file, new Simulation(file.Scene), found, Motion.Of(file, found))));
    }

    private static Parsed InFile(string name, double step, long steps, string[] bodies, Func<SceneFile, Parsed> make)
    {
        using TemporaryFolder folder = new();
        string path = folder.File("scene.json");
        File.WriteAllText(path, JsonSerializer.Serialize(new
        {
            schema = "rigid-body-scene/1",
            name,
            about = name,
            step,
            steps,
            bodies = bodies.Select(body => new
            {
                name = body,
                inertia = new { solidBox = new[] { 1.0, 2, 3 } },
                velocity = new[] { 0.5, 0.1, -0.2 },
                angularVelocity = new[] { 0.01, 3.1, 0.01 },
            }),
        }));
        return make(SceneReader.ReadWithCrowds(path));
    }
}
