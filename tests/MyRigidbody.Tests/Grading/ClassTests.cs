using System.Text;
using NUnit.Framework;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Grading;
using RigidBodyDynamics.Lab.Grading.Export;
using RigidBodyDynamics.Lab.Grading.Marks;
using RigidBodyDynamics.Lab.Grading.Reading;
using RigidBodyDynamics.Lab.Grading.Students;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.Tests.Grading;

/// <summary>A class from its files to its marks, with a stand-in for the judge.</summary>
public sealed class ClassTests
{
    private TemporaryFolder _folder = null!;

    private string Output => _folder.File("out");

    [SetUp]
    public void Make() => _folder = new TemporaryFolder();

    [TearDown]
    public void Remove() => _folder.Dispose();

    [Test]
    public void Two_scripts_in_a_package_are_in_doubt_until_one_is_chosen()
    {
        Put("class/210840007_学生一.unitypackage", Archives.Package(
            ("Assets/MyRigidbody.cs", Archives.Source), ("Assets/old/MyRigidbody.cs", Archives.Source + " // wrong: orientation half-missing")));
        Put("class/210840014_学生二.unitypackage", Archives.Package(("Assets/MyRigidbody.cs", Archives.Source), ("Assets/Copy/MyRigidbody.cs", Archives.Source + "\r\n")));

        Graded[] open = [.. Grade().Submissions];
        Question question = Question.Of(Grade()).Single();
        Graded[] chosen = [.. Grade(Marks(question.Answers.Single(answer => answer.Line.Contains("/old/")).Line)).Submissions];

        Assert.That(open.Select(one => one.Judgement.Verdict.Outcome), Is.EqualTo(new[] { Outcome.Doubtful, Outcome.Right }));
        Assert.That(open[0].Marked.Total, Is.EqualTo(100));
        Assert.That(question.About.File, Is.EqualTo(open[0].File));
        Assert.That((chosen[0].Judgement.Verdict.Outcome, chosen[0].Judgement.Verdict[Step.Orientation], chosen[0].Marked.Total), Is.EqualTo((Outcome.Wrong, Mark.Wrong, 80.0)));
        Assert.That(Question.Of(Grade(Marks(question.Answers[0].Line))), Is.Empty);
    }

    [TestCase("right", Outcome.Right, 100)]
    [TestCase("wrong", Outcome.Wrong, 80)]
    public void Line_that_settles_a_doubt_settles_it_and_nothing_else(string answer, Outcome outcome, double points)
    {
        PutScript("210840007_学生一", "// doubtful: orientation exact-turn");
        PutScript("210840014_学生二", "// wrong: velocity v-no-dt");
        PutScript("210840021_学生三", "// doubtful: damping rate");

        Class before = Grade();
        string line = Question.Of(before).First().Answers.Single(one => one.Meaning.En == (answer == "right" ? "it is right" : "it is not")).Line;
        Class after = Grade(Marks(line));

        Assert.That(line, Does.Contain($"\"orientation\":\"{answer}\""));
        Assert.That((after.Submissions[0].Judgement.Verdict.Outcome, after.Submissions[0].Marked.Total), Is.EqualTo((outcome, points)));
        Assert.That(after.Submissions.Skip(1).Select(one => one.Judgement.Verdict.Outcome), Is.EqualTo(before.Submissions.Skip(1).Select(one => one.Judgement.Verdict.Outcome)));
        Assert.That(Question.Of(after).Single().About.Student!.Name, Is.EqualTo("学生三"));
    }

    [Test]
    public void Every_line_that_is_offered_settles_its_doubt([Values] Step step)
    {
        PutScript("210840007_学生一", $"// doubtful: {step} what-is-in-doubt");

        IReadOnlyList<Answer> answers = Question.Of(Grade()).Single().Answers;

        Assert.That(answers.Select(answer => Grade(Marks(answer.Line)).Submissions[0].Judgement.Verdict.Outcome), Is.EqualTo(new[] { Outcome.Right, Outcome.Wrong }));
    }

    [Test]
    public void Script_that_the_checker_could_not_run_is_asked_about_once_and_gets_the_points_that_are_given()
    {
        PutScript("210840007_学生一", "// unknown: code not-in-the-stand-in");

        Question question = Question.Of(Grade()).Single();
        Class settled = Grade(Marks(question.Answers.Single().Line.Replace("\"points\":0", "\"points\":70", StringComparison.Ordinal)));

        Assert.That(question.Kind, Is.EqualTo("run"));
        Assert.That(settled.Submissions.Single().Marked.Total, Is.EqualTo(70));
        Assert.That(Question.Of(settled), Is.Empty);
    }

