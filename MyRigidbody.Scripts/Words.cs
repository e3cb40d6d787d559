using RigidBodyDynamics.Judging;

namespace RigidBodyDynamics.StudentScripts;

/// <summary>The sentences about a script's code, in English and Chinese; those about its steps are the judge's.</summary>
internal static class Words
{
    private static readonly Dictionary<string, (string English, string Chinese)> Reached = new()
    {
        ["file"] = ("reaches for files", "访问文件"),
        ["process"] = ("reaches for the process or its surroundings", "访问进程或运行环境"),
        ["network"] = ("reaches for the network", "访问网络"),
        ["thread"] = ("starts or waits for threads", "使用线程"),
        ["reflection"] = ("uses reflection", "使用反射"),
        ["native"] = ("calls code outside .NET", "调用 .NET 以外的代码"),
        ["unsafe"] = ("works with addresses", "使用指针等不安全代码"),
        ["dynamic"] = ("uses dynamic", "使用 dynamic"),
        ["finalizer"] = ("has a finalizer", "使用析构函数"),
        ["not-allowed"] = ("uses what the lab does not need", "使用了实验不需要的功能"),
    };

    private static readonly Dictionary<string, (string English, string Chinese)> Helped = new()
    {
        ["uses-rigidbody"] = ("Unity's own body does the work", "由 Unity 自带的刚体代为计算"),
        ["uses-library"] = ("a library does the work", "由现成的库代为计算"),
        ["uses-default-rigidbody"] = ("the motion of DefaultRigidbody is used", "使用了 DefaultRigidbody 的运动"),
        ["uses-another-object"] = ("another object of the scene is looked up", "查找了场景中的其他对象"),
    };

    // the runtime says what its own exceptions mean in English alone
    private static readonly Dictionary<string, string> Meant = new()
    {
        ["NullReferenceException"] = "使用了为 null 的对象，它没有赋值或没有找到",
        ["IndexOutOfRangeException"] = "数组下标超出范围",
        ["ArgumentOutOfRangeException"] = "下标或参数超出范围",
        ["ArgumentNullException"] = "参数为 null",
        ["DivideByZeroException"] = "整数除以零",
        ["InvalidCastException"] = "对象不是要转换成的类型",
        ["OverflowException"] = "整数溢出",
        ["KeyNotFoundException"] = "字典中没有这个键",
        ["FormatException"] = "文字不是应有的格式",
        ["NotImplementedException"] = "这里还没有写",
        ["NotSupportedException"] = "不支持这个操作",
        ["MissingReferenceException"] = "使用了已被销毁的对象",
        ["MissingComponentException"] = "对象上没有这个组件",
    };

    public static Finding Forbidden(string code, string name) => Code(code, "only the engine and plain C#", name,
        $"The script {Reached[code].English} ({name}). It was not run: in the lab only the five steps are needed.",
        $"脚本{Reached[code].Chinese}（{name}），因此没有运行：实验只需要五个步骤。");

    public static Finding Cheat(string code, string name) => Code(code, "the script's own five steps", name,
        $"{Capital(Helped[code].English)} ({name}). The lab asks for the five steps in the script itself.",
        $"{Helped[code].Chinese}（{name}）。实验要求在脚本中自己写出五个步骤。");

    public static Finding Coroutine(string name) => Code("coroutine", "steps in Update or FixedUpdate", name,
        $"The script steps by {name}, which the checker does not run. Take the five steps in Update or FixedUpdate.",
        $"脚本用 {name} 推进，检查器不支持。请在 Update 或 FixedUpdate 中完成五个步骤。");

    public static Finding DoesNotCompile(string code, string id, string message, string inChinese) => Code(code, "a script that compiles", id + ": " + message,
        $"The script does not compile: {id}, {message}.", $"脚本不能编译：{id}，{inChinese}。");

    public static Finding NoQuaternionSum(string message) => Code("no-quaternion-sum", "new Quaternion(a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w)", message,
        "The script does not compile: Unity has no + for quaternions. Add the four components.",
        "脚本不能编译：Unity 的 Quaternion 没有加法，请将四个分量分别相加。");

