using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Languages;

namespace RigidBodyDynamics.Lab.Checking;

/// <summary>The texts of check; those of a finding belong to the finding.</summary>
internal static class CheckWords
{
    public static readonly IReadOnlyDictionary<string, Word> All = new Dictionary<string, Word>
    {
        ["step"] = new("step", "步骤"),
        ["formula"] = new("formula", "公式"),
        ["lamp"] = new("result", "结果"),
        ["line"] = new("line", "行"),
        ["outcome.Right"] = new("All five steps are right.", "五个步骤全部正确。"),
        ["outcome.Wrong"] = new("Not right yet.", "还有错误。"),
        ["outcome.Doubtful"] = new("Doubtful: the instructor decides.", "待定：由教师决定。"),
        ["outcome.Refused"] = new("The script was not run to its end, so its steps were not judged.", "脚本没有运行到底，因此没有检查步骤。"),
        ["at"] = new("line {0}", "第 {0} 行"),
        ["since"] = new("since frame {0} of \"{1}\"", "自实验“{1}”的第 {0} 帧起"),
        ["since.frame"] = new("in frame {0}", "第 {0} 帧"),
        ["measured"] = new("expected {0}; found {1}", "应为 {0}；实为 {1}"),
        ["doubt"] = new("an instructor decides", "由教师决定"),
        ["comments"] = new("Comments: {0} of {1} statements that were added have one.", "注释：新增的 {1} 条语句中，{0} 条有注释。"),
        ["comments.bare"] = new("Comments: {0} of {1} statements that were added have one; not so in line {2}.", "注释：新增的 {1} 条语句中，{0} 条有注释；没有注释的行：{2}。"),
        ["comments.none"] = new("Comments: nothing was added to the starter.", "注释：没有新增语句。"),
        ["file.right"] = new("File: {0}.", "文件名：{0}。"),
        ["file.other"] = new("File: {0}; Unity wants it to be called {1}, as the class in it is.", "文件名：{0}；Unity 要求与类名一致，应为 {1}。"),
        ["written"] = new("Written to {0}: {1}, to open in the browser", "已写入 {0}：{1}，可用浏览器打开"),
        ["script"] = new("script", "脚本"),
        ["reference"] = new("reference", "参考"),
        ["unity"] = new("Unity", "Unity"),
        ["cube"] = new("cube", "立方体"),
        ["box"] = new("box", "长方体"),
    };

    /// <summary>A part of a verdict, with its number if it is one of the sheet's steps.</summary>
    public static Word Name(Step step) =>
        Word.Of(Terminology.Of(step)) is var name && Verdict.FiveSteps.Contains(step) ? new Word($"{(int)step} {name.En}", $"{(int)step} {name.Zh}") : name;

    /// <summary>A mark with a sign that shows it without colour.</summary>
    public static Word Lamp(Mark mark)
    {
        Term term = Terminology.Of(mark);
        char sign = mark switch { Mark.Right => '✔', Mark.Wrong => '✘', Mark.Doubtful => '?', Mark.Missing => '○', _ => '·' };
        return new Word($"{sign} {term.English}", $"{sign} {term.Chinese}");
    }

    /// <summary>The place of a finding: line, frame, experiment.</summary>
    public static Word Place(Finding finding)
    {
        List<Word> parts = [];
        if (finding.Line is { } line)
            parts.Add(All["at"].With(line));
        if (finding.Since is { } frame)
            parts.Add(string.IsNullOrEmpty(finding.Experiment) ? All["since.frame"].With(frame) : All["since"].With(frame, Word.Of(Terminology.OfExperiment(finding.Experiment))));
        if (finding.IsDoubtful)
            parts.Add(All["doubt"]);

        return new Word(string.Join(", ", parts.Select(part => part.En)), string.Join("，", parts.Select(part => part.Zh)));
    }

    /// <summary>A finding about a step has an expected and a found value; a finding about code says all in its sentence.</summary>
    public static bool IsMeasured(Finding finding) => finding.Step <= Step.Damping;

    /// <summary>The number of added statements that have a comment.</summary>
    public static Word Comments(StudentScripts.CommentCoverage comments) =>
        comments.Statements == 0 ? All["comments.none"]
        : comments.Bare.Count == 0 ? All["comments"].With(comments.Commented, comments.Statements)
        : All["comments.bare"].With(comments.Commented, comments.Statements, string.Join(", ", comments.Bare.Distinct()));

    /// <summary>The file's name, and the name that it should have.</summary>
    public static Word FileName(string path) => Path.GetFileName(path) is var name && name == "MyRigidbody.cs"
        ? All["file.right"].With(name)
        : All["file.other"].With(name, "MyRigidbody.cs");
}
