using System.Globalization;
using NUnit.Framework;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Tests.CommandLine;

namespace RigidBodyDynamics.Tests.SceneFiles;

/// <summary>The library gets what a scene file says.</summary>
public sealed class SceneReaderTests
{
    [Test]
    public void Every_name_of_the_format_arrives()
    {
        SceneFile file = SceneText.Read(SceneText.Everything);
        SceneDescription scene = file.Scene;
        BodyDescription a = scene.Bodies[0], b = scene.Bodies[1], e = scene.Bodies[4], g = scene.Bodies[6];

        Assert.That(scene.Name, Is.EqualTo("all"));
        Assert.That(scene.About, Is.EqualTo("every name"));
        Assert.That(scene.Steps.Count, Is.EqualTo(50));
        Assert.That(a.Rule.Name, Is.EqualTo("LabEuler"));
        Assert.That(a.Mass.Mass, Is.EqualTo(2));
        // m/4 (b² + c²) of a box with all mass in its vertices
        Assert.That(a.Mass.PrincipalMoments.X, Is.EqualTo(2.0 / 4 * (4 + 9)).Within(1e-14)); // measured 0
        Assert.That(a.Mass.CenterOfMass, Is.EqualTo(new Vector3d(0.1, 0, 0)));
        Assert.That(a.Start.Position, Is.EqualTo(new Vector3d(1, 2, 3)));
        Assert.That(a.Start.Orientation, Is.EqualTo(new Quaterniond(1, 0, 0, 1)));
        Assert.That(a.Start.Velocity, Is.EqualTo(new Vector3d(1, 0, 0)));
        Assert.That(a.Start.AngularVelocity, Is.EqualTo(new Vector3d(0, 1, 0)));
        Assert.That(a.Lab.UnitRotation, Is.True);
        Assert.That(
            a.Effects.Select(effect => effect.Motion.GetType().Name).Take(12),
            Is.EqualTo(new[]
            {
                "Gravity", "Force", "KeyPush", "Torque", "LinearDamping", "AngularDamping", "QuadraticDrag", "DecayPerStep", "DecayPerStep",
                "Force", "Spring", "PerStep",
            }));
        Assert.That(a.Effects[0].To, Is.EqualTo(0.25));
        Assert.That(a.Effects[2].From, Is.EqualTo(0.1));
        Assert.That(a.Effects[2].To, Is.EqualTo(double.PositiveInfinity));
        Assert.That(b.Unity.Drag, Is.EqualTo(0.1));
        Assert.That(b.Unity.AngularDrag, Is.EqualTo(0.2));
        Assert.That(b.Unity.MaxAngularVelocity, Is.EqualTo(9));
        Assert.That(b.Unity.SleepThreshold, Is.EqualTo(0.01));
        Assert.That(b.Unity.WakeCounter, Is.EqualTo(0.2));
        Assert.That(b.Unity.GyroscopicForces, Is.True);
        Assert.That(b.Unity.InDouble, Is.True);
        // the ball about the pivot, 2/5 m r² and along two axes m d² more
        Assert.That(g.Mass.PrincipalMoments, Is.EqualTo(new Vector3d(0.1, 0.14, 0.14)).Using<Vector3d>((x, y) => Samples.Apart(x, y) < 1e-16)); // measured 0
        Assert.That(g.Effects[0].Motion, Is.InstanceOf<HeavyTop>());
        Assert.That(e.Mass.Mass, Is.EqualTo(10));
        Assert.That(e.Mass.CenterOfMass, Is.EqualTo(new Vector3d(0.2, 0.3, 0.4)));
    }

    [Test]
    public void Effects_act_as_they_are_written()
    {
        SceneDescription scene = SceneText.Read(SceneText.Everything).Scene;
        Wrench wrench = default;
        BodyDescription a = scene.Bodies[0];
        foreach (IPush push in a.Effects.Select(effect => effect.Motion).OfType<IPush>().Where(push => push is Force or KeyPush or Torque).Take(3))
            push.At(new Instant(0, 0.5), BodyState.AtRest, a.Mass, ref wrench);

        Assert.That(wrench.Force, Is.EqualTo(new Vector3d(1, 5, 0)));
        Assert.That(wrench.BodyTorque.X, Is.EqualTo(1));
        Assert.That(wrench.BodyTorque.Y, Is.EqualTo(Math.Sin(1)).Within(1e-15)); // measured 0
        Assert.That(wrench.BodyTorque.Z, Is.EqualTo(Math.Cos(1)).Within(1e-15)); // measured 0
    }

