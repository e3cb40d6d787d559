using System.Globalization;
using System.Text.RegularExpressions;

namespace RigidBodyDynamics.Lab.Grading.Students;

/// <summary>A student.</summary>
/// <param name="Id">学号; empty where only a name is known.</param>
/// <param name="Name">姓名; empty where only a number is known.</param>
internal sealed record Student(string Id, string Name);

/// <summary>
/// Reads the student from a name of a file, folder or archive: <c>学号_姓名</c>, as the sheet asks, and the usual variants
/// (another order, other separators, none, something about the lab beside it).
/// </summary>
internal static partial class StudentName
{
    private const int LongestName = 40;

    /// <summary>Every student that a name may mean, the likeliest first; none where it has no number.</summary>
    public static IReadOnlyList<Student> Read(string fileName)
    {
        string text = Stem(fileName);
        return [.. Id().Matches(text)
            .Where(match => !IsDate(match.Value))
            .Select(match => new Student(match.Value.ToUpperInvariant(), NameBeside(text, match)))];
    }

    /// <summary>True for exactly <c>学号_姓名</c>.</summary>
    public static bool IsAsAsked(string fileName) => AsAsked().IsMatch(Stem(fileName));

    /// <summary>Without the extension and the suffix that browsers add to a second download; full-width digits and marks as plain ones.</summary>
    public static string Stem(string fileName) => Ending().Replace(string.Concat(fileName.Select(Plain)), string.Empty).Trim();

    private static char Plain(char letter) => letter is >= '！' and <= '～' ? (char)(letter - '！' + '!') : letter == '\u3000' ? ' ' : letter;

    /// <summary>The part beside the number that is a person's name: the nearest one that is not about the lab.</summary>
    private static string NameBeside(string text, Match id)
    {
        string[] after = Parts(text[(id.Index + id.Length)..]), before = Parts(text[..id.Index]);
        return after.Concat(before.Reverse()).FirstOrDefault(IsName) ?? string.Empty;
    }

    // a Chinese name has no blank in it, others have
    private static string[] Parts(string text) => [.. Marks().Split(text)
        .SelectMany(part => part.Any(letter => letter >= '\u2e80') ? part.Split(' ') : [part])
        .Select(part => part.Trim())
        .Where(part => part.Length > 0)];

    private static bool IsName(string part) =>
        part.Length <= LongestName && part.Any(char.IsLetter) && !part.Any(char.IsDigit) && !NoName().IsMatch(part);

    // 20211130: a day of this century
    private static bool IsDate(string digits) =>
        digits.Length == 8 && DateTime.TryParseExact(digits, "yyyyMMdd", CultureInfo.InvariantCulture, DateTimeStyles.None, out DateTime day) && day.Year is >= 2000 and < 2100;

    [GeneratedRegex(@"((?<![0-9A-Za-z])[A-Za-z]{1,2})?(?<![0-9])[0-9]{6,16}(?![0-9])")]
    private static partial Regex Id();

    [GeneratedRegex(@"^[A-Za-z]{0,2}[0-9]{6,16}_[^_\s()\-]+$")]
    private static partial Regex AsAsked();

    [GeneratedRegex(@"(\.unitypackage|\.tar\.gz|\.zip|\.cs|\.rar|\.7z|\.tar|\.tgz|\.gz|\.download|\s*\([0-9]{1,2}\))+$", RegexOptions.IgnoreCase)]
    private static partial Regex Ending();

    [GeneratedRegex(@"[_\-+,;:()\[\]【】、。—–]+|(?<=[0-9])(?=\p{L})|(?<=\p{L})(?=[0-9])")]
    private static partial Regex Marks();

    [GeneratedRegex(
        @"实验|作业|最终|提交|报告|修改|副本|刚体|仿真|物理|第.{1,3}[次版章]|[0-9]班|^(lab|hw|homework|final|rigidbody|myrigidbody|assignsubmission|file|onlinetext|submission|copy|late|ver|version|v|rev|new|exp|unity|update|updated)$",
        RegexOptions.IgnoreCase)]
    private static partial Regex NoName();
}
