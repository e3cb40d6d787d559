using System.Text;
using RigidBodyDynamics.Judging;

namespace RigidBodyDynamics.StudentScripts.Children;

/// <summary>The data in the pipes between the two processes: numbers and texts, with limits, never types.</summary>
internal static class Pipe
{
    /// <summary>The first number that a child sends.</summary>
    public const int Ready = 0x5C217;

    public const int MostBytes = 64 << 20;

    private const int MostFindings = 1000;

    public static void Write(BinaryWriter to, IReadOnlyList<ScriptFile> files)
    {
        to.Write(files.Count);
        foreach (ScriptFile file in files)
        {
            to.Write(file.Name);
            to.Write(file.Bytes.Length);
            to.Write(file.Bytes);
        }

        to.Flush();
    }

    public static IReadOnlyList<ScriptFile> ReadFiles(BinaryReader from)
    {
        ScriptFile[] files = new ScriptFile[from.ReadInt32()];
        for (int i = 0; i < files.Length; i++)
            files[i] = new ScriptFile(from.ReadString(), from.ReadBytes(from.ReadInt32()));

        return files;
    }

    public static void Write(BinaryWriter to, Finding finding)
    {
        to.Write((int)finding.Step);
        foreach (string text in new[] { finding.Code, finding.Expected, finding.Found, finding.English, finding.Chinese, finding.Experiment ?? string.Empty })
            to.Write(Short(text));

        to.Write(finding.Line ?? 0);
        to.Write(finding.Since ?? -1);
        to.Write(finding.IsDoubtful);
    }

    public static Finding ReadFinding(BinaryReader from)
    {
        Step step = (Step)from.ReadInt32();
        string code = from.ReadString(), expected = from.ReadString(), found = from.ReadString(), english = from.ReadString(), chinese = from.ReadString(), experiment = from.ReadString();
        int line = from.ReadInt32(), since = from.ReadInt32();
        Finding finding = new(step, code, expected, found, english, chinese);
        finding = since >= 0 ? finding.From(experiment, since) : finding;
        finding = from.ReadBoolean() ? finding.ForInstructor() : finding;
        return line > 0 ? finding.At(line) : finding;
    }

    public static void Write(BinaryWriter to, IReadOnlyList<Finding> findings)
    {
        to.Write(findings.Count);
        foreach (Finding finding in findings)
            Write(to, finding);
    }

    public static IReadOnlyList<Finding> ReadFindings(BinaryReader from)
    {
        Finding[] findings = new Finding[Checked(from.ReadInt32(), MostFindings)];
        for (int i = 0; i < findings.Length; i++)
            findings[i] = ReadFinding(from);

        return findings;
    }

    public static void Write(BinaryWriter to, byte[] bytes)
    {
        to.Write(bytes.Length);
        to.Write(bytes);
    }

    public static byte[] ReadBytes(BinaryReader from) => from.ReadBytes(Checked(from.ReadInt32(), MostBytes));

    /// <summary>A number that is neither negative nor too large.</summary>
    public static int Checked(int number, int most) => number >= 0 && number <= most ? number : throw new InvalidDataException();

    // a script can have names of any length
    private static string Short(string text) => text.Length <= 1000 ? text : new StringBuilder(text, 0, 1000, 1001).Append('…').ToString();
}
