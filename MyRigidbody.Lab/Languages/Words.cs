using RigidBodyDynamics.Judging;

namespace RigidBodyDynamics.Lab.Languages;

/// <summary>A text in the two languages of a page.</summary>
internal sealed record Word(string En, string Zh)
{
    /// <summary>A name, which is the same in all languages.</summary>
    public static Word Name(string name) => new(name, name);

    /// <summary>The judge's name for something.</summary>
    public static Word Of(Term term) => new(term.English, term.Chinese);

    /// <summary>The text in one language.</summary>
    public string In(bool chinese) => chinese ? Zh : En;

    /// <summary>With values in the places {0}, {1}, ....</summary>
    public Word With(params object[] parts) => new(Put(En, parts, word => word.En), Put(Zh, parts, word => word.Zh));

    private static string Put(string text, object[] parts, Func<Word, string> language) =>
        string.Format(System.Globalization.CultureInfo.InvariantCulture, text, [.. parts.Select(part => part is Word word ? language(word) : part)]);
}

/// <summary>Every text of the page, in both languages.</summary>
internal static class Words
{
    /// <summary>The texts of the template and the sections.</summary>
    public static readonly IReadOnlyDictionary<string, Word> All = new Dictionary<string, Word>
    {
        ["language"] = new("中文", "English"),
        ["theme"] = new("Light / dark", "浅色/深色"),
        ["skip"] = new("Skip to: {0}", "跳到：{0}"),
        ["noscript"] = new("Replay and plots need JavaScript; the tables do not.", "回放和曲线图需要 JavaScript，表格不需要。"),

        ["replay"] = new("Replay", "回放"),
        ["replay.label"] = new(
            "The bodies in three dimensions. Drag or Shift with arrow keys to look around, wheel or plus and minus to zoom.",
            "刚体的三维画面。拖动鼠标或按 Shift 加方向键旋转视角，滚轮或加减号缩放。"),
        ["replay.keys"] = new(
            "Space: play or pause. ← →: a picture back or on. Home, End: start, end. Drag: look around. Wheel, + −: zoom. 0: reset the view.",
            "空格：播放或暂停。← →：后退或前进一帧。Home、End：开头、结尾。拖动：旋转视角。滚轮、+ −：缩放。0：恢复视角。"),
        ["thinned"] = new(
            "Of {0} steps, {1} evenly chosen moments are shown; the last one is among them. In between, the pictures are interpolated.",
            "共 {0} 步，均匀选取了 {1} 个时刻显示（包括最后时刻）；中间的画面由插值得到。"),
        ["fewer.bodies"] = new("Of {0} bodies, the first {1} are shown.", "共 {0} 个刚体，显示前 {1} 个。"),

        ["check"] = new("The five steps", "五个步骤"),

        ["plots"] = new("Over time", "随时间变化"),
        ["plots.label"] = new("Curves over time; the same numbers are in {0}.", "随时间变化的曲线；同样的数据在 {0} 中。"),
        ["plots.run"] = new("Curves over time; the table that run writes has the same numbers.", "随时间变化的曲线；run 命令写出的表格中有同样的数据。"),
        ["plots.how"] = new(
            "The line is the time of the replay; a click sets it. Drag to zoom in, double-click to go back.",
            "竖线是回放的时刻，点击可设定。拖动放大，双击还原。"),

        ["rules"] = new("Where and why they differ", "在哪里、为什么不同"),
        ["rules.lead"] = new(
            "On average over the run, {0} and {1} are {2} m apart, and one has turned {3}° further than the other.",
            "在整个过程中，{0} 与 {1} 平均相距 {2} m，累计转角平均相差 {3}°。"),
        ["rules.caption"] = new("The share of each rule in the difference", "每条规则对差别的贡献"),
        ["rules.note"] = new(
            "The rules are exchanged one after another, from {0}'s to {1}'s. A share is how far the exchange moves the body on the way, on average over the run; below zero where it takes back what another gives. Whole turns are counted.",
            "从 {0} 的规则到 {1} 的规则，逐条替换。“份额”是替换一条规则使刚体沿两者连线移动的平均距离；为负时，抵消了其他规则的一部分。整圈转动计算在内。"),
        ["rule"] = new("rule", "规则"),
        ["share.distance"] = new("share of the distance", "距离的份额"),
        ["share.turn"] = new("share of the turn", "转角的份额"),
        ["all"] = new("all", "合计"),
        ["cost.page"] = new("Accuracy against time", "精度与时间"),
        ["cost"] = new("What accuracy costs", "精度的代价"),
        ["cost.lead"] = new(
            "Every point is an integrator in steps of one length: how wrong it is at its worst over the whole motion, and how long it takes for a simulated second. Down and left is better. An integrator's own drag and limits count as its error.",
            "每个点是一个积分器在一个步长下的结果：整个运动中的最大误差，以及模拟一秒所需的时间。越靠左下越好。积分器自带的阻尼和限制也计入误差。"),
        ["cost.origin"] = new("Compared with: {0}. Attainable in double: {1}.", "参照：{0}。双精度可达：{1}。"),
        ["cost.slider"] = new("the error you can bear", "可以接受的误差"),
        ["cost.caption"] = new("Every integrator in steps of about 1/50 s, and what an accuracy costs by it", "各积分器在约 1/50 秒步长下的误差与耗时，以及达到各精度的代价"),
        ["cost.rule"] = new("integrator", "积分器"),
        ["cost.game"] = new("error at 1/50 s, rad or m", "1/50 秒时的误差，rad 或 m"),
        ["cost.step"] = new("ns a step", "每步纳秒"),
        ["cost.lab"] = new("steps of the lab", "相当于 LabEuler 的步数"),
        ["cost.to"] = new("to {0}, µs per s", "达到 {0}，每秒微秒"),

        ["frames.caption"] = new(
            "{0}, when AddForce is called in Update instead of FixedUpdate",
            "{0}：在 Update 而不是 FixedUpdate 中调用 AddForce 时"),
        ["frames.rate"] = new("frames a second", "每秒帧数"),
        ["frames.push"] = new("arrow force, times", "方向键的推力，倍"),
        ["frames.turn"] = new("“r” torque, times", "“r”键的力矩，倍"),
        ["frames.distance"] = new("apart at the end", "结束时相距"),
        ["frames.turned"] = new("turns differ by", "转角相差"),

        ["recording"] = new("How far from the recording", "与录制的差别"),
        ["recording.same"] = new(
            "{0} repeats all {1} steps of the recording bit for bit.", "{0} 逐位重现了录制的全部 {1} 步。"),
        ["recording.parts"] = new("{0} first differs from the recording at {1}.", "{0} 与录制首次不同：{1}。"),
        ["recording.within"] = new("The largest difference, {0}, is within the tolerance of {1}.", "最大差别 {0} 不超过容差 {1}。"),
        ["recording.beyond"] = new("The largest difference, {0}, is above the tolerance of {1}: the comparison fell short.", "最大差别 {0} 超过容差 {1}：比较未达到要求。"),
        ["recording.caption"] = new("Largest differences", "最大差别"),
        ["recording.of"] = new("of", "量"),
        ["recording.largest"] = new("largest difference", "最大差别"),
        ["recorded"] = new("{0} (recorded)", "{0}（录制）"),

        ["plan"] = new("What each motion consists of", "每个运动的组成"),
        ["plan.lead"] = new(
            "What stands here is what is computed; what is left out costs nothing.", "这里列出的就是实际计算的内容；省去的部分不花任何时间。"),
        ["plan.by"] = new("{0}, by {1}", "{0}，积分器 {1}"),
        ["plan.together"] = new("{0} ({1} bodies)", "{0}（{1} 个刚体）"),
        ["plan.when"] = new("when", "时间"),
        ["plan.what"] = new("what moves it", "运动的组成"),
        ["plan.more"] = new("and {0} more", "以及另外 {0} 项"),
        ["plan.coasts"] = new("computed when its state is read", "读取状态时才计算"),
        ["plan.left"] = new("Left out", "省去的部分"),
        ["plan.note"] = new("Note", "注意"),

        ["facts"] = new("How this page was made", "本页的来历"),
        ["facts.caption"] = new("Scene, steps, machine", "场景、步长、机器"),
        ["facts.scene"] = new("scene", "场景"),
        ["facts.file"] = new("file", "文件"),
        ["facts.steps"] = new("steps", "步数"),
        ["facts.equal"] = new("{0} of {1} s, {2} s in all", "{0} 步，每步 {1} s，共 {2} s"),
        ["facts.unequal"] = new("{0} of different lengths, {1} s in all", "{0} 步，长度不等，共 {1} s"),
        ["facts.shown"] = new("moments shown", "显示的时刻"),
        ["facts.command"] = new("command", "命令"),
        ["facts.version"] = new("version", "版本"),
        ["facts.machine"] = new("machine", "机器"),
        ["facts.processors"] = new("{0}, {1}, {2} processors", "{0}，{1}，{2} 个处理器"),
    };

