using System.Globalization;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Languages;

namespace RigidBodyDynamics.Lab.Grading.Reading;

/// <summary>The problems of a submitted file, in words for the student and the instructor.</summary>
internal static class Problems
{
    public static Finding Truncated() => Of(
        "truncated", "The file is cut off and cannot be read to its end: please hand it in again.", "文件不完整（压缩流被截断），无法读到末尾，请重新提交。");

    public static Finding Checksum() => Of(
        "checksum", "The file is damaged at its end or inside: its checksum does not fit. What could be read was judged; please hand it in again.", "文件有损坏，校验值不符。已按能读出的内容评阅，请重新提交。");

    public static Finding Damaged(string reason) => Of(
        "damaged",
        $"The file cannot be read as what its name says ({reason.ReplaceLineEndings(" ").TrimEnd('.')}): please hand it in again.",
        $"文件无法按其扩展名读取（{Sentences.InChinese(reason.ReplaceLineEndings(" "))}），请重新提交。",
        reason.ReplaceLineEndings(" "));

    public static Finding Empty() => Of("empty", "The file is empty: please hand it in again.", "文件为空，请重新提交。");

    public static Finding Encrypted() => Of(
        "encrypted", "The archive asks for a password: please hand it in without one.", "压缩包需要密码，请提交没有密码的压缩包。");

    public static Finding NotRead(FileKind kind) => Of(
        "not-read",
        $"An archive of kind {FileKinds.Ending(kind)} is not read here: unpack it, or ask for a .unitypackage or .zip.",
        $"此处不读取 {FileKinds.Ending(kind)} 压缩包：请解压后再评，或让学生提交 .unitypackage 或 .zip。");

    public static Finding NoScript() => Of(
        "no-script", "There is no MyRigidbody.cs in it: was only the scene exported?", "其中没有 MyRigidbody.cs，是否只导出了场景？");

    public static Finding TooDeep() => Of(
        "nested-too-deep",
        $"There is an archive in an archive in an archive and so on; what is nested deeper than {Limits.Depth} is not read.",
        $"压缩包套压缩包，超过 {Limits.Depth} 层的部分没有读取。");

    public static Finding TooManyEntries() => Of(
        "too-many-entries",
        $"It has more than {Grouped(Limits.Entries)} entries and is not read: please export the scripts and the scene alone.",
        $"其中的文件超过 {Grouped(Limits.Entries)} 个，没有读取：请只导出脚本和场景。");

    public static Finding TooLarge(long bytes) => Of(
        "too-large",
        $"It is, or unpacks to, more than {bytes >> 20} MB and is not read: please export the scripts and the scene alone.",
        $"文件（或解压后）超过 {bytes >> 20} MB，没有读取：请只导出脚本和场景。");

    public static Finding ScriptTooLarge(string path) => Of(
        "script-too-large", $"A script larger than {Limits.Script >> 20} MB is not read.", $"超过 {Limits.Script >> 20} MB 的脚本没有读取。", path);

    public static Finding TooManyScripts() => Of(
        "too-many-scripts", $"It has more than {Limits.Scripts} scripts; the rest is not read.", $"其中的脚本超过 {Limits.Scripts} 个，其余的没有读取。");

    public static Finding Link(string path) => Of(
        "link", "It holds a link to another file, which is not followed.", "其中有指向其他文件的链接，没有跟随。", path);

    public static Finding PathOutside(string path) => Of(
        "path-outside", "It holds a file whose path leads out of the project; only its name is used.", "其中有路径指向工程之外的文件，只使用其文件名。", path);

    public static Finding WrongEnding(FileKind kind) => Of(
        "wrong-extension",
        $"By its content it is a {FileKinds.Ending(kind)}, and was read as one; its name says something else.",
        $"按内容它是 {FileKinds.Ending(kind)}，已按此读取，但扩展名不同。");

    public static Finding NotZipped() => Of(
        "not-gzipped", "The package is a tar that is not compressed, which Unity does not import; it was read all the same.", "该包是未经 gzip 压缩的 tar，Unity 无法导入；此处仍已读取。");

    public static Finding TwoScripts(IEnumerable<string> files) => Of(
        "two-scripts",
        "There are two MyRigidbody scripts that differ, and they are not judged alike: say which one counts.",
        "其中有两个内容不同的 MyRigidbody 脚本，请教师指定评哪一个。",
        string.Join(" | ", files)).ForInstructor();

    public static Finding Name(string found) => new(
        Step.Name, "not-named-as-asked", "学号_姓名.unitypackage", found,
        "The file is not called by student number and name, so nobody can tell whose it is.", "没有按 学号_姓名 命名，无法知道是谁提交的。");

    private static Finding Of(string code, string english, string chinese, string found = "") =>
        new(Step.Package, code, string.Empty, found, english, chinese);

    private static string Grouped(int number) => number.ToString("N0", CultureInfo.InvariantCulture);
}
