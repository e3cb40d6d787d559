using System.Globalization;
using NUnit.Framework;
using RigidBodyDynamics.Judging;
using RigidBodyDynamics.Lab.Grading.Marks;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.Tests.Repository;

/// <summary>The pages for instructors, and the lab page's numbers about mistakes.</summary>
public sealed class TeachingPageTests
{
    private const string English = "docs/teaching.md", Chinese = "docs/teaching.zh.md";
    private const double TimeStep = 0.02;

    // as the judge's box is turned
    private static readonly Quaterniond Turned = new Quaterniond(0.7, 0.3, -0.5, 0.4).Normalized;

    [Test]
    public void Chinese_page_has_the_headings_the_commands_the_pictures_and_the_marks_of_the_English_one()
    {
        Assert.That(Starting(Chinese, "#").Select(line => line.Count(letter => letter == '#')), Is.EqualTo(Starting(English, "#").Select(line => line.Count(letter => letter == '#'))));
        Assert.That(Starting(Chinese, "    "), Is.EqualTo(Starting(English, "    ")).And.Not.Empty);
        Assert.That(Starting(Chinese, "![").Select(Target), Is.EqualTo(Starting(English, "![").Select(Target)).And.Not.Empty);
        Assert.That(PageText.Block(Chinese, "<!-- marks -->"), Is.EqualTo(PageText.Block(English, "<!-- marks -->")).And.Not.Empty);

        static string Target(string picture) => picture[picture.LastIndexOf('(')..];
    }

    [Test]
    public void Marks_on_the_page_are_read_as_it_says()
    {
        using TemporaryFolder folder = new();
        File.WriteAllLines(folder.File("marks.json"), PageText.Block(English, "<!-- marks -->"));

        MarksFile marks = MarksFile.Read(folder.File("marks.json"));

        Assert.That(marks.Scheme.Full, Is.EqualTo(100));
        Assert.That(marks.Decisions[0].Steps, Is.EqualTo(new Dictionary<Step, bool> { [Step.Orientation] = true }));
        Assert.That(marks.Decisions[1].Points, Is.EqualTo(40));
        Assert.That(marks.Decisions.Select(decision => File.Exists(Root.File("tests/data/submissions/" + decision.File))), Is.All.True);
    }

    [TestCase("I_ref in the place of R I_ref Rᵀ", "not turned")]
    [TestCase("Rᵀ I_ref R, the transpose on the wrong side", "transposed")]
    [TestCase("q [0, ½Δt ω] in the place of [0, ½Δt ω] q", "order")]
    public void Cube_hides_the_mistake_and_boxes_show_it_as_the_page_says(string row, string mistake)
    {
        Vector3d cube = Moments(1, 1, 1), box = Moments(1, 2, 3);

        string[] cells = Starting("docs/lab.md", "| " + row).Single().Split('|', StringSplitOptions.TrimEntries);

        Assert.That(Apart(cube, Quaterniond.Identity, mistake), Is.LessThan(1e-12)); // measured 5e-14°
        Assert.That(cells[2], Is.EqualTo("0°"));
        Assert.That(cells[3], Is.EqualTo(Short(Apart(box, Quaterniond.Identity, mistake))));
        Assert.That(cells[4], Is.EqualTo(Short(Apart(box, Turned, mistake))));
    }

    [Test]
    public void Damping_before_moving_takes_two_per_cent_of_the_way_and_of_the_angle()
    {
        (Vector3d way, double turn, _) = Played(Moments(1, 1, 1), Quaterniond.Identity, string.Empty);
        (Vector3d shorter, double less, _) = Played(Moments(1, 1, 1), Quaterniond.Identity, "damped before moving");

        Assert.That(shorter.Length / way.Length, Is.EqualTo(0.98).Within(1e-12)); // measured 0.9799999999999999
        Assert.That(less / turn, Is.EqualTo(0.98).Within(1e-5)); // measured 0.980005: formula 4 turns by an arc tangent
    }

    [Test]
    public void Inertia_about_the_middle_of_the_lower_face_turns_the_cube_less_as_the_page_says()
    {
        double right = Degrees(Played(Moments(1, 1, 1), Quaterniond.Identity, string.Empty).Turn);
        // the parallel axes: (1/2)² m more about the two axes that do not pass through the centre
        double pivot = Degrees(Played(Moments(1, 1, 1) + new Vector3d(0.25, 0, 0.25), Quaterniond.Identity, string.Empty).Turn);

        Assert.That(Tree.Text("docs/lab.md"), Does.Contain($"turns {Short(pivot)} in the lab's scene, not {Short(right)}"));
    }

    /// <summary>Of the lab's scene, °: how far the mistake leads from the right orientation at most.</summary>
    private static double Apart(Vector3d moments, Quaterniond start, string mistake) =>
        Degrees(Played(moments, start, string.Empty).Orientations.Zip(Played(moments, start, mistake).Orientations, Conserved.AngleBetween).Max());

    /// <summary>The sheet's five steps on the keys of scenes/lab.json: R for 0-3 s, right for 1-2 s, up for 1.5-2.5 s.</summary>
    private static (Vector3d Way, double Turn, IReadOnlyList<Quaterniond> Orientations) Played(Vector3d moments, Quaterniond start, string mistake)
    {
        Vector3d x = Vector3d.Zero, v = Vector3d.Zero, w = Vector3d.Zero;
        List<Quaterniond> orientations = [start];
        double turn = 0;
        for (int i = 0; i < 500; i++)
        {
            Quaterniond q = orientations[^1];
            double sine = i < 150 ? Math.Sin(i * TimeStep) : 0;
            Vector3d torque = new(sine, sine, sine), force = new(i is >= 50 and < 100 ? 5 : 0, i is >= 75 and < 125 ? 5 : 0, 0);
            v += TimeStep * force;
            w += TimeStep * mistake switch
            {
                "not turned" => Inverse(torque),
                "transposed" => q.RotateInverse(Inverse(q.Rotate(torque))),
                _ => q.Rotate(Inverse(q.RotateInverse(torque))),
            };
            double kept = mistake == "damped before moving" ? 0.98 : 1;
            x += TimeStep * kept * v;
            Quaterniond half = new(0, 0.5 * TimeStep * kept * w);
            orientations.Add((q + (mistake == "order" ? q * half : half * q)).Normalized);
            turn += Conserved.AngleBetween(q, orientations[^1]);
            v *= 0.98;
            w *= 0.98;
        }

        return (x, turn, orientations);

        Vector3d Inverse(Vector3d r) => new(r.X / moments.X, r.Y / moments.Y, r.Z / moments.Z);
    }

    /// <summary>Of eight points in the corners of a box, together 1 kg.</summary>
    private static Vector3d Moments(double x, double y, double z) => new((y * y + z * z) / 4, (x * x + z * z) / 4, (x * x + y * y) / 4);

    private static double Degrees(double angle) => angle * 180 / Math.PI;

    private static string Short(double degrees) => degrees.ToString(degrees < 10 ? "0.0" : "0", CultureInfo.InvariantCulture) + "°";

    private static string[] Starting(string page, string with) => [.. Tree.Text(page).Split('\n').Where(line => line.StartsWith(with, StringComparison.Ordinal))];
}