    /// <summary>Labels that scripts set.</summary>
    public static readonly IReadOnlyDictionary<string, Word> OfScripts = new Dictionary<string, Word>
    {
        ["cost.time"] = new("time for a simulated second of one body, s", "一个刚体模拟一秒所需的时间，s"),
        ["cost.error"] = new("largest error, rad or m", "最大误差，rad 或 m"),
        ["cost.point"] = new("{0}, steps of {1} s<br>error {2}, {3} µs a second", "{0}，步长 {1} s<br>误差 {2}，每秒 {3} µs"),
        ["cost.wanted"] = new("Below {0}:", "低于 {0}："),
        ["cost.best"] = new("{0} in steps of {1} s, {2} µs a simulated second, error {3}.", "{0}，步长 {1} s，模拟一秒 {2} µs，误差 {3}。"),
        ["cost.none"] = new("none of these integrators and steps.", "这些积分器和步长都达不到。"),
        ["cost.attainable"] = new("attainable in double", "双精度可达"),
        ["cost.others"] = new("other engines, 1/50 s", "其他引擎，1/50 秒"),

        ["table.more"] = new("The table goes on to the right: scroll it.", "表格右侧还有内容，可横向滚动。"),

        ["play"] = new("Play", "播放"),
        ["pause"] = new("Pause", "暂停"),
        ["time"] = new("Time", "时间"),
        ["speed"] = new("Speed", "速度"),
        ["camera"] = new("Camera", "镜头"),
        ["camera.all"] = new("all bodies", "全部刚体"),
        ["camera.path"] = new("whole path", "整个路径"),
        ["camera.body"] = new("follow {0}", "跟随 {0}"),
        ["arrange"] = new("Place", "位置"),
        ["arrange.side"] = new("side by side", "并排"),
        ["arrange.place"] = new("where they are", "原位"),
        ["reset"] = new("Reset view", "恢复视角"),
        ["trails"] = new("Trails", "轨迹"),
        ["arrows"] = new("ω and L", "ω 和 L"),
        ["close"] = new("Close-ups", "特写"),
        ["key.LeftArrow"] = new("left arrow", "左方向键"),
        ["key.RightArrow"] = new("right arrow", "右方向键"),
        ["key.UpArrow"] = new("up arrow", "上方向键"),
        ["key.DownArrow"] = new("down arrow", "下方向键"),
        ["key.R"] = new("key r", "r 键"),
        ["grid"] = new("grid {0} m", "网格 {0} m"),
        ["dots"] = new("a dot every {0} s", "每 {0} s 一个点"),
        ["axis.time"] = new("time, s", "时间，s"),
        ["axis.angle"] = new("angle between, °", "夹角，°"),
        ["axis.distance"] = new("distance, m", "距离，m"),
        ["axis.spin"] = new("angular velocities apart, rad/s", "角速度之差，rad/s"),
        ["axis.energy"] = new("kinetic energy, J", "动能，J"),
        ["axis.momentum"] = new("abs(L), kg m²/s", "角动量 |L|，kg m²/s"),
        ["between"] = new("{0} and {1}", "{0} 与 {1}"),
    };

    /// <summary>An English sentence of the program, in both languages.</summary>
    public static Word Said(string english) => new(english, Sentences.InChinese(english));

    /// <summary>A phrase of a plan or an integrator, in both languages; unknown phrases stay English.</summary>
    public static Word Phrase(string english)
    {
        string chinese = Phrases.Known.Aggregate(english, (text, phrase) => phrase.Pattern.Replace(text, phrase.Chinese));
        return new Word(english, chinese);
    }
}
