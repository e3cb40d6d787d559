using System.Diagnostics;
using NUnit.Framework;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.StudentScripts;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.Tests.StudentScripts;

/// <summary>Scripts that use forbidden names, never end, or exhaust the memory: each is stopped, named, and leaves no trace.</summary>
public sealed class HostileScriptTests
{
    private static readonly string Left = Path.Combine(Path.GetTempPath(), "script-was-here");

    // members, start, what is said
    private static readonly (string Name, string Members, string Start, string Code)[] Forbidden =
    [
        ("a file", "", "System.IO.File.WriteAllText(\"/tmp/script-was-here\", \"x\");", "file"),
        ("a file by unicode escapes", "", "System.IO.F\\u0069le.WriteAllText(\"/tmp/script-was-here\", \"x\");", "file"),
        ("a stream", "", "new System.IO.FileStream(\"/tmp/script-was-here\", System.IO.FileMode.Create).Dispose();", "file"),
        ("a method group", "", "Action<string, string> a = System.IO.File.WriteAllText; a(\"/tmp/script-was-here\", \"x\");", "file"),
        ("a delegate of a method group in a field", "Func<string, string> read = System.IO.File.ReadAllText;", "", "file"),
        ("a static constructor", "static MyRigidbody() { System.IO.File.WriteAllText(\"/tmp/script-was-here\", \"x\"); }", "", "file"),
        ("a field's initializer", "System.IO.DirectoryInfo made = System.IO.Directory.CreateDirectory(\"/tmp/script-was-here\");", "", "file"),
        ("the end of the process", "", "Environment.Exit(0);", "process"),
        ("a crash of the process", "", "Environment.FailFast(\"x\");", "process"),
        ("the environment", "string path = Environment.GetEnvironmentVariable(\"PATH\");", "", "process"),
        ("a process", "", "System.Diagnostics.Process.Start(\"touch\", \"/tmp/script-was-here\");", "process"),
        ("the engine's end", "", "Application.Quit();", "process"),
        ("a thread", "", "new System.Threading.Thread(() => { while (true) { } }).Start();", "thread"),
        ("a task", "", "System.Threading.Tasks.Task.Run(() => { while (true) { } });", "thread"),
        ("sleep", "", "System.Threading.Thread.Sleep(100000);", "thread"),
        ("an asynchronous method", "async System.Threading.Tasks.Task Go() { await System.Threading.Tasks.Task.Delay(1); }", "", "thread"),
        ("reflection", "", "GetType().Assembly.GetTypes();", "reflection"),
        ("reflection by a delegate", "", "Action a = () => { }; var m = a.Method.Module;", "reflection"),
        ("reflection by an error", "", "var s = new Exception().TargetSite;", "reflection"),
        ("an activator", "", "Activator.CreateInstance(typeof(object));", "reflection"),
        ("dynamic", "", "dynamic d = 1; d.ToString();", "dynamic"),
        ("DllImport", "[System.Runtime.InteropServices.DllImport(\"libc\")] static extern int system(string c);", "system(\"touch /tmp/script-was-here\");", "native"),
        ("a pointer", "unsafe int* p;", "", "unsafe"),
        ("stackalloc", "", "Span<int> s = stackalloc int[100000000];", "unsafe"),
        ("a typed reference", "", "int i = 0; TypedReference t = __makeref(i);", "unsafe"),
        ("a finalizer", "~MyRigidbody() { while (true) { } }", "", "finalizer"),
        ("a module initializer", "[System.Runtime.CompilerServices.ModuleInitializer] internal static void Go() { }", "", "native"),
        ("the network", "", "new System.Net.Sockets.TcpClient(\"127.0.0.1\", 80);", "network"),
        ("the collector", "", "GC.Collect();", "process"),
        ("standard output", "", "Console.OpenStandardOutput().WriteByte(1);", "not-allowed"),
        ("expression trees", "", "System.Linq.Expressions.Expression<Func<int>> e = () => 1; e.Compile();", "reflection"),
        ("Unity's body", "", "gameObject.AddComponent<Rigidbody>();", "uses-rigidbody"),
        ("the library", "RigidBodyDynamics.Vector3d x;", "", "uses-library"),
        ("the stand-in's player", "", "RigidBodyDynamics.Engine.World.End();", "uses-library"),
        ("the other body", "DefaultRigidbody other;", "transform.position = other.transform.position;", "uses-default-rigidbody"),
        ("another object", "", "transform.position = GameObject.Find(\"Cube (1)\").transform.position;", "uses-another-object"),
        ("a coroutine", "System.Collections.IEnumerator Go() { yield return null; }", "StartCoroutine(Go());", "coroutine"),
    ];

