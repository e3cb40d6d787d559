using NUnit.Framework;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.Tests.SceneFiles;

/// <summary>A recording of a real Rigidbody is a scene.</summary>
public sealed class RecordingTests
{
    private static IEnumerable<string> Names =>
        Directory.GetFiles(TestData.Physx(string.Empty), "*.json").Select(path => Path.GetFileNameWithoutExtension(path)!).Order();

    [TestCase("frozen/upright")]
    [TestCase("frozen/hinge")]
    [TestCase("frozen/one_axis")]
    [TestCase("frozen/one_axis_gyro_on")]
    [TestCase("frozen/all_but_y")]
    [TestCaseSource(nameof(Names))]
    public void Read_as_a_scene_and_run_it_repeats_what_was_recorded(string name)
    {
        SceneFile file = SceneReader.Read(TestData.Physx(name + ".json"));
        Simulation simulation = new(file.Scene);

        for (int row = 0; row < file.Recording!.Rows.Count; row++)
        {
            BodyState s = simulation.Bodies[0].State;
            Quaterniond q = s.Orientation;
            float[] ours =
            [
                (float)s.Position.X, (float)s.Position.Y, (float)s.Position.Z, (float)q.X, (float)q.Y, (float)q.Z, (float)q.W,
                (float)s.Velocity.X, (float)s.Velocity.Y, (float)s.Velocity.Z,
                (float)s.AngularVelocity.X, (float)s.AngularVelocity.Y, (float)s.AngularVelocity.Z,
            ];
            Assert.That(ours, Is.EqualTo(file.Recording.Rows[row].Take(ours.Length)), "row " + row);
            Assert.That(simulation.Bodies[0].IsAsleep, Is.EqualTo(file.Recording.IsAsleep(row)), "row " + row);
            simulation.Step(row + 1 < file.Recording.Rows.Count ? 1 : 0);
        }

        Assert.That(file.Recording.Rows.Count, Is.EqualTo(file.Scene.Steps.Count + 1));
    }

    [Test]
    public void All_twenty_three_recordings_are_here() => Assert.That(Names.Count(), Is.EqualTo(23));

    [Test]
    public void Without_its_CSV_a_recording_can_be_run_but_not_compared()
    {
        using TemporaryFolder folder = new();
        File.Copy(TestData.Physx("g_nudge.json"), folder.File("g.json"));

        LabProcess run = LabProcess.Run(folder.Path, "run", "g.json", "--every", "0"), compare = LabProcess.Run(folder.Path, "compare", "g.json");

        Assert.That(run.ExitCode, Is.Zero, run.Error);
        Assert.That(compare.ExitCode, Is.EqualTo(2));
        Assert.That(compare.Error, Does.StartWith("error: g.csv: there is no such file"));
    }

    [TestCase("\n1,0.0199999996,", "\n1,0.0199999996,x", "line 3: must be finite numbers, found x")]
    [TestCase("\n2,0.0399999991,", "\n2,0.0399999991,0,", "line 4: must have 17 numbers, found 18")]
    [TestCase("step,t", "time,t", "line 1: must be step,t,px")]
    public void A_damaged_CSV_is_refused_with_its_line(string find, string put, string expected)
    {
        using TemporaryFolder folder = new();
        File.Copy(TestData.Physx("g_nudge.json"), folder.File("g.json"));
        string csv = File.ReadAllText(TestData.Physx("g_nudge.csv"));
        Assert.That(csv, Does.Contain(find));
        File.WriteAllText(folder.File("g.csv"), csv.Replace(find, put, StringComparison.Ordinal));

        Assert.That(
            () => SceneReader.Read(folder.File("g.json")),
            Throws.TypeOf<InputException>().With.Message.Contains("g.csv: " + expected));
    }

