using NUnit.Framework;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.Tests.SceneFiles;

/// <summary>
/// Moments that no body has are refused by body, field, value and reason, and with the nearest that one can have; moments that break the triangle
/// by the rounding of their digits alone are accepted, with a note. Descriptions of robots are full of both.
/// </summary>
public sealed class ImpossibleInertiaTests
{
    [TestCase("\"inertia\": { \"principal\": [1.11, 100.11, 1.01] }", "inertia.principal: no moment can exceed the sum of the other two, and the nearest that do not are (33.77", "), found (1.11, 100.11, 1.01)")]
    [TestCase("\"inertia\": { \"principal\": [0.000231875699, 0.000147497311, 0.0000786269902] }", "inertia.principal: no moment can exceed", "found (0.000231875699, 0.000147497311, 7.86269902E-05)")]
    [TestCase("\"inertia\": { \"tensor\": { \"xx\": 1, \"yy\": 2, \"zz\": 4, \"xy\": 0.1 } }", "inertia.tensor: no moment can exceed", "found principal moments (0.990")]
    [TestCase("\"inertia\": { \"principal\": [0, 1, 1] }", "inertia.principal: all points lie on a line along x, so the inertia about it is zero", "found (0, 1, 1)")]
    [TestCase("\"inertia\": { \"principal\": [1, 0, 1] }", "inertia.principal: all points lie on a line along y, so the inertia about it is zero", "found (1, 0, 1)")]
    [TestCase("\"inertia\": { \"principal\": [1, 1, 0], \"frame\": [1, 1, 0, 0] }", "inertia.principal: all points lie on a line along y,", "found (1, 1, 0)")]
    [TestCase("\"inertia\": { \"tensor\": { \"xx\": 1, \"yy\": 1, \"zz\": 1e-17 , \"xz\": 1e-17 } }", "inertia.tensor: all points lie on a line along z,", "found principal moments (1, 1, 1E-17)")]
    [TestCase("\"inertia\": { \"points\": [[1, 2, 3], [4, 6, 3], [-2, -2, 3]] }", "inertia.points: all points lie on a line along (0.6, 0.8, 0), so the inertia about it is zero", "found principal moments (")]
    [TestCase("\"inertia\": { \"points\": [[1, 2, 3], [1, 2, 3]] }", "inertia.points: all points are one, so the inertia is zero", "found principal moments (0, 0, 0)")]
    [TestCase("\"mass\": 0, \"inertia\": { \"principal\": [1, 1, 1] }", "mass: must be finite and above zero", "found 0")]
    [TestCase("\"inertia\": { \"ixx\": 0.1, \"iyy\": 0.1, \"izz\": 0.1 }", "inertia: must name its six numbers \"tensor\": { \"xx\", ", "found ixx, iyy, izz")]
    [TestCase("\"mass\": 2, \"about\": \"origin\", \"centerOfMass\": [0, 1, 0], \"inertia\": { \"principal\": [0.5, 0.2, 0.5] }", "about: from the origin to the centre of mass (0, 1, 0) the principal moments become (-1.5, 0.2, -1.5), which no body has; is the inertia about the centre of mass already?", "already?")]
    public void What_no_body_has_is_refused_by_body_field_reason_and_value(string fields, string reason, string found)
    {
        string error = SceneText.Error(Scene(fields));

        Assert.That(error, Does.StartWith("scene.json: bodies[0]." + reason));
        Assert.That(error, Does.Contain(found).And.EndWith(", in body \"link\""));
    }

    [TestCase("[0.333333, 0.333333, 0.666667]", 1e-6)]
    [TestCase("[0.666667, 0.333333, 0.333333]", 1e-6)]
    [TestCase("[3.33333e-1, 33.3333e-2, 666667e-6]", 1e-6)]
    [TestCase("[0.25, 0.333333, 0.583334]", 1e-6)]
    [TestCase("[0.000123, 0.333333, 0.333457]", 1e-6)]
    [TestCase("[0.0123457, 0.333333, 0.345679]", 3e-7)]
    [TestCase("[0.333, 0.333, 0.667]", 1e-3)]
    public void Rounded_moments_are_moved_to_the_nearest_of_a_body_and_the_user_is_told(string principal, double excess)
    {
        SceneFile file = SceneText.Read(Scene($"\"inertia\": {{ \"principal\": {principal} }}"));
        Vector3d moments = file.Scene.Bodies[0].Mass.PrincipalMoments, given = SceneText.Tree(principal) is var list ? new Vector3d((double)list[0]!, (double)list[1]!, (double)list[2]!) : default;
        double[] sorted = [moments.X, moments.Y, moments.Z];
        Array.Sort(sorted);

        Assert.That(sorted[2] - sorted[1] - sorted[0], Is.EqualTo(0).Within(2e-16)); // measured 1.1e-16
        Assert.That(Samples.Apart(moments, given), Is.LessThan(0.5 * excess)); // measured 1/3 of it
        Assert.That(file.Notes["link"], Has.Exactly(1).Contains("exceeds the sum of the other two by ").And.One.Contains("as roundings to these digits can do; taken as " + moments));
    }