    // members, statements of Update, what is said
    private static readonly (string Name, string Members, string Update, string Code)[] Endless =
    [
        ("a loop", "", "while (true) { }", "endless-loop"),
        ("a loop that catches", "", "while (true) { try { while (true) { } } catch { } }", "endless-loop-that-catches"),
        ("a loop that catches by type", "", "for (;;) try { for (;;) ; } catch (Exception) { continue; } finally { }", "endless-loop-that-catches"),
        ("goto", "", "again: goto again;", "endless-loop"),
        ("a loop in a property", "int P { get { while (true) { } } }", "int i = P;", "endless-loop"),
        ("a loop in an expression body", "int N(int n) { for (;;) n++; }", "Func<int> f = () => N(1); f();", "endless-loop"),
        ("recursion", "void Go() { Go(); }", "Go();", "endless-recursion"),
        ("recursion that catches", "void Go() { try { Go(); } catch { Go(); } }", "Go();", "endless-recursion"),
        ("recursion by a lambda", "Func<int, int> f;", "f = n => f(n + 1) + 1; f(0);", "endless-recursion"),
        ("recursion by an operator", "struct S { public static S operator +(S a, S b) => a + b; }", "S s = new S() + new S();", "endless-recursion"),
        ("recursion by a constructor", "class C { C c = new C(); }", "new C();", "endless-recursion"),
        ("recursion by generic types", "class G<T> { public static int F(int n) => n > 1000000 ? 0 : G<G<T>>.F(n + 1) + 1; }", "G<int>.F(0);", "endless"),
        ("numbers without end", "IEnumerable<int> All() { while (true) yield return 1; }", "foreach (int i in All()) ;", "endless-loop"),
        ("a query over more than there is time for", "", "int n = Enumerable.Repeat(1L, int.MaxValue).Concat(Enumerable.Repeat(1L, int.MaxValue)).Concat(Enumerable.Repeat(1L, int.MaxValue)).Concat(Enumerable.Repeat(1L, int.MaxValue)).Concat(Enumerable.Repeat(1L, int.MaxValue)).Concat(Enumerable.Repeat(1L, int.MaxValue)).Where(x => x > 0).Aggregate(0, (a, b) => a);", "endless-loop"),
    ];

    // kinds of sources, the slowest last
    private static readonly int[] Bombs = Search.In([2, 3, 4, 0, 1], 5);

    private static readonly (string Name, string Members, string Update)[] Large =
    [
        ("a large array", "", "try { var a = new double[2000000000]; } catch { }"),
        ("many arrays", "List<byte[]> all = new List<byte[]>();", "for (int i = 0; i < 1000; i++) all.Add(new byte[1000000]);"),
        ("a text that doubles", "", "string s = \"xxxxxxxxxxxxxxxx\"; try { while (true) s += s; } catch { }"),
        ("a list that grows", "List<long> all = new List<long>();", "for (int i = 0; i < 4000000; i++) all.Add(i);"),
    ];

    [TestCaseSource(nameof(Names), new object[] { 0 })]
    public void What_reaches_for_more_is_not_run(string name)
    {
        (_, string members, string start, string code) = Forbidden.First(script => script.Name == name);

        Assert.That(Codes(Runner.With(members, start)), Does.Contain(code));
        Assert.That(File.Exists(Left) || Directory.Exists(Left), Is.False);
    }