    [Test]
    public void A_body_of_which_nothing_is_said_is_a_unit_solid_box_at_rest()
    {
        BodyDescription body = SceneText.Read("""
            { "schema": "rigid-body-scene/1", "name": "n", "step": 1, "steps": 3, "bodies": [ { "name": "b" } ] }
            """).Scene.Bodies[0];

        Assert.That(body.Mass.Mass, Is.EqualTo(1));
        Assert.That(body.Mass.PrincipalMoments.X, Is.EqualTo(1.0 / 6).Within(1e-16)); // measured 0
        Assert.That(body.Start, Is.EqualTo(BodyState.AtRest));
        Assert.That(body.Rule.Name, Is.EqualTo(Rules.Default.Name));
        Assert.That(body.CanMove && body.CanTurn, Is.True);
        Assert.That(body.Effects, Is.Empty);
    }

    [Test]
    public void Comments_trailing_commas_and_a_byte_order_mark_are_accepted()
    {
        SceneFile file = SceneText.Read("\uFEFF" + """
            { // a scene
              "schema": "rigid-body-scene/1", "name": "注释", "step": [0.1, 0.2,], /* two steps */
              "bodies": [ { "name": "物体", }, ],
            }
            """);

        Assert.That(file.Scene.Name, Is.EqualTo("注释"));
        Assert.That(file.Scene.Bodies[0].Name, Is.EqualTo("物体"));
        Assert.That(file.Scene.Steps.StartOf(2), Is.EqualTo(0.1 + 0.2));
    }

    [Test]
    public void Spin_in_body_axes_turns_with_the_body()
    {
        // a quarter turn about z takes the body's x axis to the world's y axis
        BodyDescription body = SceneText.Read("""
            { "schema": "rigid-body-scene/1", "name": "n", "step": 1, "steps": 3,
              "bodies": [ { "name": "b", "orientation": [2, 0, 0, 2], "angularVelocityBody": [3, 0, 0] } ] }
            """).Scene.Bodies[0];

        Assert.That((body.Start.AngularVelocity - new Vector3d(0, 3, 0)).Length, Is.LessThan(1e-15)); // measured 6.3e-16
    }

    [Test]
    public void A_box_of_vertices_comes_with_its_solid_box()
    {
        SceneFile file = SceneText.Read(SceneText.Everything);

        Assert.That(file.SolidBoxes.Keys, Is.EqualTo(new[] { "a" }));
        // m/12 (b² + c²), and the same centre of mass
        Assert.That(file.SolidBoxes["a"].PrincipalMoments.X, Is.EqualTo(2.0 / 12 * (4 + 9)).Within(1e-15)); // measured 0
        Assert.That(file.SolidBoxes["a"].CenterOfMass, Is.EqualTo(new Vector3d(0.1, 0, 0)));
    }

    [TestCase("tr-TR")]
    [TestCase("de-DE")]
    [TestCase("fa-IR")]
    public void Numbers_and_errors_are_the_same_in_every_language(string culture)
    {
        CultureInfo before = CultureInfo.CurrentCulture;
        try
        {
            // the invariant mode of the tests knows no cultures: a decimal comma of our own stands for them
            CultureInfo foreign = (CultureInfo)CultureInfo.InvariantCulture.Clone();
            foreign.NumberFormat.NumberDecimalSeparator = culture == "fa-IR" ? "٫" : ",";
            foreign.NumberFormat.NegativeSign = "−";
            CultureInfo.CurrentCulture = foreign;
            Assert.That(SceneText.Read(SceneText.Everything).Scene.Bodies[0].Effects[0].To, Is.EqualTo(0.25));
            Assert.That(
                SceneText.Error(SceneText.Everything.Replace("0.98 },", "-1.5 },", StringComparison.Ordinal)),
                Does.EndWith("must be a factor from 0 to 1, found -1.5"));
        }
        finally
        {
            CultureInfo.CurrentCulture = before;
        }
    }

    [Test]
    public void A_hundred_megabytes_of_brackets_are_refused_at_once()
    {
        using TemporaryFolder folder = new();
        string path = folder.File("brackets.json");
        byte[] brackets = new byte[100_000_000];
        Array.Fill(brackets, (byte)'[');
        File.WriteAllBytes(path, brackets);

        Assert.That(() => SceneReader.Read(path), Throws.TypeOf<InputException>().With.Message.Contains("line 1, column"));
    }
}
