using System.Globalization;
using NUnit.Framework;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Report;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.Tests.Report;

/// <summary>The page draws the computed numbers.</summary>
public sealed class PageDataTests
{
    [Test]
    public void Data_are_those_of_the_tables_beside_the_page()
    {
        using TemporaryFolder folder = new();
        LabProcess lab = LabProcess.Run(folder.Path);
        Assert.That(lab.ExitCode, Is.Zero, lab.Error);
        Parsed page = new(File.ReadAllText(folder.File("out/report.html")));
        string[][] rows = Rows(folder.File("out/trajectory.csv")), apart = Rows(folder.File("out/apart.csv"));

        Assert.That(Parsed.Numbers(page.Data.GetProperty("times")), Is.EqualTo(apart.Select(row => Number(row[2]))).Within(1e-9));
        foreach ((int body, string name) in new[] { (0, "MyRigidbody"), (1, "DefaultRigidbody") })
        {
            string[][] own = [.. rows.Where(row => row[0] == name)];
            Assert.That(page.Data.GetProperty("bodies")[body].GetProperty("name").GetString(), Is.EqualTo(name));
            // half a unit of the last digit that is kept of the largest
            Same(page.Column(body, "position"), own, 3, 3, 5e-5);
            Same(page.Column(body, "orientation"), own, 6, 4, 5.1e-6);
            Same(page.Column(body, "spin"), own, 13, 3, 5e-5);
            Same(page.Column(body, "energy"), own, 19, 1, 5e-4);
        }

        Same(Parsed.Numbers(page.Data.GetProperty("pairs")[0].GetProperty("distance")), apart, 3, 1, 5e-4);
        Assert.That(
            Parsed.Numbers(page.Data.GetProperty("pairs")[0].GetProperty("angle")),
            Is.EqualTo(apart.Select(row => Number(row[4]) * 180 / Math.PI)).Within(5.1e-3));
    }

    [Test]
    public void Keys_come_with_their_times()
    {
        string[] held = [.. Parsed.Compared("lab.json").Data.GetProperty("held").EnumerateArray().Select(key =>
            $"{key.GetProperty("key").GetString()} {key.GetProperty("from").GetDouble()} {key.GetProperty("to").GetDouble()}")];

        Assert.That(held, Is.EqualTo(new[] { "R 0 3", "RightArrow 1 2", "UpArrow 1.5 2.5" }));
    }

    [Test]
    public void Impulse_is_seen_for_a_moment_though_it_takes_no_time()
    {
        string[] held = [.. Parsed.Compared("locked-door.json").Data.GetProperty("held").EnumerateArray().Select(push =>
            $"{push.GetProperty("en").GetString()} {push.GetProperty("from").GetDouble()} {push.GetProperty("to").GetDouble()}")];

        Assert.That(held, Is.EqualTo(new[] { "impulse (0, 0, 10) N s at (0.8, 1, 0) m of the body 1 1.25" }));
    }

    [Test]
    public void Boxes_have_the_edges_of_the_scene()
    {
        Parsed lab = Parsed.Compared("lab-box.json"), run = Parsed.Ran("x", 0.1, 5, "x");

        // a box of vertices has other moments than a solid one, and is drawn alike
        Assert.That(lab.Column(0, "edges"), Is.EqualTo(new[] { 1, 2, 3 }).Within(1e-4));
        Assert.That(run.Column(0, "edges"), Is.EqualTo(new[] { 1, 2, 3 }).Within(1e-4));
        Assert.That(new Track("needle", Heavy(1e-6), Heavy(1e-6)).Edges.X, Is.EqualTo(Math.Sqrt(6) * 0.02).Within(1e-6));

        static MassProperties Heavy(double least) => MassProperties.FromPrincipal(1, new Vector3d(1, 1, least));
    }

    [TestCase(2, 1)]
    [TestCase(501, 2)]
    [TestCase(3001, 4)]
    [TestCase(3002, 1)]
    [TestCase(6001, 4)]
    [TestCase(1_000_001, 1)]
    [TestCase(5001, 40)]
    public void Moments_are_chosen_evenly_and_the_last_is_among_them(long moments, int bodies)
    {
        long[] found = [.. Frames.Of(moments, bodies)];
        long[] strides = [.. found.Zip(found.Skip(1), (a, b) => b - a)];

        Assert.That(found[0], Is.Zero);
        Assert.That(found[^1], Is.EqualTo(moments - 1));
        Assert.That(strides.SkipLast(1).Distinct().Count(), Is.LessThanOrEqualTo(1));
        Assert.That(strides[^1], Is.InRange(1, strides[0]));
        Assert.That(found, Has.Length.InRange(Math.Min(moments, 140), Frames.Most));
        Assert.That(found.Length * (long)bodies, Is.LessThanOrEqualTo(4L * Frames.Most));
    }