    [Test]
    public void Decision_is_not_taken_for_a_script_that_is_handed_in_later()
    {
        PutScript("210840007_学生一", "// doubtful: orientation exact-turn");
        string line = Question.Of(Grade()).Single().Answers[1].Line;
        PutScript("210840007_学生一", "// doubtful: orientation exact-turn // mended");

        Class later = Grade(Marks(line));

        Assert.That(later.Submissions[0].Marked.Total, Is.EqualTo(100));
        Assert.That(Question.Of(later).Any(question => question.What.En.Contains("another version")), Is.True);
    }

    [Test]
    public void Of_two_submissions_of_a_student_the_better_counts_until_the_instructor_says()
    {
        PutScript("210840007_学生一", "// wrong: velocity v-no-dt");
        Put("class/210840007_学生一_改.unitypackage", Archives.Package(("Assets/MyRigidbody.cs", Archives.Source)));

        Class all = Grade();
        Question[] questions = [.. Question.Of(all)];
        Class settled = Grade(Marks(questions.Single(question => !question.About.Counts).Answers[0].Line));

        Assert.That(all.Submissions.Select(one => (one.Marked.Total, one.Counts)), Is.EquivalentTo(new[] { (80.0, false), (100.0, true) }));
        Assert.That(questions.Select(question => question.Kind), Is.EqualTo(new[] { "twice", "twice" }));
        Assert.That(settled.Submissions.Single(one => one.Counts).Marked.Total, Is.EqualTo(80));
        Assert.That(Question.Of(settled), Is.Empty);
    }

    [Test]
    public void Points_and_deductions_are_those_of_the_file()
    {
        PutScript("210840007_学生一", "// wrong: orientation half-missing\n;;;;;;;;;;"); // 10 statements, 2 without comment
        string marks = """
            {
                "schema": "rigid-body-marks/1", // as on the page
                "points": { "velocity": 10, "orientation": 60 },
                "deductions": { "comments": 5 },
                "decisions": [],
            }
            """;

        Marked marked = Grade(marks).Submissions[0].Marked;

        Assert.That((marked.Steps, marked.Comments, marked.Total), Is.EqualTo((70.0, 1.0, 69.0)));
        Assert.That(Grade().Submissions[0].Marked.Total, Is.EqualTo(78));
    }

    [TestCase("""{ "schema": "x" }""", "marks.json: schema: must be \"rigid-body-marks/1\", found \"x\"")]
    [TestCase("""{ "schema": "rigid-body-marks/1", "points": { "velocity": -1 } }""", "marks.json: points.velocity: must be a number from 0, found -1")]
    [TestCase("""{ "schema": "rigid-body-marks/1", "decisions": [{ "file": "a", "orientation": "yes" }] }""", "marks.json: decisions[0].orientation: must be one of \"right\", \"wrong\"")]
    [TestCase("""{ "schema": "rigid-body-marks/1", "decisions": [{ "orientation": "right" }] }""", "marks.json: decisions[0]: \"file\" is missing")]
    [TestCase("""{ "schema": "rigid-body-marks/1", "decisions": [{ "file": "a", "orientaton": "right" }] }""", "marks.json: decisions[0].orientaton: is not a name known here")]
    public void File_of_marks_that_is_wrong_says_where(string marks, string message) =>
        Assert.That(() => ReadMarks(marks), Throws.InstanceOf<InputException>().With.Message.Contains(message));

    [Test]
    public void Student_on_the_roster_without_a_submission_is_missing()
    {
        PutScript("210840007_学生一");
        Put("class/学生二.zip", Archives.Zip(("MyRigidbody.cs", Archives.Bytes(Archives.Source))));
        PutScript("210849999_别人");
        Roster roster = Roster.Parse("list.csv", Encoding.UTF8.GetBytes("学号,姓名\n210840007,学生一\n210840014,学生二\n210840021,学生三\n"));

        Class all = new Grader(new StandInBench()).Judge([_folder.File("class")], Output, roster, MarksFile.Default, _ => { });

        Assert.That(all.Missing.Select(student => student.Name), Is.EqualTo(new[] { "学生三" }));
        Assert.That(Question.Of(all).Where(question => question.Kind == "whose").Select(question => question.About.Student!.Name), Is.EqualTo(new[] { "别人" }));
        Assert.That(MarksTable.Rows(all).Select(row => row[1]), Is.EqualTo(new[] { "学生一", "学生二", "别人", "学生三" }));
    }

