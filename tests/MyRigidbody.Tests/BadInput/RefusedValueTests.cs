using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

public sealed class RefusedValueTests
{
    private static readonly Vector3d Bad = new(0, double.NaN, 0);

    [TestCaseSource(typeof(Refusals), nameof(Refusals.All))]
    public void Impossible_value_is_refused_in_one_line_with_its_name_and_itself(string name, string value, TestDelegate use) =>
        Assert.That(
            use,
            Throws.InstanceOf<ArgumentOutOfRangeException>()
                .With.Message.StartsWith(name + ": ")
                .And.Message.EndsWith(", found " + value)
                .And.Message.Not.Contains("\n")
                .And.Property(nameof(ArgumentException.ParamName)).EqualTo(name));

    [Test]
    public void What_is_missing_is_refused_by_name()
    {
        MassProperties ball = Solids.Sphere(1, 1);
        (string Name, TestDelegate Use)[] cases =
        [
            ("mass", () => _ = new BodyDescription("b", null!)),
            ("effect", () => new BodyDescription("b", ball).With((Effect)null!)),
            ("coast", () => new BodyDescription("b", ball).With((ICoast)null!)),
            ("keyboard", () => _ = new HeldKeys(null!)),
            ("pushes", () => _ = new Many(null!)),
            ("force", () => _ = new PerStep(null!, [])),
            ("torque", () => _ = new PerStep([], null!)),
            ("points", () => PointMasses.Equal(1, null!)),
            ("points", () => PointMasses.Of(null!, [1])),
            ("masses", () => PointMasses.Of([Vector3d.Zero], null!)),
            ("part", () => new Compound().With(null!, Vector3d.Zero)),
            ("lengths", () => TimeSteps.Of(null!)),
            ("scene", () => _ = new Simulation((SceneDescription)null!)),
            ("steps", () => _ = new SceneDescription("s", "", null!, [new BodyDescription("b", ball)])),
            ("name", () => _ = new SceneDescription(null!, "", TimeSteps.Every(1), [new BodyDescription("b", ball)])),
            ("about", () => _ = new SceneDescription("s", null!, TimeSteps.Every(1), [new BodyDescription("b", ball)])),
            ("bodies", () => _ = new SceneDescription("s", "", TimeSteps.Every(1), null!)),
            ("bodies[0]", () => _ = new SceneDescription("s", "", TimeSteps.Every(1), [null!])),
            ("Lab", () => _ = new Simulation(TimeSteps.Every(1), new BodyDescription("b", ball) { Lab = null! })),
            ("Unity", () => _ = new Simulation(TimeSteps.Every(1), new BodyDescription("b", ball) { Unity = null! })),
        ];
        foreach ((string name, TestDelegate use) in cases)
        {
            Assert.That(
                use,
                Throws.ArgumentNullException.With.Property(nameof(ArgumentException.ParamName)).EqualTo(name).And.Message.Contains(name),
                name);
        }
    }

    [Test]
    public void Unity_settings_keep_their_values()
    {
        UnitySettings unity = new() { Drag = 1, AngularDrag = 2, MaxAngularVelocity = 3, SleepThreshold = 4, WakeCounter = 5 };
        TestDelegate[] setters =
        [
            () => unity.Drag = -1, () => unity.AngularDrag = double.NaN, () => unity.MaxAngularVelocity = -1,
            () => unity.SleepThreshold = double.PositiveInfinity, () => unity.WakeCounter = -1,
        ];
        foreach (TestDelegate set in setters)
            Assert.That(set, Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(
            (unity.Drag, unity.AngularDrag, unity.MaxAngularVelocity, unity.SleepThreshold, unity.WakeCounter),
            Is.EqualTo((1.0, 2.0, 3.0, 4.0, 5.0)));
    }

    [Test]
    public void Body_keeps_its_effects_and_a_compound_its_parts()
    {
        BodyDescription body = new BodyDescription("b", Solids.Sphere(1, 1)).With(new KeyPush(LabKey.R));
        Assert.That(() => body.With(new Force(Vector3d.Zero), 2, 1), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => body.With(new Gravity(Vector3d.Zero), double.NaN), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(body.Effects.Count, Is.EqualTo(1));

        Compound compound = new Compound().With(Solids.Sphere(1, 1), Vector3d.Zero);
        Assert.That(() => compound.With(Solids.Sphere(5, 1), Bad), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => compound.With(Solids.Sphere(5, 1), Vector3d.Zero, default), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(compound.ToMassProperties().Mass, Is.EqualTo(1));
    }

    [Test]
    public void Refused_force_leaves_a_running_simulation_as_it_was()
    {
        Simulation simulation = new(TimeSteps.Every(0.1), Scenery.Body("LabEuler").With(new Force(new Vector3d(1, 0, 0))));
        Simulation untroubled = new(TimeSteps.Every(0.1), Scenery.Body("LabEuler").With(new Force(new Vector3d(1, 0, 0))));
        simulation.Step(3);
        Assert.That(() => simulation.Bodies[0].ApplyForce(Bad), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => simulation.Step(-2), Throws.InstanceOf<ArgumentOutOfRangeException>());
        simulation.Step(3);
        untroubled.Step(6);
        Assert.That((simulation.Bodies[0].State, simulation.StepsDone), Is.EqualTo((untroubled.Bodies[0].State, 6L)));
    }

    [Test]
    public void Message_comes_out_alike_whatever_the_language_of_the_machine()
    {
        Assert.That(() => Solids.Sphere(-1.5, 1), Throws.Exception.With.Message.EndsWith("found -1.5"));
        Assert.That(() => new Force(new Vector3d(double.NaN, -1.5, 0)), Throws.Exception.With.Message.EndsWith("found (NaN, -1.5, 0)"));
    }
}
