using System.Text;
using NUnit.Framework;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.StudentScripts;

namespace RigidBodyDynamics.Tests.StudentScripts;

/// <summary>Legitimate variations of honest scripts are no mistakes.</summary>
public sealed class ScriptTests
{
    [TestCase("using TreeEditor;")]
    [TestCase("using UnityEditor.Experimental.SceneManagement;\nusing TMPro;\nusing Unity.VisualScripting;")]
    [TestCase("using static UnityEditor.PlayerSettings;")]
    [TestCase("using System.IO;\nusing System.Threading;\nusing System.Reflection;")]
    [TestCase("using RigidBodyDynamics;")]
    public void Usings_that_an_editor_adds_do_no_harm(string usings) =>
        Assert.That(Runner.Run(Runner.With(above: usings)).Verdict.Outcome, Is.EqualTo(Outcome.Right));

    [TestCase("Vector3 n = new(1, 2, 3);", "")]
    [TestCase("", "Debug.Log($\"v = {v}\"); print(w); Console.WriteLine(v.x);")]
    [TestCase("void OnGUI() { GUI.Label(new Rect(0, 0, 100, 20), v.ToString()); }", "")]
    [TestCase("readonly List<Vector3> path = new List<Vector3>();", "if (path.Count < 100) path.Add(transform.position);")]
    [TestCase("", "var largest = new[] { v.x, v.y, v.z }.Select(Mathf.Abs).OrderBy(x => x).Last();")]
    [TestCase("IEnumerable<int> Three() { yield return 0; yield return 1; yield return 2; }", "foreach (int i in Three()) v[i] += 0;")]
    [TestCase("[SerializeField, Range(0, 1), Tooltip(\"t\")] float unused;", "try { throw new InvalidOperationException(\"x\"); } catch (InvalidOperationException e) { Debug.Log(e.Message); }")]
    [TestCase("enum Mode { On, Off } [Serializable] struct Pair { public int A; public Mode M; } Pair pair;", "pair.M = Mode.Off; pair.A = (int)pair.M;")]
    [TestCase("Vector3 Twice(Vector3 a) => a + a; float Half { get => 0.5f; set { } }", "v = Half * Twice(v);")]
    [TestCase("", "switch (Time.frameCount % 2) { case 0: goto case 1; case 1: break; }")]
    [TestCase("", "Application.targetFrameRate = 50; Debug.DrawRay(transform.position, v, Color.red);")]
    public void What_a_lab_script_may_use_is_allowed(string members, string update) =>
        Assert.That(Runner.Run(Runner.With(members, update: update)).Verdict.Outcome, Is.EqualTo(Outcome.Right));

    [TestCase("utf-16")]
    [TestCase("utf-16BE")]
    [TestCase("utf-8")]
    [TestCase("GB18030")]
    public void Text_is_read_as_it_was_saved(string encoding)
    {
        Assert.That(SourceText.Gbk.CodePage, Is.EqualTo(54936));
        string text = Runner.With("// 质量、速度和角速度\n");
        foreach (bool marked in new[] { false, true })
        {
            Encoding saved = Encoding.GetEncoding(encoding);
            byte[] bytes = [.. marked ? saved.GetPreamble() : [], .. saved.GetBytes(text)];
            Assert.That(SourceText.Decode(bytes).Text, Is.EqualTo(text));
        }
    }

    [Test]
    public void What_the_script_names_in_other_files_is_compiled_along_and_nothing_else()
    {
        ScriptReport report = Runner.Run(
            Of("Assets/Other.cs", "class Broken : NoSuchThing { void Update() { System.IO.File.Delete(\"x\"); } }"),
            Of("Assets/Large.cs", "class Large { string s = \"" + new string('x', 600_000) + "\"; }"),
            Of("Assets/Helper.cs", "public static class Helper { public static float Same(float x) => Twice.Half(x) * 2; }"),
            Of("Assets/Twice.cs", "public static class Twice { public static float Half(float x) => x / 2; }"),
            Of("Assets/Extensions.cs", "public static class More { public static float Also(this float x) => x; }"),
            Of("Assets/Delegates.cs", "public delegate float Change(float x);"),
            Of("Assets/MyRigidbody.cs", Runner.With(update: "Change change = x => Helper.Same(x).Also(); v.x = change(v.x);")));
        Assert.That((report.Verdict.Outcome, report.File), Is.EqualTo((Outcome.Right, "Assets/MyRigidbody.cs")));
    }

