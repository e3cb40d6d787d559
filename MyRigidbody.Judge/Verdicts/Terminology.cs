using System.Collections.Generic;

namespace RigidBodyDynamics.Judging
{
    /// <summary>A name in both languages.</summary>
    public struct Term
    {
        public Term(string english, string chinese)
        {
            English = english;
            Chinese = chinese;
        }

        public string English { get; }

        public string Chinese { get; }
    }

    /// <summary>
    /// The names of the parts of a verdict, and the sheet's formulas: the same in the terminal, on all pages and in the editor.
    /// </summary>
    public static class Terminology
    {
        private static readonly Dictionary<Step, Term> Steps = new Dictionary<Step, Term>
        {
            [Step.Velocity] = new Term("velocity", "速度"),
            [Step.AngularVelocity] = new Term("angular velocity", "角速度"),
            [Step.Position] = new Term("position", "位置"),
            [Step.Orientation] = new Term("orientation", "朝向"),
            [Step.Damping] = new Term("damping", "阻尼"),
            [Step.Given] = new Term("given code", "给定代码"),
            [Step.Code] = new Term("code", "代码"),
            [Step.Package] = new Term("package", "文件"),
            [Step.Name] = new Term("name", "命名"),
        };

        private static readonly Dictionary<Mark, Term> Marks = new Dictionary<Mark, Term>
        {
            [Mark.Right] = new Term("right", "正确"),
            [Mark.Wrong] = new Term("wrong", "有误"),
            [Mark.Doubtful] = new Term("doubtful", "待定"),
            [Mark.Missing] = new Term("missing", "未完成"),
            [Mark.Unknown] = new Term("not seen", "未检查"),
        };

        private static readonly Dictionary<string, Term> Experiments = new Dictionary<string, Term>
        {
            ["lab"] = new Term("lab", "实验场景"),
            ["box"] = new Term("box", "长方体"),
            ["states"] = new Term("states", "不同状态"),
            ["frame rates"] = new Term("frame rates", "不同帧率"),
        };

        private static readonly Dictionary<Step, string> Formulas = new Dictionary<Step, string>
        {
            [Step.Velocity] = "v ← v + Δt F/m",
            [Step.AngularVelocity] = "ω ← ω + Δt (R I_ref Rᵀ)⁻¹ τ",
            [Step.Position] = "x ← x + Δt v",
            [Step.Orientation] = "q ← q + [0, ½Δt ω] q",
            [Step.Damping] = "v ← 0.98 v, ω ← 0.98 ω",
        };

        public static Term Of(Step step) => Steps[step];

        public static Term Of(Mark mark) => Marks[mark];

        /// <summary>The name of an experiment of <see cref="Judging.Experiments"/>; any other name is returned as it is.</summary>
        public static Term OfExperiment(string name) => Experiments.TryGetValue(name, out Term term) ? term : new Term(name, name);

        /// <summary>The sheet's formula for one of the five steps.</summary>
        public static string Formula(Step step) => Formulas[step];
    }
}