    [TestCaseSource(nameof(Names), new object[] { 1 })]
    public void What_does_not_end_is_stopped(string name)
    {
        (_, string members, string update, string code) = Endless.First(script => script.Name == name);

        ScriptReport[] both = Runner.InTurn(Runner.With(members, update: update), Runner.With());

        Assert.That(Codes(both[0]).Single(), Does.StartWith(code));
        Assert.That(both[1].Verdict.Outcome, Is.EqualTo(Outcome.Right), "the next script");
    }

    [TestCaseSource(nameof(Names), new object[] { 2 })]
    public void What_takes_all_memory_is_stopped(string name)
    {
        (_, string members, string update) = Large.First(script => script.Name == name);

        ScriptReport[] both = Runner.InTurn(Runner.With(members, update: update), Runner.With());

        Assert.That(Codes(both[0]), Is.EqualTo(new[] { "memory" }));
        Assert.That(both[1].Verdict.Outcome, Is.EqualTo(Outcome.Right), "the next script");
    }

    [Test]
    public void A_file_by_using_static_is_not_written() =>
        Assert.That(Codes(Runner.With(start: "WriteAllText(\"/tmp/script-was-here\", \"x\");", above: "using static System.IO.File;")), Does.Contain("file"));

    [Test]
    public void A_file_by_an_alias_is_not_written() =>
        Assert.That(Codes(Runner.With(start: "F.WriteAllText(\"/tmp/script-was-here\", \"x\");", above: "using F = System.IO.File;")), Does.Contain("file"));

    [Test]
    public void An_exception_is_told_with_its_line()
    {
        Finding thrown = Runner.Run(Runner.With("int[] a = new int[2];\nint At => a[5];", update: "int i = At;")).Verdict.Findings.Single();
        Assert.That((thrown.Code, thrown.Line), Is.EqualTo(("throws", (int?)12)));
        Assert.That(thrown.Found, Does.Contain("IndexOutOfRange"));
    }

    [Test]
    public void Statics_begin_anew_with_every_object()
    {
        string counting = Runner.With("static List<int> frames = new List<int>(); static string s; int mine;", "mine = frames.Count; s += \"x\"; if (mine > 0 || s != \"x\") mass = 2;", "frames.Add(1);");
        Assert.That(Runner.Run(counting).Verdict.Outcome, Is.EqualTo(Outcome.Right));
    }

    [Test]
    public void What_a_script_does_to_the_engine_no_other_script_sees()
    {
        string careless = Runner.With(start: "Time.timeScale = 0; Time.fixedDeltaTime = 1; GetComponent<MeshFilter>().sharedMesh.vertices = new Vector3[1]; GetComponent<MeshFilter>().mesh = null;");
        Assert.That(Runner.InTurn(careless, Runner.With())[1].Verdict.Outcome, Is.EqualTo(Outcome.Right));
    }

    // whatever their result, the next script is judged normally
    [TestCaseSource(nameof(Bombs))]
    public void A_source_that_breaks_compilers_is_refused(int kind)
    {
        string bomb = kind switch
        {
            0 => "int i = " + new string('(', 20000) + "1" + new string(')', 20000) + ";",
            1 => "int i = 1" + string.Concat(Enumerable.Repeat(" + 1", 60000)) + " + \"\";",
            2 => string.Concat(Enumerable.Repeat("{", 30000)) + string.Concat(Enumerable.Repeat("}", 30000)),
            3 => string.Concat(Enumerable.Repeat("if (true) ", 30000)) + ";",
            _ => string.Concat(Enumerable.Repeat("Func<int, int> f = x => ", 1)) + string.Concat(Enumerable.Repeat("((Func<int, int>)(y => ", 3000)) + "1" + string.Concat(Enumerable.Repeat("))(1)", 3000)) + ";",
        };

        ScriptReport[] both = Runner.InTurn(Runner.With(update: bomb), Runner.With());

        Assert.That(both[0].Verdict.Outcome, Is.EqualTo(Outcome.Refused).Or.EqualTo(Outcome.Right));
        Assert.That(both[1].Verdict.Outcome, Is.EqualTo(Outcome.Right));
    }