    public static Finding DoubleLiteral(string message) => Code("double-literal", "0.5f", message,
        "The script does not compile: a number such as 0.5 is a double. Write 0.5f.",
        "脚本不能编译：0.5 这样的数是 double，应写成 0.5f。");

    public static Finding NotInTheStandIn(string name) => Code("not-in-the-stand-in", "a member that the checker knows", name,
        $"The checker does not know {name} of Unity, so the script was not run. Try it in Unity.",
        $"检查器不认识 Unity 的 {name}，因此没有运行脚本，请在 Unity 中查看。").ForInstructor();

    public static Finding CodeBehindIf() => Code("code-behind-if", "code that compiles in the editor", "code behind #if",
        "Code behind this #if is not compiled in the editor: it was neither run nor judged.",
        "此 #if 之后的代码在编辑器中不参与编译，没有运行，也没有检查。").ForInstructor();

    public static Finding NoScript() => Code("no-script", "class MyRigidbody : MonoBehaviour", "none",
        "There is no class MyRigidbody : MonoBehaviour with Update or FixedUpdate.",
        "没有找到含有 Update 或 FixedUpdate 的 class MyRigidbody : MonoBehaviour。");

    public static Finding TooLarge(string name) => Code("too-large", "at most 40 files of 500 kB", name,
        $"{name} is too large for a script of the lab, or there are too many files.",
        $"{name} 过大或文件过多，不像实验脚本。");

    public static Finding Stopped(string code, string message) => code switch
    {
        "endless-loop" or "endless-loop-that-catches" => Code(code, "a step that ends", message + " does not end",
            $"{message} does not come to an end: a loop never stops.", $"{message} 不会结束：存在死循环。"),
        "endless-recursion" => Code(code, "a step that ends", message + " calls itself without end",
            $"{message} calls itself without end.", $"{message} 中存在无限递归。"),
        "memory" => Code(code, "memory that does not grow", message + " keeps more and more memory",
            $"{message} keeps more memory than the script may have. Do not collect something in every frame.", $"{message} 占用的内存过多，不要在每一帧都保存大量数据。"),
        "ended" => Code(code, "a script that runs", message,
            "The script broke what it runs in.", "脚本破坏了运行它的环境。"),
        "too-complex" => Code(code, "a script that a compiler can read", message,
            "The compiler does not come to an end with this script.", "编译器无法处理这个脚本。"),
        _ => Code("does-not-end", "a script that ends", "it did not answer in time",
            "The script did not answer in time and was stopped.", "脚本超时，已停止。"),
    };

    public static Finding Throws(string code, string message, string exception, string said) => Code(code, "no exception", exception + said,
        code == "no-rigidbody"
            ? $"{message} asks for a Rigidbody, and there is none on the object; none is needed."
            : $"{message} throws {exception}{said}.",
        code == "no-rigidbody"
            ? $"{message} 需要 Rigidbody，而对象上没有，也不需要。"
            : $"{message} 抛出异常 {exception}{(Meant.TryGetValue(exception, out string? meant) ? "：" + meant : said)}。");

    public static Finding ClassName(string name) => new(Step.Name, "class-name", Compilation.Sources.ClassName, name,
        $"The class is called {name}, not MyRigidbody: Unity cannot put MyRigidbody.cs on an object.",
        $"类名是 {name}，与文件名 MyRigidbody.cs 不一致，Unity 无法挂载。");

    public static Finding TwoScripts(IEnumerable<string> others) => new Finding(Step.Package, "two-scripts", "one MyRigidbody.cs", string.Join(", ", others),
        $"There is more than one MyRigidbody ({string.Join(", ", others)} too); this one was judged.",
        $"有不止一个 MyRigidbody（另有 {string.Join("、", others)}），检查的是这一个。").ForInstructor();

    private static Finding Code(string code, string expected, string found, string english, string chinese) =>
        new(Step.Code, code, expected, found, english, chinese);

    private static string Capital(string text) => char.ToUpperInvariant(text[0]) + text[1..];
}
