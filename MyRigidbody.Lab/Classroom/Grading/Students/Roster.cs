using System.Globalization;
using System.Text.RegularExpressions;
using CsvHelper;
using CsvHelper.Configuration;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.StudentScripts;

namespace RigidBodyDynamics.Lab.Grading.Students;

/// <summary>The class list: a table with a column of numbers, one of names, or both, as school systems and spreadsheets write it.</summary>
internal sealed partial class Roster
{
    // school systems put titles above the headings
    private const int MostTitleLines = 10;

    private static readonly string[] IdHeadings =
        ["学号", "学生学号", "学生编号", "学籍号", "考号", "工号", "id", "studentid", "studentno", "studentnumber", "idnumber", "sid", "number", "no", "userid", "username", "用户名"];

    private static readonly string[] NameHeadings = ["姓名", "学生姓名", "名字", "name", "fullname", "studentname", "displayname"];
    private static readonly string[] FamilyHeadings = ["姓", "lastname", "surname", "familyname"], GivenHeadings = ["名", "firstname", "givenname"];

    private Roster(IReadOnlyList<Student> students) => Students = students;

    /// <summary>The students on the list, in order.</summary>
    public IReadOnlyList<Student> Students { get; }

    /// <summary>Reads a list; an error is one line that names the file and the place.</summary>
    public static Roster Read(string path) => Parse(path, InputFile.Bytes(path).ToArray());

    /// <summary>The same from bytes.</summary>
    internal static Roster Parse(string path, byte[] bytes)
    {
        List<(int Line, string[] Cells)> rows = Rows(path, SourceText.Decode(bytes).Text);
        (Columns columns, int first) = Columns.Find(rows) ?? throw new InputException(
            $"{path}: line 1: there is no heading 学号 or 姓名 (student id, name) in the first {MostTitleLines} lines, and no line begins with a number");

        List<Student> students = [];
        Dictionary<string, int> lines = [];
        foreach ((int line, string[] cells) in rows.Skip(first).Where(row => row.Cells.Any(cell => cell.Length > 0)))
        {
            Student student = columns.Of(cells);
            if (Rounded().IsMatch(student.Id))
                throw new InputException($"{path}: line {line}: the number \"{student.Id}\" has been rounded by a spreadsheet; save that column as text");

            if (student.Id.Length > 0 && !lines.TryAdd(student.Id, line))
                throw new InputException($"{path}: line {line}: {student.Id} is already in line {lines[student.Id]}");

            if (student.Id.Length > 0 || student.Name.Length > 0)
                students.Add(student);
        }

        return students.Count > 0 ? new Roster(students) : throw new InputException($"{path}: there is no student in it");
    }

    /// <summary>The student on the list with a number; where none was read, the one with a unique name.</summary>
    public Student? Find(Student read) =>
        read.Id.Length > 0 ? Students.FirstOrDefault(student => student.Id == read.Id) : Namesake(read.Name);

    /// <summary>The only student of a name; null where there is none or more than one.</summary>
    public Student? Namesake(string name) =>
        name.Length > 0 && Students.Where(student => student.Name == name).Take(2).ToArray() is [Student only] ? only : null;

    /// <summary>The only student whose name a text contains as a separate word.</summary>
    public Student? Named(string text) =>
        Students.Where(student => student.Name.Length > 1 && Regex.IsMatch(text, $@"(?<!\p{{L}}){Regex.Escape(student.Name)}(?!\p{{L}}|〇)")).Take(2).ToArray() is [Student only] ? only : null;

    private static List<(int Line, string[] Cells)> Rows(string path, string text)
    {
        CsvConfiguration configuration = new(CultureInfo.InvariantCulture)
        {
            HasHeaderRecord = false,
            DetectDelimiter = true,
            DetectDelimiterValues = [",", ";", "\t"],
            BadDataFound = null,
            MissingFieldFound = null,
        };
        try
        {
            using CsvParser parser = new(new StringReader(text), configuration);
            List<(int, string[])> rows = [];
            while (parser.Read())
                rows.Add((parser.RawRow, [.. (parser.Record ?? []).Select(Clean)]));

            return rows;
        }
        catch (CsvHelperException broken)
        {
            throw new InputException($"{path}: is no table: {broken.Message.ReplaceLineEndings(" ")}");
        }
    }

    // ="0123" is how spreadsheets keep a leading zero; an apostrophe does the same
    private static string Clean(string cell)
    {
        string text = cell.Trim().Trim('\u200b', '\ufeff', '\u00a0').Trim();
        text = text.StartsWith("=\"", StringComparison.Ordinal) && text.EndsWith('"') ? text[2..^1] : text;
        return text.TrimStart('\'').Trim();
    }

    // 2.1084E+08
    [GeneratedRegex(@"^[0-9]\.[0-9]+E\+[0-9]+$", RegexOptions.IgnoreCase)]
    private static partial Regex Rounded();

    private sealed record Columns(int Id, int Name, int Family, int Given)
    {
        public static (Columns Columns, int FirstRow)? Find(List<(int Line, string[] Cells)> rows)
        {
            for (int row = 0; row < Math.Min(MostTitleLines, rows.Count); row++)
            {
                string[] cells = [.. rows[row].Cells.Select(Plain)];
                Columns found = new(Of(cells, IdHeadings), Of(cells, NameHeadings), Of(cells, FamilyHeadings), Of(cells, GivenHeadings));
                if (found.Id >= 0 || found.Name >= 0 || (found.Family >= 0 && found.Given >= 0))
                    return (found, row + 1);
            }

            // without headings: a number, and a name beside it
            int first = rows.FindIndex(row => row.Cells.Any(IsNumber));
            if (first < 0)
                return null;

            int id = Array.FindIndex(rows[first].Cells, IsNumber), name = Array.FindIndex(rows[first].Cells, cell => cell.Length > 0 && !cell.Any(char.IsDigit));
            return (new Columns(id, name, -1, -1), first);
        }

        public Student Of(string[] cells)
        {
            string family = At(cells, Family), given = At(cells, Given);
            string name = At(cells, Name).Length > 0 || Name >= 0 ? At(cells, Name) : family.Any(letter => letter >= '\u2e80') ? family + given : $"{given} {family}".Trim();
            string id = At(cells, Id);
            return new Student((id.EndsWith(".0", StringComparison.Ordinal) ? id[..^2] : id).ToUpperInvariant(), name);
        }

        private static int Of(string[] cells, string[] headings) =>
            headings.Select(heading => Array.IndexOf(cells, heading)).FirstOrDefault(index => index >= 0, -1);

        private static string At(string[] cells, int column) => column >= 0 && column < cells.Length ? cells[column] : string.Empty;

        private static bool IsNumber(string cell) => cell.Length is >= 6 and <= 18 && cell.Count(char.IsDigit) >= 6 && cell.All(char.IsLetterOrDigit);

        private static string Plain(string cell) => string.Concat(cell.ToLowerInvariant().Where(char.IsLetterOrDigit));
    }
}
