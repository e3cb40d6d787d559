using System.Text;
using NUnit.Framework;
using RigidBodyDynamics.Lab.Grading.Students;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.StudentScripts;

namespace RigidBodyDynamics.Tests.Grading;

/// <summary>Students, from the names on files and lists.</summary>
public sealed class StudentNameTests
{
    [TestCase("210840007_学生一.unitypackage", "210840007", "学生一", true)]
    [TestCase("210840007_学生一 (1).unitypackage", "210840007", "学生一", true)]
    [TestCase("210840007＿学生一.unitypackage", "210840007", "学生一", true)]
    [TestCase("２１０８４０００７_学生一.zip", "210840007", "学生一", true)]
    [TestCase("u202112345_欧阳·娜娜.unitypackage", "U202112345", "欧阳·娜娜", true)]
    [TestCase("210840007-学生一.unitypackage", "210840007", "学生一", false)]
    [TestCase("210840007 学生一 实验3.unitypackage", "210840007", "学生一", false)]
    [TestCase("210840007学生一.zip", "210840007", "学生一", false)]
    [TestCase("学生一_210840007.unitypackage", "210840007", "学生一", false)]
    [TestCase("实验3_210840007_学生一_最终版.unitypackage", "210840007", "学生一", false)]
    [TestCase("20211130_210840007_学生一.zip", "210840007", "学生一", false)]
    [TestCase("210840007_学生一_13800000000.zip", "210840007", "学生一", false)]
    [TestCase("学生一_1234567_assignsubmission_file_", "1234567", "学生一", false)]
    [TestCase("210840007_Ana María López.zip", "210840007", "Ana María López", false)]
    [TestCase("210840007.cs", "210840007", "", false)]
    public void Name_of_a_file_says_who_it_is(string file, string id, string name, bool asAsked)
    {
        Assert.That(StudentName.Read(file).FirstOrDefault(), Is.EqualTo(new Student(id, name)));
        Assert.That(StudentName.IsAsAsked(file), Is.EqualTo(asAsked));
    }

    [TestCase("实验3-最终版.unitypackage")]
    [TestCase("数媒21-1.zip")]
    [TestCase("20211130.zip")]
    [TestCase("MyRigidbody.cs")]
    public void Name_without_a_number_has_no_student(string file) => Assert.That(StudentName.Read(file), Is.Empty);

    private static readonly Student[] Two = [new("210840007", "学生一"), new("210840014", "学生二")];

    [TestCase("学号,姓名\n210840007,学生一\n210840014,学生二\n")]
    [TestCase("姓名;班级;学号\r\n学生一;1;210840007\r\n学生二;1;210840014\r\n")]
    [TestCase("序号\t学 号\t姓 名\n1\t210840007\t学生一\n2\t210840014\t学生二")]
    [TestCase("2021—2022 学年名单,,\n,,\n学生学号,学生姓名,备注\n210840007,学生一,\n210840014,学生二,\n,,\n")]
    [TestCase("Student ID,Full name\n=\"210840007\",学生一\n'210840014,\"学生二\"\n")]
    [TestCase("First name,Surname,ID number,Email\n一,学生,210840007,a@b\n二,学生,210840014.0,c@d\n")]
    [TestCase("210840007,学生一\n210840014,学生二\n")]
    public void Roster_is_read_however_a_school_writes_it(string text)
    {
        foreach (Encoding encoding in new[] { new UTF8Encoding(true), new UTF8Encoding(false), SourceText.Gbk, Encoding.Unicode })
        {
            byte[] bytes = [.. encoding.GetPreamble(), .. encoding.GetBytes(text)];
            Assert.That(Roster.Parse("list.csv", bytes).Students, Is.EqualTo(Two), encoding.WebName);
        }
    }

    [TestCase("a,b\nc,d\n", "list.csv: line 1: there is no heading")]
    [TestCase("学号,姓名\n2.1084E+08,学生一\n", "list.csv: line 2: the number \"2.1084E+08\" has been rounded")]
    [TestCase("学号,姓名\n210840007,学生一\n210840007,学生二\n", "list.csv: line 3: 210840007 is already in line 2")]
    [TestCase("学号,姓名\n", "list.csv: there is no student in it")]
    public void Roster_that_cannot_be_used_says_where(string text, string message) =>
        Assert.That(() => Roster.Parse("list.csv", Encoding.UTF8.GetBytes(text)), Throws.InstanceOf<InputException>().With.Message.StartsWith(message));

    [Test]
    public void Student_without_a_number_is_found_by_a_name_that_nobody_shares_and_that_is_a_whole_word()
    {
        Roster roster = Roster.Parse("list.csv", Encoding.UTF8.GetBytes("学号,姓名\n210840007,学生一\n210840014,学生二\n210840021,学生二\n"));

        Assert.That(roster.Find(new Student("", "学生一"))?.Id, Is.EqualTo("210840007"));
        Assert.That(roster.Find(new Student("", "学生二")), Is.Null);
        Assert.That(roster.Find(new Student("210840008", "学生一")), Is.Null);
        Assert.That(roster.Named("实验3_学生一")?.Id, Is.EqualTo("210840007"));
        Assert.That(roster.Named("实验3_学生一〇"), Is.Null);
    }
}
