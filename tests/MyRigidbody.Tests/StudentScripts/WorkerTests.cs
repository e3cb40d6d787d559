using System.Diagnostics;
using System.Text;
using System.Text.Json;
using System.Text.RegularExpressions;
using NUnit.Framework;
using RigidBodyDynamics.Lab.Checking;
using RigidBodyDynamics.Lab.Grading.Reading;
using RigidBodyDynamics.StudentScripts;
using RigidBodyDynamics.Tests.Judging;

namespace RigidBodyDynamics.Tests.StudentScripts;

/// <summary>
/// The program of the page's worker gives word for word the verdict of check. It is run in Node; where it is not built
/// (<c>dotnet run -c Release --project MyRigidbody.Web -- --out artifacts/site</c> builds it) these tests are skipped.
/// </summary>
[NonParallelizable]
public sealed class WorkerTests
{
    private const string Script = "MyRigidbody.cs";

    private static Process? _worker;

    [OneTimeSetUp]
    public static void Start()
    {
        string program = Repository.Root.File("artifacts/publish/Write/release/wwwroot/_framework");
        if (!File.Exists(Path.Combine(program, "dotnet.js")))
            Assert.Ignore("the page's worker is not built");

        try
        {
            _worker = Process.Start(new ProcessStartInfo("node", [Repository.Root.File("tests/MyRigidbody.Tests/StudentScripts/askWorker.mjs"), program])
            {
                RedirectStandardInput = true,
                RedirectStandardOutput = true,
                StandardInputEncoding = new UTF8Encoding(false),
                StandardOutputEncoding = new UTF8Encoding(false),
            });
        }
        catch (System.ComponentModel.Win32Exception)
        {
            Assert.Ignore("there is no Node to run the page's worker");
        }
    }

    [OneTimeTearDown]
    public static void End()
    {
        _worker?.StandardInput.Close();
        _worker?.WaitForExit();
        _worker?.Dispose();
    }

    [TestCaseSource(typeof(LabelledScriptTests), nameof(LabelledScriptTests.Files))]
    public void A_script_of_the_sample_is_judged_as_on_the_command_line(string file) => MustBeAlike("zh", (Script, File.ReadAllBytes(TestData.Path(["submissions", .. file.Split('/')]))));

    [Test]
    public void Variations_of_a_right_script_are_judged_as_on_the_command_line()
    {
        // every twelfth: 22 of all kinds
        foreach (Variation variation in Variation.All().Where((_, at) => at % 12 == 0))
            MustBeAlike("en", (Script, Encoding.UTF8.GetBytes(variation.Text)));
    }

    [TestCase("float[] few = new float[2]; int at;", "few[++at] = 1;")]
    [TestCase("", "while (v.x < 100) v.y = 1;")]
    [TestCase("int Again(int i) => Again(i + 1) + 1;", "Again(1);")]
    [TestCase("", "new System.Net.Http.HttpClient().GetAsync(\"http://localhost\"); System.IO.File.Delete(\"a\"); System.Environment.Exit(0);")]
    [TestCase("", "new System.Threading.Thread(Update).Start(); GetType().Assembly.GetTypes(); dynamic d = 1;")]
    [TestCase("", "v = 0.5 * v; Vector3 u = v +;")]
    [TestCase("", "transform.rotation = transform.rotation + transform.rotation; x.y = 3; v.foo();")]
    public void What_is_stopped_or_refused_is_so_in_the_same_words(string members, string update) => MustBeAlike("en", (Script, Encoding.UTF8.GetBytes(Runner.With(members, update: update))));

    [Test]
    public void Packages_give_the_same_scripts()
    {
        foreach (string path in Directory.GetFiles(TestData.Path("submissions", "packages")).Order(StringComparer.Ordinal))
        {
            string name = Path.GetFileName(path);
            byte[] bytes = File.ReadAllBytes(path);
            IEnumerable<(string, string)> expected = Reader.Read(new Spot(name, [name]), bytes).SelectMany(piece => piece.Scripts)
                .Select(script => (script.Spot.Shown[(script.Spot.Shown.LastIndexOf('!') + 1)..], SourceText.Decode(script.Bytes).Text));
            // one that is refused has none
            JsonElement[] files = Ask("unpack", "en", (name, bytes)).TryGetProperty("files", out JsonElement found) ? [.. found.EnumerateArray()] : [];
            Assert.That(files.Select(file => (file.GetProperty("name").GetString()!, file.GetProperty("text").GetString()!)), Is.EqualTo(expected), name);
        }
    }

    private static void MustBeAlike(string language, params (string Name, byte[] Bytes)[] files)
    {
        ScriptReport report = Runner.Run(files);
        using JsonDocument verdict = JsonDocument.Parse(CheckJson.Of(Script, report));
        JsonElement answer = Ask("judge", language, files);
        // the page stops a loop by the clock, in any of its iterations, and the command line by the count of iterations
        Func<string, string> text = report.Verdict.Findings.Any(finding => finding.Code == "endless-loop") ? WithoutLines : found => found;
        Assert.That(text(answer.GetProperty("lines").GetString()!), Is.EqualTo(text(Lines(report, language))));
        Assert.That(text(JsonSerializer.Serialize(answer.GetProperty("verdict"))), Is.EqualTo(text(JsonSerializer.Serialize(verdict.RootElement))));
    }

    private static string WithoutLines(string text) => Regex.Replace(text, "第 [0-9]+ 行|line [0-9]+|\"line\":[0-9]+", "line");

    private static string Lines(ScriptReport report, string language)
    {
        TextWriter console = Console.Out;
        using StringWriter lines = new() { NewLine = "\n" };
        Console.SetOut(lines);
        try
        {
            Lamps.Print(Script, report, isChinese: language == "zh");
        }
        finally
        {
            Console.SetOut(console);
        }

        return lines.ToString().ReplaceLineEndings("\n");
    }

    private static JsonElement Ask(string what, string language, params (string Name, byte[] Bytes)[] files)
    {
        _worker!.StandardInput.WriteLine(JsonSerializer.Serialize(new
        {
            @do = what,
            language,
            names = files.Select(file => file.Name),
            lengths = files.Select(file => file.Bytes.Length),
            bytes = Convert.ToBase64String([.. files.SelectMany(file => file.Bytes)]),
        }));
        _worker.StandardInput.Flush();
        string answer = _worker.StandardOutput.ReadLine() ?? throw new InvalidOperationException("the worker has ended");
        return JsonDocument.Parse(answer).RootElement;
    }
}