    [Test]
    public void Run_that_was_killed_goes_on_where_it_was()
    {
        for (int i = 0; i < 10; i++)
            PutScript($"21084{i:0000}_学生", $"// {i}");

        StandInBench killed = new() { EndsAfter = 4 }, second = new(), third = new(), other = new() { Version = "newer" };
        Assert.That(() => Grade(killed), Throws.InstanceOf<OperationCanceledException>());
        File.WriteAllText(Directory.GetFiles(_folder.File("out/.grade/stand-in")).Order().First(), "{ half of it");
        Grade(second);
        Grade(third);
        Grade(other);

        Assert.That((second.Judged, third.Judged, other.Judged), Is.EqualTo((7, 0, 10)));
    }

    [Test]
    public void Two_runs_write_the_same_bytes()
    {
        for (int i = 0; i < 12; i++)
            PutScript($"21084{i:0000}_学生", i % 3 == 0 ? "// wrong: orientation half-missing" : i % 3 == 1 ? "// doubtful: damping rate" : "");

        Write();
        Dictionary<string, byte[]> first = Written();
        Directory.Delete(Output, recursive: true);
        Write();
        Dictionary<string, byte[]> second = Written();

        Assert.That(second.Keys, Is.EquivalentTo(first.Keys));
        Assert.That(first.Keys, Is.SupersetOf(new[] { "index.html", "marks.csv", "marks.xlsx", "grade.json", Path.Combine("students", "210840000_学生.html") }));
        foreach ((string file, byte[] bytes) in first)
            Assert.That(second[file], Is.EqualTo(bytes), file);
    }

    [Test]
    public void Page_of_a_student_who_is_no_longer_in_the_class_goes_and_other_files_stay()
    {
        PutScript("210840007_学生一");
        PutScript("210840014_学生二");
        Write();
        File.WriteAllText(_folder.File("out/students/notes.html"), "<p>my own</p>");
        Directory.Delete(_folder.File("class/210840014_学生二"), recursive: true);
        Write();

        Assert.That(Directory.GetFiles(_folder.File("out/students")).Select(Path.GetFileName), Is.EquivalentTo(new[] { "210840007_学生一.html", "notes.html" }));
    }

    [Test]
    public void Submissions_are_called_alike_however_the_path_was_typed()
    {
        PutScript("210840007_学生一");
        string full = _folder.File("class"), here = Path.GetRelativePath(Environment.CurrentDirectory, full);
        string[] typed = [full, full + "/", here, here + "/", Path.Combine(full, "..", "class"), "./" + here];

        Assert.That(typed.Select(path => HandedIn.Read([path], Output).Pieces.Single().Spot.Shown), Is.All.EqualTo("class/210840007_学生一/MyRigidbody.cs"));
    }

    [Test]
    public void Two_folders_of_one_name_are_told_apart_by_the_folders_around_them()
    {
        Put("a/class/210840007_学生一.cs", Archives.Bytes(Archives.Source));
        Put("b/class/210840007_学生一.cs", Archives.Bytes(Archives.Source));

        Assert.That(HandedIn.Read([_folder.File("a/class"), _folder.File("b/class/")], Output).Pieces.Select(piece => piece.Spot.Shown), Is.EqualTo(new[]
        {
            "a/class/210840007_学生一.cs", "b/class/210840007_学生一.cs",
        }));
    }

    private void Write()
    {
        using ClassFiles files = new(Output, []);
        files.Write(Grade(new StandInBench()));
    }

    private Dictionary<string, byte[]> Written() => Directory.EnumerateFiles(Output, "*", SearchOption.AllDirectories)
        .ToDictionary(file => Path.GetRelativePath(Output, file), File.ReadAllBytes);

    private Class Grade(StandInBench bench) => new Grader(bench).Judge([_folder.File("class")], Output, null, MarksFile.Default, _ => { });

    private Class Grade(string? marks = null) =>
        new Grader(new StandInBench()).Judge([_folder.File("class")], Output, null, marks == null ? MarksFile.Default : ReadMarks(marks), _ => { });

    private MarksFile ReadMarks(string text)
    {
        File.WriteAllText(_folder.File("marks.json"), text);
        return MarksFile.Read(_folder.File("marks.json"));
    }

    private static string Marks(string line) => "{\"schema\": \"rigid-body-marks/1\", \"decisions\": [\n" + line + "\n]}";

    private void PutScript(string student, string says = "") => Put($"class/{student}/MyRigidbody.cs", Archives.Bytes(Archives.Source + "\n" + says));

    private void Put(string file, byte[] bytes)
    {
        Directory.CreateDirectory(Path.GetDirectoryName(_folder.File(file))!);
        File.WriteAllBytes(_folder.File(file), bytes);
    }
}