    // as single precision rounds them: the third is 8e-9 more than the sum of the others
    [TestCase("[0.1, 0.2, 0.3]")]
    [TestCase("[0.7, 0.1, 0.8]")]
    public void Flat_body_whose_moments_are_rounded_to_single_precision_is_read_and_rounds_to_the_same(string moments)
    {
        using TemporaryFolder folder = new();
        string json = File.ReadAllText(TestData.Physx("g_nudge.json")).Replace("[0.166666672, 0.166666672, 0.166666672]", moments, StringComparison.Ordinal);
        File.WriteAllText(folder.File("g.json"), json);

        Vector3d read = SceneReader.Read(folder.File("g.json")).Scene.Bodies[0].Mass.PrincipalMoments;

        Assert.That($"[{(float)read.X}, {(float)read.Y}, {(float)read.Z}]", Is.EqualTo(moments));
        Assert.That((float)0.1 + (double)(float)0.2, Is.LessThan((float)0.3 * (1 - 1e-9)), "what single precision does");
    }

    [Test]
    public void A_CSV_that_ends_early_is_refused()
    {
        using TemporaryFolder folder = new();
        File.Copy(TestData.Physx("g_nudge.json"), folder.File("g.json"));
        File.WriteAllLines(folder.File("g.csv"), File.ReadLines(TestData.Physx("g_nudge.csv")).SkipLast(1));

        Assert.That(
            () => SceneReader.Read(folder.File("g.json")),
            Throws.TypeOf<InputException>().With.Message.Contains("must have 501 rows"));
    }

    [TestCase("\"mass\": 1,", "\"mass\": -1,", "mass: must be finite and above zero, found -1")]
    [TestCase("\"mass\": 1,", "\"mass\": 1e39,", "mass: must be a number that fits single precision, found 1e39")]
    [TestCase("\"steps\": 500", "\"steps\": 499", "dt: must have 499 numbers, found 500")]
    [TestCase("[0.166666672, 0.166666672, 0.166666672]", "[1, 1, 3]", "g.json: inertiaTensor: no moment can exceed the sum of the other two, and the nearest that do not are (1.3333333333333333, 1.3333333333333333, 2.6666666666666665), found (1, 1, 3)")]
    [TestCase("[0.166666672, 0.166666672, 0.166666672]", "[1, -1, 1]", "g.json: inertiaTensor: must have finite components above zero, found (1, -1, 1)")]
    [TestCase("[0.166666672, 0.166666672, 0.166666672]", "[1, 1]", "g.json: inertiaTensor: must have 3 numbers, found 2")]
    [TestCase("\"inertiaTensorRotation\": [0, 0, 0, 1]", "\"inertiaTensorRotation\": [0, 0, 0, 0]", "g.json: inertiaTensorRotation: must be a quaternion [w, x, y, z] of length 1 or one that can be scaled to it, found [0, 0, 0, 0]")]
    [TestCase("\"linearDamping\": 0", "\"linearDamping\": -1", "g.json: linearDamping: must be finite and not below zero, found -1")]
    [TestCase("\"angularDamping\": 0.0500000007", "\"angularDamping\": -1", "g.json: angularDamping: must be finite and not below zero, found -1")]
    [TestCase("\"linearVelocity\": [0.00800000038, 0, 0],", "\"linearVelocity\": [0.00800000038, 0, 0], \"lock\": { \"move\": \"x\" },", "g.json: linearVelocity: must be zero along the locked x, found (0.00800000037997961, 0, 0)")]
    [TestCase("\"useGravity\"", "\"usesGravity\"", "\"useGravity\" is missing")]
    public void A_damaged_recording_is_refused_by_place_and_value(string find, string put, string expected)
    {
        using TemporaryFolder folder = new();
        string json = File.ReadAllText(TestData.Physx("g_nudge.json"));
        Assert.That(json, Does.Contain(find));
        File.WriteAllText(folder.File("g.json"), json.Replace(find, put, StringComparison.Ordinal));

        Assert.That(() => SceneReader.Read(folder.File("g.json")), Throws.TypeOf<InputException>().With.Message.EndsWith(expected));
    }
}
