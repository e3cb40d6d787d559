using System.Text;
using RigidBodyDynamics.Lab.Grading.Export;
using RigidBodyDynamics.Lab.Grading.Pages;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Grading;

/// <summary>The pages and tables of a class. Whether they can be written is tested before anything is judged; either all or none are written.</summary>
internal sealed class ClassFiles : IDisposable
{
    /// <summary>The folder with the pages of the students.</summary>
    public const string StudentsFolder = "students";

    private static readonly (string Name, Func<Class, byte[]> Content)[] Tables =
    [
        ("index.html", all => Encoding.UTF8.GetBytes(ClassPage.Html(all))),
        ("marks.csv", MarksTable.Csv),
        ("marks.xlsx", MarksWorkbook.Of),
        ("grade.json", all => Encoding.UTF8.GetBytes(GradeJson.Of(all))),
    ];

    private readonly Files _files, _students;
    private readonly string _folder;

    /// <param name="output">The folder.</param>
    /// <param name="inputs">Files that were read, and must not be overwritten.</param>
    public ClassFiles(string output, IReadOnlyList<string> inputs)
    {
        _folder = Path.Combine(output, StudentsFolder);
        _files = new Files(output, output, inputs);
        try
        {
            _students = new Files(_folder, output, inputs);
            foreach ((string name, _) in Tables)
                _files.MustBeFree(name);
        }
        catch (InputException)
        {
            Dispose();
            throw;
        }
    }

    /// <summary>Writes all, and deletes the pages of students who are no longer in the class.</summary>
    public void Write(Class all)
    {
        foreach (Graded one in all.Submissions)
            _students.Write(one.Page, to => File.WriteAllText(to, StudentPage.Html(one, all.Scheme)));

        foreach ((string name, Func<Class, byte[]> content) in Tables)
            _files.Write(name, to => File.WriteAllBytes(to, content(all)));

        _students.Keep();
        _files.Keep();
        TakeAwayOthers([.. all.Submissions.Select(one => one.Page)]);
    }

    public void Dispose()
    {
        _students?.Dispose();
        _files.Dispose();
    }

    private void TakeAwayOthers(HashSet<string> pages)
    {
        try
        {
            foreach (string left in Directory.GetFiles(_folder, "*.html").Where(file => !pages.Contains(Path.GetFileName(file)) && StudentPage.IsOne(File.ReadAllText(file))))
                File.Delete(left);
        }
        catch (Exception closed) when (closed is IOException or UnauthorizedAccessException)
        {
            throw new InputException($"{_folder}: the page of a student who is no longer in the class cannot be deleted: {closed.Message.ReplaceLineEndings(" ")}");
        }
    }
}
