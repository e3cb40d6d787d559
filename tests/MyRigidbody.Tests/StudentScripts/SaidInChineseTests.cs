using NUnit.Framework;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Tests.Languages;

namespace RigidBodyDynamics.Tests.StudentScripts;

/// <summary>A student who reads only Chinese understands why his script does not compile, or breaks off.</summary>
public sealed class SaidInChineseTests
{
    // the errors that beginners make most
    [TestCase("CS1002", "int a = 1")]
    [TestCase("CS1026", "v *= Mathf.Sin(1;")]
    [TestCase("CS1525", "v = * 2;")]
    [TestCase("CS0103", "V = v;")]
    [TestCase("CS0246", "Vector4d a;")]
    [TestCase("CS0117", "v = Vector3.Zero;")]
    [TestCase("CS1061", "v.Normalise();")]
    [TestCase("CS0019", "bool b = v > w;")]
    [TestCase("CS0029", "int a = \"1\";")]
    [TestCase("CS0266", "int a = mass;")]
    [TestCase("CS0165", "int a; v *= a;")]
    [TestCase("CS0128", "int a = 1; int a = 2;")]
    [TestCase("CS0136", "float v = 1; for (int v = 0; v < 1; v++) { }")]
    [TestCase("CS0020", "int a = 1 / 0;")]
    [TestCase("CS1501", "v = Vector3.Cross(v);")]
    [TestCase("CS1503", "v *= Mathf.Sin(\"x\");")]
    [TestCase("CS7036", "v = Vector3.Cross(v);")]
    [TestCase("CS0200", "v.magnitude = 1;")]
    [TestCase("CS1612", "transform.position.x = 1;")]
    [TestCase("CS0201", "v + w;")]
    [TestCase("CS0127", "return v;")]
    [TestCase("CS0120", "Transform.Translate(v);")]
    [TestCase("CS0021", "float a = mass[0];")]
    [TestCase("CS0118", "Vector3 = v;")]
    [TestCase("CS0428", "v = v.ToString;")]
    public void Errors_of_the_compiler_are_said_in_Chinese(string _, string update)
    {
        IReadOnlyList<Finding> findings = Runner.Run(Runner.With(update: update)).Verdict.Findings;

        Assert.That(findings, Is.Not.Empty);
        Assert.That(findings.SelectMany(finding => EnglishSentences.In(finding.Chinese)), Is.Empty);
        Assert.That(findings.Select(finding => finding.English), Has.All.Contains("does not compile"));
    }

    [TestCase("GameObject none = null; none.SetActive(false);")]
    [TestCase("int[] a = new int[2]; a[2] = 1;")]
    [TestCase("List<int> a = new List<int>(); a[0] = 1;")]
    [TestCase("int none = 0; int a = 1 / none;")]
    [TestCase("object a = 1; string b = (string)a;")]
    [TestCase("int a = int.Parse(\"x\");")]
    [TestCase("int a = new Dictionary<string, int>()[\"x\"];")]
    [TestCase("throw new NotImplementedException();")]
    public void What_ends_a_script_is_said_in_Chinese(string update)
    {
        IReadOnlyList<Finding> findings = Runner.Run(Runner.With(update: update)).Verdict.Findings;

        Assert.That(findings, Is.Not.Empty);
        Assert.That(findings.SelectMany(finding => EnglishSentences.In(finding.Chinese)), Is.Empty);
    }
}