    [Test]
    public void A_megabyte_is_no_script() =>
        Assert.That(Codes(Runner.With() + new string(' ', 1_000_000)), Is.EqualTo(new[] { "too-large" }));

    [Test]
    public void Every_answer_is_about_its_own_script()
    {
        byte[] large = new byte[600_000], none = [];
        Runner.On(runner =>
        {
            for (int i = 0; i < 300; i++)
            {
                Assert.That(runner.Run(Runner.Files(($"{i}.cs", large))).Verdict.Findings.Single().Found, Is.EqualTo($"{i}.cs"));
                Assert.That(runner.Run(Runner.Files(($"{i}.cs", none))).Verdict.Findings.Single().Code, Is.EqualTo("no-script"));
            }

            return true;
        });
    }

    [Test]
    public void Bytes_that_are_no_text_are_no_script()
    {
        byte[] noise = new byte[5000];
        new Random(1).NextBytes(noise);
        Assert.That(Runner.Run(("MyRigidbody.cs", noise)).Verdict.Findings.Single().Code, Is.EqualTo("no-script"));
    }

    [Test]
    public void No_folder_is_left_behind()
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("MyRigidbody.cs"), Runner.With());

        // every process has its temporary files in a folder of its own here
        LabProcess check = LabProcess.Run(folder.Path, new() { ["TMPDIR"] = folder.Path, ["TEMP"] = folder.Path, ["TMP"] = folder.Path }, ["check", "MyRigidbody.cs"]);

        Assert.That(check.Output, Is.Not.Empty, check.Error);
        Assert.That(Directory.GetDirectories(folder.Path), Is.Empty);
    }

    // an instructor's Ctrl-C sends the signal to the child too: to the whole group; who runs the tests in the background of a shell ignores it
    [TestCase("INT")]
    [TestCase("TERM")]
    [Platform("Linux")]
    public void No_folder_is_left_behind_by_a_signal(string signal)
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("MyRigidbody.cs"), Runner.With());
        ProcessStartInfo start = new("setsid", ["env", "--default-signal=INT,TERM", "dotnet", Path.Combine(AppContext.BaseDirectory, "MyRigidbody.Lab.dll"), "check", "--watch", "MyRigidbody.cs"])
        {
            WorkingDirectory = folder.Path,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        start.Environment["TMPDIR"] = folder.Path;
        using Process watching = Process.Start(start)!;
        string? first = watching.StandardOutput.ReadLine();
        string[] during = Directory.GetDirectories(folder.Path);
        using Process kill = Process.Start("sh", ["-c", $"kill -s {signal} -- -{watching.Id}"]);
        bool ended = watching.WaitForExit(TimeSpan.FromMinutes(2));
        if (!ended)
            watching.Kill(entireProcessTree: true);

        Assert.That(ended, Is.True);
        Assert.That(first, Is.Not.Null);
        Assert.That(during, Has.Length.EqualTo(1));
        Assert.That(Directory.GetDirectories(folder.Path), Is.Empty);
    }

    private static IEnumerable<string> Names(int list) =>
        list == 0 ? Forbidden.Select(script => script.Name) : list == 1 ? Endless.Select(script => script.Name) : Large.Select(script => script.Name);

    private static IEnumerable<string> Codes(string script) => Codes(Runner.Run(script));

    private static IEnumerable<string> Codes(ScriptReport report)
    {
        Assert.That(report.Verdict.Outcome, Is.EqualTo(Outcome.Refused));
        return report.Verdict.Findings.Select(finding => finding.Code);
    }
}
