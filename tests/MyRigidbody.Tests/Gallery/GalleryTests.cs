using NUnit.Framework;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Tests.Repository;
using static RigidBodyDynamics.Tests.Samples;

namespace RigidBodyDynamics.Tests;

/// <summary>The descriptions of the gallery's scenes are true, and their pictures are of them.</summary>
public sealed class GalleryTests
{
    private static readonly string[] Pictured = ["thruster", "locked-door", "rocket", "hammer", "t-handle", "homework"];

    [TestCaseSource(nameof(Pictured))]
    public void Picture_on_the_page_is_of_the_scene(string scene)
    {
        string picture = Filmstrip.Of(Path.Combine(Gallery.Folder, scene + ".json")), file = Root.File($"docs/images/scene-{scene}.svg");
        if (Environment.GetEnvironmentVariable("MYRIGIDBODY_WRITE") == "1")
            File.WriteAllText(file, picture);

        Assert.That(File.ReadAllText(file), Is.EqualTo(picture), "MYRIGIDBODY_WRITE=1 draws it anew: look at it");
        Assert.That(File.ReadAllText(Root.File("docs/scenes.md")), Does.Contain($"](images/scene-{scene}.svg)"));
        Assert.That(File.ReadAllText(Root.File("docs/scenes.zh.md")), Does.Contain($"](images/scene-{scene}.svg)"));
    }

    [Test]
    public void Thruster_at_the_centre_of_mass_drives_straight_and_one_beside_it_turns_the_ship_ever_faster()
    {
        BodyState[] end = End("thruster");
        Assert.That(Apart(end[0].Velocity, new Vector3d(0, 2.5, 0)), Is.LessThan(1e-13)); // 0.5 N / 2 kg × 10 s
        Assert.That(end[0].AngularVelocity.IsZero, Is.True);
        Assert.That(end[1].AngularVelocity.Z, Is.EqualTo(-0.5 * 0.5 / (2.0 / 12 * 5) * 10).Within(1e-13)); // measured 4.4e-16
    }

    [Test]
    public void Door_on_its_axle_turns_about_that_alone()
    {
        BodyState[] end = End("locked-door");
        Vector3d start = new(-1.5, 0, 0);
        Assert.That(end[0].Position, Is.EqualTo(start));
        Assert.That(Apart(end[0].AngularVelocity, new Vector3d(0, -0.8 * 10 / (20.0 / 12 * (1.6 * 1.6 + 0.01)), 0)), Is.LessThan(1e-14)); // measured 2.2e-16
        Assert.That(Math.Abs(end[0].Orientation.X) + Math.Abs(end[0].Orientation.Z), Is.Zero);
        Assert.That(Apart(end[1].Velocity, new Vector3d(0, 0, 0.5)), Is.LessThan(1e-15));
        Assert.That(Math.Abs(end[1].AngularVelocity.X), Is.GreaterThan(1));
    }

    [Test]
    public void Rocket_that_burns_has_the_logarithm_s_speed_and_comes_higher()
    {
        BodyState[] end = End("rocket");
        double free = -9.81 * 10;
        Assert.That(end[0].Velocity.Y, Is.EqualTo(120 * Math.Log(5) + free).Within(1e-11)); // measured 1.4e-14
        Assert.That(end[1].Velocity.Y, Is.EqualTo(60.0 / 5 * 8 + free).Within(1e-11)); // measured 1e-14
        Assert.That(end[0].Position.Y / end[1].Position.Y, Is.GreaterThan(5)); // measured 5.5
    }

    [Test]
    public void Centre_of_a_tossed_hammer_flies_a_parabola()
    {
        SceneFile file = SceneReader.Read(Path.Combine(Gallery.Folder, "hammer.json"));
        Simulation simulation = new(file.Scene);
        Vector3d centre = new(0, 0.2 / 1.3, 0);
        Assert.That(Apart(file.Scene.Bodies[0].Mass.CenterOfMass, centre), Is.LessThan(1e-15));
        for (int step = 1; step <= 150; step++)
        {
            simulation.Step();
            double t = simulation.Time;
            BodyState now = simulation.Bodies[0].State;
            Assert.That(Apart(now.Position + now.Orientation.Rotate(centre), centre + new Vector3d(t, 7 * t - 0.5 * 9.81 * t * t, 0)), Is.LessThan(1e-13)); // measured 4.4e-15
        }
    }

    [Test]
    public void Box_of_a_homework_turns_otherwise_than_by_the_laws_and_moves_alike()
    {
        BodyState[] end = End("homework");
        Assert.That(Conserved.AngleBetween(end[0].Orientation, end[1].Orientation), Is.GreaterThan(0.3));
        Assert.That((end[0].Position - end[1].Position).Length, Is.EqualTo(3).Within(0.05));
    }

    private static BodyState[] End(string scene)
    {
        SceneFile file = SceneReader.Read(Path.Combine(Gallery.Folder, scene + ".json"));
        Simulation simulation = new(file.Scene);
        simulation.Step(file.Scene.Steps.Count);
        return [.. simulation.Bodies.Select(body => body.State)];
    }
}