    [TestCase("[0.333333, 0.333333, 0.666669]")]
    [TestCase("[0.333333000001, 0.333333, 0.666667]")]
    [TestCase("[0.33, 0.33, 0.67]")]
    [TestCase("[1, 1, 3]")]
    public void What_rounding_cannot_have_done_is_refused(string principal) =>
        Assert.That(SceneText.Error(Scene($"\"inertia\": {{ \"principal\": {principal} }}")), Does.Contain("no moment can exceed the sum of the other two"));

    [Test]
    public void Rounded_tensor_of_a_plate_in_any_plane_is_accepted_and_one_with_a_larger_error_is_not()
    {
        // a plate of 0.2 and 0.3 kg m² in its plane has 0.5 across; six decimals of its tensor in other axes
        double worst = 0;
        int notes = 0;
        for (int i = 1; i <= 200; i++)
        {
            Quaterniond turn = new Quaterniond(1, Math.Sin(i), Math.Cos(2.3 * i), Math.Sin(0.7 * i)).Normalized;
            double[,] plate = FullMatrix.Tensor(new Vector3d(0.2, 0.3, 0.5), turn);
            SceneFile file = SceneText.Read(Scene(Tensor(plate, 0)));
            worst = Math.Max(worst, FullMatrix.Apart(FullMatrix.Of(file.Scene.Bodies[0].Mass.Inertia), plate));
            notes += file.Notes.Count;
            // (1, 1, 1) cm² kg more about one axis is no rounding
            Assert.That(SceneText.Error(Scene(Tensor(plate, 1e-4))), Does.Contain("no moment can exceed"), $"{i}");
        }

        Assert.That(worst, Is.LessThan(1.5e-6)); // measured 6.7e-7: half a unit by the file, the rest by the move
        Assert.That(notes, Is.InRange(60, 140)); // measured 100: about half of all roundings break the triangle

        static string Tensor(double[,] i, double more) => FormattableString.Invariant(
            $"\"inertia\": {{ \"tensor\": {{ \"xx\": {i[0, 0] - more:f6}, \"yy\": {i[1, 1] - more:f6}, \"zz\": {i[2, 2] - more:f6}, \"xy\": {i[0, 1]:f6}, \"xz\": {i[0, 2]:f6}, \"yz\": {i[1, 2]:f6} }} }}");
    }

    [TestCase(new[] { "0.333333", "0.25", "1e-3" }, new[] { 5e-7, 5e-7, 5e-7 })]
    [TestCase(new[] { "0.333333", "0.0123457", "12.3456" }, new[] { 5e-7, 5e-8, 5e-5 })]
    [TestCase(new[] { "1.50E+2", "-0.5", "", "0" }, new[] { 0.5, 0.05, 0, 0.05 })]
    [TestCase(new[] { "1", "2", "2.5" }, new[] { 0, 0, 0.0 })]
    public void Half_units_are_those_of_the_digits_that_stand_there_or_were_left_out(string[] texts, double[] expected) =>
        Assert.That(TypedDigits.HalfUnits(texts), Is.EqualTo(expected).Within(1e-12).Percent); // measured 2e-14 percent

    [Test]
    public void Command_line_says_the_note_once_on_standard_error_and_explain_among_its_notes()
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder.File("plate.json"), Scene("\"inertia\": { \"principal\": [0.333333, 0.333333, 0.666667] }"));

        LabProcess run = LabProcess.Run(folder.Path, "run", "plate.json"), explain = LabProcess.Run(folder.Path, "explain", "plate.json");

        Assert.That((run.ExitCode, explain.ExitCode), Is.EqualTo((0, 0)));
        Assert.That(run.Error, Does.StartWith("note: plate.json: bodies[0].inertia.principal: principal moment 0.666667 exceeds the sum of the other two by 1e-06"));
        Assert.That(run.Error.Trim(), Does.EndWith("in body \"link\"").And.Not.Contain("\n"));
        Assert.That(explain.Output, Does.Contain("\n  body: 1 kg, principal moments (0.333333, 0.333333, 0.666667) kg m²\n  note: bodies[0].inertia.principal: principal moment 0.666667"));
        Assert.That(explain.Error, Is.Empty);
    }

    [Test]
    public void Nearest_possible_moments_are_nearer_than_any_others_that_were_tried()
    {
        Vector3d given = new(1, 2, 3.6), nearest = MassProperties.NearestPossible(given, new Vector3d(1, 1, 1));
        Assert.That(Samples.Apart(nearest, new Vector3d(1.2, 2.2, 3.4)), Is.LessThan(1e-15)); // measured 2.2e-16
        for (int i = 0; i < 1000; i++)
        {
            Vector3d other = nearest + 0.1 * new Vector3d(Math.Sin(3 * i), Math.Sin(5 * i + 1), Math.Sin(7 * i + 2));
            if (other.Z <= other.X + other.Y)
                Assert.That((other - given).Length, Is.GreaterThan((nearest - given).Length));
        }

        Assert.That(MassProperties.NearestPossible(new Vector3d(1, 2, 3), new Vector3d(1, 1, 1)), Is.EqualTo(new Vector3d(1, 2, 3)));
    }

    private static string Scene(string fields) =>
        """{ "schema": "rigid-body-scene/1", "name": "n", "step": 0.1, "steps": 3, "bodies": [ { "name": "link", """ + fields + " } ] }";
}
