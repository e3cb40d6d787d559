using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Grading.Marks;
using RigidBodyDynamics.Lab.Languages;

namespace RigidBodyDynamics.Lab.Grading;

/// <summary>All texts of the pages of a class, in both languages.</summary>
internal static class GradeWords
{
    /// <summary>By name.</summary>
    public static readonly IReadOnlyDictionary<string, Word> All = WithTerms(new()
    {
        ["language"] = new("中文", "English"),
        ["theme"] = new("Light / dark", "浅色/深色"),
        ["copy"] = new("Copy", "复制"),
        ["colon"] = new(": ", "："),

        ["class"] = new("Class: {0}", "班级：{0}"),
        ["class.lead"] = new(
            "{0} submissions: {1} right, {2} with something off, {3} in doubt, {4} that did not run.",
            "共 {0} 份提交：{1} 份正确，{2} 份有误，{3} 份待定，{4} 份未能运行。"),
        ["class.missing"] = new("{0} on the roster have handed in nothing.", "名单上有 {0} 人没有提交。"),
        ["class.files"] = new("The same as a table: marks.xlsx, marks.csv; for programs: grade.json.", "表格：marks.xlsx、marks.csv；供程序读取：grade.json。"),

        ["needs"] = new("Needs you", "需要您判断"),
        ["needs.lead"] = new(
            "Here a person decides. Until then nothing is taken off. Put the line that you mean into \"decisions\" of the file of --marks and run grade again; all other verdicts stay.",
            "以下由教师决定；决定之前不扣分。把所选的一行放进 --marks 文件的 \"decisions\" 中，再运行一次 grade 即可，其他结论不变。"),
        ["needs.doubt"] = new("In doubt", "待定"),
        ["needs.run"] = new("Did not run, or could not be read", "未能运行或无法读取"),
        ["needs.twice"] = new("Handed in more than once", "多次提交"),
        ["needs.whose"] = new("Whose is it", "不能确定是谁提交的"),
        ["needs.none"] = new("Nothing: no case is in doubt.", "没有待定的情况。"),
        ["needs.file"] = new("A file of --marks, to begin with", "--marks 文件的开头"),
        ["expected"] = new("expected", "应为"),
        ["found"] = new("found", "实为"),
        ["ask.old"] = new("A decision in the file of --marks is about another version of this script, so it was not used.", "--marks 文件中的决定针对的是此脚本的另一版本，因此没有采用。"),
        ["ask.twice"] = new("This student has more than one submission; another one of them counts.", "该学生有多份提交；目前计入成绩的是另一份。"),
        ["ask.twice.counts"] = new("This student has more than one submission; this one, of the most points, counts.", "该学生有多份提交；目前计入成绩的是这一份（分数最高）。"),
        ["ask.whose"] = new("No student number can be read from the name.", "文件名中读不出学号。"),
        ["ask.id"] = new("A name was found, and no student number.", "读出了姓名，但没有学号。"),
        ["ask.roster"] = new("The student is not on the roster.", "名单上没有这名学生。"),
        ["answer.right"] = new("it is right", "算正确"),
        ["answer.wrong"] = new("it is not", "算错误"),
        ["answer.use"] = new("take {0} ({1})", "采用 {0}（{1}）"),
        ["answer.points"] = new("give points by hand", "手动给分"),
        ["answer.counts"] = new("this one counts", "计入这一份"),
        ["answer.counts.not"] = new("this one does not", "不计这一份"),
        ["answer.student"] = new("say whose it is", "填写学号和姓名"),

        ["steps"] = new("Step by step", "各步结果"),
        ["student"] = new("student", "学生"),
        ["comments"] = new("comments", "注释"),
        ["points"] = new("points", "分数"),
        ["verdict"] = new("verdict", "结论"),
        ["steps.counts.not"] = new("does not count", "不计入"),
        ["outcome.right"] = new("right", "正确"),
        ["outcome.wrong"] = new("something is off", "有误"),
        ["outcome.doubtful"] = new("in doubt", "待定"),
        ["outcome.refused"] = new("did not run", "未能运行"),

        ["mistakes"] = new("The most frequent mistakes", "最常见的错误"),
        ["mistakes.none"] = new("Nothing was found off.", "没有发现错误。"),
        ["mistakes.rare"] = new("Those of fewer: {0}", "其余 {0} 项"),
        ["mistakes.what"] = new("what", "错误"),
        ["mistakes.count"] = new("submissions", "份数"),

        ["alike"] = new("Look at these side by side", "请对照查看"),
        ["alike.lead"] = new(
            "Pairs whose own tokens are the same over runs of {0}, whatever the names, after what the starter and many of the class have was taken out. The number is the share of the shorter one. It says nothing about why.",
            "忽略标识符名称，并去掉起始代码和全班多数人共有的部分后，连续 {0} 个记号相同的脚本对。数字是较短的一份中相同部分所占的比例，不说明原因。"),
        ["alike.none"] = new("No two submissions share that much.", "没有相似程度很高的提交。"),
        ["alike.more"] = new("{0} more pairs are in grade.json.", "另有 {0} 对，见 grade.json。"),

        ["missing"] = new("Nothing handed in", "没有提交"),
        ["missing.none"] = new("All on the roster have handed in something.", "名单上的学生都已提交。"),

        ["how"] = new("How points are given", "评分方法"),
        ["how.steps"] = new(
            "{0} for a step that is right or doubtful, none for one that is wrong, missing or not seen.",
            "正确或待定的步骤得分（{0}），有误、未完成或未检查的步骤不得分。"),
        ["how.comments"] = new("Up to {0} are taken off for added statements without a comment, in proportion.", "所加语句没有注释的，按比例扣分，最多 {0} 分。"),
        ["how.name"] = new("{0} are taken off where the submission is not called 学号_姓名.", "没有按 学号_姓名 命名的，扣 {0} 分。"),
        ["how.given"] = new("{0} are taken off where the given code was changed.", "改动了给定代码的，扣 {0} 分。"),
        ["how.default"] = new("Other points: \"points\" and \"deductions\" in the file of --marks.", "如需调整，在 --marks 文件中写 \"points\" 和 \"deductions\"。"),
        ["passed"] = new("Passed over in reading", "读取时跳过"),
        ["unused"] = new("Decisions about files that are not here", "所涉文件不存在的决定"),
        ["facts.version"] = new("Version", "版本"),

        ["student.of"] = new("of {0} points", "分，满分 {0} 分"),
        ["student.set"] = new("set by the instructor", "由教师给定"),
        ["student.line"] = new("line {0}", "第 {0} 行"),
        ["student.since"] = new("from frame {0} on", "自第 {0} 帧起"),
        ["student.experiment"] = new("from frame {0} of the experiment \"{1}\" on", "自实验“{1}”的第 {0} 帧起"),
        ["student.more"] = new("{0} more findings are in grade.json.", "另有 {0} 条，见 grade.json。"),
        ["student.comments"] = new("{0} of {1} added statements have a comment.", "所加的 {1} 条语句中，{0} 条有注释。"),
        ["student.comments.none"] = new("No added statements were found.", "没有发现所加的语句。"),
        ["student.uncommented"] = new("Without: lines {0}.", "没有注释的行：{0}。"),
        ["student.sum"] = new("Points", "分数"),
        ["student.sum.steps"] = new("steps", "步骤"),
        ["student.sum.comments"] = new("comments", "注释"),
        ["student.sum.name"] = new("name", "命名"),
        ["student.sum.given"] = new("given code", "给定代码"),
        ["student.sum.total"] = new("total", "合计"),
        ["student.note"] = new("Note of the instructor", "教师的话"),
        ["student.doubt"] = new("Your instructor decides about what is in doubt; nothing is taken off for it.", "待定之处由教师决定，不扣分。"),
        ["student.how"] = new(
            "Each step was run by itself, frame by frame, from the values that the script had before it.",
            "每一步都从脚本自己在该步之前的数值出发，逐帧单独检验。"),
    });

    private static Dictionary<string, Word> WithTerms(Dictionary<string, Word> words)
    {
        foreach (Step step in Enum.GetValues<Step>())
            words["step." + MarksFile.NameOf(step)] = Word.Of(Terminology.Of(step));

        foreach (Step step in Verdict.FiveSteps)
            words["formula." + MarksFile.NameOf(step)] = Word.Name(Terminology.Formula(step));

        foreach (Mark mark in Enum.GetValues<Mark>())
            words["mark." + MarksFile.NameOf(mark)] = Word.Of(Terminology.Of(mark));

        return words;
    }
}
