using NUnit.Framework;
using RigidBodyDynamics.Lab;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Tests.SceneFiles;

/// <summary>Inputs made after public reports about engines, with the right value. Forces at a point are in ForceTests.</summary>
public sealed class ReportsTests
{
    [TestCase("lock.json", "bodies[0].freezeRotation: is not a name known here")]
    [TestCase("lock2.json", "bodies[0].canTurn: must be true or false")]
    [TestCase("lock3.json", "bodies[0].inertia.principal[0]: must be a number")]
    public void Lock_under_another_name_is_refused_where_it_stands(string file, string says)
    {
        string path = TestData.Path("reports", "08-locked-axes", file);
        Assert.That(() => SceneReader.Read(path), Throws.InstanceOf<InputException>().With.Message.StartsWith(path + ": " + says));
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Locked_about_x_and_z_a_body_turns_about_y_alone(string rule)
    {
        BodyDescription body = SceneText.Read("""
            { "schema": "rigid-body-scene/1", "name": "lock", "step": 0.02, "duration": 2, "bodies": [ { "name": "upright",
              "inertia": { "principal": [0.5, 0.5, 0.5] }, "lock": { "turn": "xz" }, "effects": [ { "torque": { "constant": [1, 1, 1] } } ] } ] }
            """).Scene.Bodies[0];
        body.Rule = Scenery.Body(rule).Rule;
        body.Unity = new UnitySettings { AngularDrag = 0, InDouble = rule != "UnityRigidbody" };
        BodyState end = Scenery.Run(TimeSteps.Every(0.02), body, 100);
        Assert.That(end.AngularVelocity.Y, Is.EqualTo(4).Within(rule == "UnityRigidbody" ? 5e-6 : 1e-13)); // measured 2.6e-6 in single precision
        Assert.That(Math.Abs(end.AngularVelocity.X) + Math.Abs(end.AngularVelocity.Z), Is.LessThan(1e-15)); // measured 0
        Assert.That(Math.Abs(end.Orientation.X) + Math.Abs(end.Orientation.Z), Is.LessThan(1e-15)); // measured 0
    }

    [Test]
    public void Recording_whose_inertia_tensor_has_zeros_turns_about_y_alone()
    {
        SceneFile file = SceneReader.Read(TestData.Path("reports", "08-locked-axes", "frozen.json"));
        Assert.That(file.Scene.Bodies[0].Lock, Is.EqualTo(Locks.TurnX | Locks.TurnZ));
        BodyState end = Scenery.Run(file.Scene.Steps, file.Scene.Bodies[0], 500);
        Assert.That(end.AngularVelocity.Y, Is.GreaterThan(1));
        Assert.That(end.AngularVelocity.X, Is.Zero);
        Assert.That(end.AngularVelocity.Z, Is.Zero);
    }

    [TestCase("damping-30.json")]
    [TestCase("damping-60.json")]
    [TestCase("damping-200.json")]
    public void Damped_velocity_after_a_second_is_the_same_at_every_rate(string file)
    {
        SceneFile scene = SceneReader.Read(TestData.Path("reports", "09-damping-tick-rate", file));
        Simulation simulation = new(scene.Scene);
        simulation.Step(scene.Scene.Steps.Count);
        Body[] exact = [.. simulation.Bodies.Where(body => body.Rule.Name.StartsWith("Exact", StringComparison.Ordinal) && !body.Name.StartsWith("torque", StringComparison.Ordinal))];
        Assert.That(exact, Has.Length.EqualTo(4));
        foreach (Body body in exact)
            Assert.That(body.State.Velocity.X, Is.EqualTo(800.0 / 30 * (1 - Math.Exp(-30))).Within(2e-14), body.Name); // measured 7.1e-15
    }

    [TestCase(0.02, 0.010, 0.0245)]
    [TestCase(0.01, 0.005, 0.01225)]
    public void Unit_cube_sleeps_at_or_below_the_speeds_of_the_report(double step, double speed, double spin)
    {
        Assert.That(Sleeps(0.99 * speed, 0), Is.True);
        Assert.That(Sleeps(1.01 * speed, 0), Is.False);
        Assert.That(Sleeps(0, 0.99 * spin), Is.True);
        Assert.That(Sleeps(0, 1.01 * spin), Is.False);

        bool Sleeps(double v, double w)
        {
            BodyDescription cube = new("cube", Solids.Box(1, new Vector3d(1, 1, 1)))
            {
                Rule = Rules.UnityRigidbody,
                Unity = new UnitySettings { AngularDrag = 0 },
                Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(v, 0, 0), new Vector3d(0, 0, w)),
            };
            Simulation simulation = new(TimeSteps.Every(step), cube);
            simulation.Step((long)(2 / step));
            return simulation.Bodies[0].IsAsleep;
        }
    }

    [Test]
    public void Explanation_says_over_which_time_the_velocities_are_summed_before_a_body_sleeps()
    {
        SceneFile file = SceneReader.Read(TestData.Path("reports", "12-slow-rotation-sleeps", "scene.json"));
        foreach (Body body in new Simulation(file.Scene).Bodies.Where(body => body.Rule == Rules.UnityRigidbody && body.Plan.Asked.Unity.SleepThreshold > 0))
            Assert.That(new Explanation(body.Plan).ToString(), Does.Contain("sleep below 0.005 J/kg of the velocity summed over 0.2 s"));
    }

    [Test]
    public void Successive_orientations_are_on_one_sheet_and_those_between_two_steps_on_the_way()
    {
        SceneFile file = SceneReader.Read(TestData.Path("reports", "15-interpolation", "free.json"));
        FreeMotion motion = new(file.Scene.Bodies[0]);
        Simulation simulation = new(TimeSteps.Every(file.Scene.Steps.Length(0)), file.Scene.Bodies[0]);
        Body body = simulation.Bodies[0];
        Quaterniond last = body.State.Orientation;
        for (int step = 1; step <= 800; step++)
        {
            simulation.Step();
            Quaterniond now = body.State.Orientation, half = body.Between(0.5).Orientation;
            Assert.That(Dot(last, now), Is.GreaterThan(0.99), "step " + step);
            Assert.That(Dot(half, now), Is.GreaterThan(0.99), "step " + step);
            Assert.That(Conserved.AngleBetween(half, motion.At((step - 0.5) * 0.02).Orientation), Is.LessThan(1e-13)); // measured 1e-14
            last = now;
        }

        static double Dot(Quaterniond a, Quaterniond b) => a.W * b.W + a.X * b.X + a.Y * b.Y + a.Z * b.Z;
    }
}