    [Test]
    public void Any_number_of_files_may_lie_beside_a_script_that_needs_none_of_them()
    {
        IEnumerable<(string, byte[])> samples = Enumerable.Range(0, 100).Select(i => Of($"Assets/Sample{i}.cs", $"class Sample{i} {{ }}"));
        Assert.That(Runner.Run([Of("Assets/MyRigidbody.cs", Runner.With()), .. samples]).Verdict.Outcome, Is.EqualTo(Outcome.Right));
    }

    [Test]
    public void Two_scripts_are_for_the_instructor()
    {
        byte[] script = Encoding.UTF8.GetBytes(Runner.With());
        Verdict verdict = Runner.Run(("a/MyRigidbody.cs", script), ("b/MyRigidbody.cs", script)).Verdict;
        Assert.That((verdict.Outcome, verdict.Findings.Single().Code), Is.EqualTo((Outcome.Doubtful, "two-scripts")));
    }

    [Test]
    public void Code_that_the_editor_never_compiles_is_shown_to_the_instructor()
    {
        Verdict verdict = Runner.Run(Runner.With(start: "\n#if !UNITY_EDITOR\nSystem.IO.File.Delete(\"x\");\n#endif\n")).Verdict;
        Assert.That((verdict.Outcome, verdict.Findings.Single().Code), Is.EqualTo((Outcome.Doubtful, "code-behind-if")));
    }

    [Test]
    public void What_Unity_has_and_the_stand_in_has_not_is_for_the_instructor()
    {
        Verdict verdict = Runner.Run(Runner.With(update: "float noise = Mathf.PerlinNoise(1, 2);")).Verdict;
        Assert.That((verdict.Findings.Single().Code, verdict.Findings.Single().IsDoubtful), Is.EqualTo(("not-in-the-stand-in", true)));
    }

    [TestCase("v = v + 0.5 * w;", "double-literal")]
    [TestCase("float a = 0.5;", "double-literal")]
    [TestCase("Quaternion p = transform.rotation + transform.rotation;", "no-quaternion-sum")]
    [TestCase("v = w", "missing-semicolon")]
    [TestCase("v = velocity;", "unknown-name")]
    [TestCase("v = transform.positon;", "unknown-member")]
    public void Mistakes_of_the_language_are_called_by_name(string update, string code)
    {
        Verdict verdict = Runner.Run(Runner.With(update: update)).Verdict;
        Assert.That((verdict.Outcome, verdict.Findings[0].Code), Is.EqualTo((Outcome.Refused, code)));
        Assert.That(verdict.Findings[0].Line, Is.EqualTo(34));
    }

    [Test]
    public void A_comment_of_the_starter_says_nothing_of_what_was_added()
    {
        string added = ScriptRunner.SheetStarter.Replace("// TODO 更新位置", "// TODO 更新位置\n        transform.position += v * dt;\n        //1\n        v.x += 0;\n        v.y += 0; // 无变化", StringComparison.Ordinal);
        CommentCoverage comments = Runner.Run(added).Comments;
        Assert.That((comments.Statements, comments.Commented, comments.Bare.Count), Is.EqualTo((3, 1, 2)));
        Assert.That(Runner.Run(ScriptRunner.SheetStarter).Comments.Statements, Is.Zero);
    }

    [Test]
    public void Tokens_leave_out_what_the_compiler_does_not_read()
    {
        IReadOnlyList<Token> tokens = Tokens.Of("int a; // comment\n#if NEVER\nint b;\n#endif\nint /* c */ d;");
        Assert.That(tokens.Select(token => token.Text), Is.EqualTo(new[] { "int", "a", ";", "int", "d", ";" }));
        Assert.That(tokens[^1].Line, Is.EqualTo(5));
    }

    [Test]
    public void The_same_script_gets_the_same_report()
    {
        string script = Runner.With(update: "v.x += UnityEngine.Random.value;");
        Verdict first = Runner.Run(script).Verdict, second = Runner.Run(script).Verdict;
        Assert.That(second.Findings.Select(finding => finding.English + finding.Found), Is.EqualTo(first.Findings.Select(finding => finding.English + finding.Found)));
    }

    private static (string Name, byte[] Bytes) Of(string name, string text) => (name, Encoding.UTF8.GetBytes(text));
}