    [Test]
    public void What_is_left_out_is_said_and_what_is_not_is_not()
    {
        Parsed whole = Parsed.Ran("whole", 0.01, 3000, "a"), thinned = Parsed.Ran("thinned", 0.01, 3001, "a");
        Parsed crowd = Parsed.Ran("crowd", 0.01, 10, [.. Enumerable.Range(0, 41).Select(i => "body " + i)]);

        Assert.That(whole.Document.QuerySelectorAll(".thinned"), Is.Empty);
        Assert.That(thinned.Document.QuerySelector(".thinned")!.TextContent, Does.Contain("Of 3001 steps, 1502 evenly").And.Contain("均匀"));
        Assert.That(thinned.Data.GetProperty("times").GetArrayLength(), Is.EqualTo(1502));
        Assert.That(Parsed.Numbers(thinned.Data.GetProperty("times"))[^1], Is.EqualTo(30.01).Within(1e-9));
        Assert.That(crowd.Document.QuerySelector(".thinned")!.TextContent, Does.Contain("Of 41 bodies, the first 40"));
        Assert.That(crowd.Data.GetProperty("bodies").GetArrayLength(), Is.EqualTo(40));
    }

    [Test]
    public void Two_pairs_over_3000_steps_take_less_than_5_MB()
    {
        int bytes = System.Text.Encoding.UTF8.GetByteCount(Parsed.Compared("pairs", 0.01, 3000, "a", "b").Html);

        TestContext.Out.WriteLine(bytes);
        Assert.That(bytes, Is.LessThan(5_000_000)); // measured 4.47e6
    }

    [Test]
    public void A_page_that_cannot_be_put_in_its_place_leaves_all_as_it_was()
    {
        using TemporaryFolder folder = new();
        Directory.CreateDirectory(folder.File("out/report.html"));
        File.WriteAllText(folder.File("out/trajectory.csv"), "old");

        LabProcess compare = LabProcess.Run(folder.Path), run = LabProcess.Run(folder.Path, "run", Gallery.Lab, "--every", "0", "--report", "out/report.html");

        Assert.That(new[] { compare.ExitCode, run.ExitCode }, Is.EqualTo(new[] { 2, 2 }));
        Assert.That(compare.Error + run.Error, Does.Contain("is a folder"));
        Assert.That(File.ReadAllText(folder.File("out/trajectory.csv")), Is.EqualTo("old"));
        Assert.That(Directory.GetFileSystemEntries(folder.File("out")), Has.Length.EqualTo(2));
    }

    [Test]
    public void Run_writes_a_page_only_when_asked_and_says_with_what()
    {
        using TemporaryFolder folder = new();

        LabProcess without = LabProcess.Run(folder.Path, "run", Gallery.Lab, "--every", "0");
        string[] before = Directory.GetFileSystemEntries(folder.Path);
        LabProcess with = LabProcess.Run(folder.Path, "run", Gallery.Lab, "--every", "0", "--step", "0.01", "--integrator", "Exact", "--report", "页 1.html");

        Assert.That(before, Is.Empty);
        Assert.That(with.ExitCode, Is.Zero, with.Error);
        Assert.That(with.Output.Split('\n')[0], Is.EqualTo(without.Output.Split('\n')[0]));
        Parsed page = new(File.ReadAllText(folder.File("页 1.html")));
        Assert.That(page.Document.QuerySelector("code")!.TextContent, Does.EndWith("run lab.json --integrator Exact --step 0.01 --report \"页 1.html\""));
        Assert.That(page.Data.GetProperty("times").GetArrayLength(), Is.EqualTo(1001));
        Assert.That(page.Document.GetElementById("rules"), Is.Null);
    }

    [Test]
    public void A_recording_stands_beside_ours_with_all_its_differences()
    {
        using TemporaryFolder folder = new();

        LabProcess lab = LabProcess.Run(folder.Path, "compare", PartingRecording.In(folder));

        Parsed page = new(File.ReadAllText(folder.File("out/report.html")));
        Assert.That(lab.ExitCode, Is.EqualTo(1));
        Assert.That(page.Document.QuerySelector("#recording .lead")!.TextContent, Does.Contain("step " + PartingRecording.PartsAt));
        Assert.That(page.Document.QuerySelectorAll("#recording tbody tr"), Has.Length.EqualTo(4));
        Assert.That(page.Document.QuerySelector("#recording .lead + p")!.TextContent, Does.Contain("is above the tolerance of").And.Contain("超过容差"));
        Assert.That(Parsed.Numbers(page.Data.GetProperty("pairs")[0].GetProperty("angle")).Max(), Is.GreaterThan(0.01));
        Assert.That(Parsed.Numbers(page.Data.GetProperty("pairs")[0].GetProperty("spin")).Max(), Is.GreaterThan(0));
    }

    private static void Same(double[] found, string[][] rows, int column, int width, double within) =>
        Assert.That(found, Is.EqualTo(rows.SelectMany(row => row.Skip(column).Take(width).Select(Number))).Within(within));

    private static string[][] Rows(string path) =>
        [.. File.ReadLines(path).Skip(1).Select(line => line.Replace("\"", string.Empty).Split(','))];

    private static double Number(string cell) => double.Parse(cell, CultureInfo.InvariantCulture);
}
