using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

public sealed class BodyDescriptionTests
{
    private static readonly MassProperties Mass = Solids.Sphere(1, 1);

    [Test]
    public void New_body_rests_at_the_origin_and_nothing_acts_on_it()
    {
        BodyDescription body = new("b", Mass);
        Assert.That(body.Start, Is.EqualTo(new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero)));
        Assert.That((body.Name, body.Mass, body.CanMove, body.CanTurn, body.Effects.Count), Is.EqualTo(("b", Mass, true, true, 0)));
        Assert.That(body.Rule.Name, Is.EqualTo(Rules.Default.Name));
        Assert.That((body.Lab.Normalise, body.Lab.UnitRotation), Is.EqualTo((true, false)));
    }

    [Test]
    public void Unity_settings_start_with_the_defaults_of_Unity()
    {
        UnitySettings unity = new();
        Assert.That(
            (unity.Drag, unity.AngularDrag, unity.MaxAngularVelocity, unity.SleepThreshold, unity.WakeCounter),
            Is.EqualTo((0.0, 0.05, 7.0, 0.005, 0.4)));
        Assert.That((unity.GyroscopicForces, unity.InDouble, unity.FirstOrderOrientation), Is.EqualTo((false, false, false)));
    }

    [Test]
    public void Effects_are_listed_with_their_windows_in_the_order_they_were_given()
    {
        Force force = new(new Vector3d(1, 2, 3));
        Gravity gravity = new(new Vector3d(0, -1, 0));
        BodyDescription body = new BodyDescription("b", Mass).With(force, 1, 2).With(gravity).With(force, -1);
        Assert.That(body.Effects.Select(e => (e.Motion, e.From, e.To)), Is.EqualTo(new (IEffect, double, double)[]
        {
            (force, 1, 2), (gravity, 0, double.PositiveInfinity), (force, -1, double.PositiveInfinity),
        }));
    }

    [Test]
    public void Effects_can_be_taken_away_and_given_to_another_body()
    {
        BodyDescription body = new BodyDescription("b", Mass)
            .With(new KeyPush(LabKey.R)).With(new QuadraticDrag(1)).With(new Gravity(new Vector3d(0, -1, 0)));
        BodyDescription other = new("other", Mass);
        foreach (Effect effect in body.Effects)
            other.With(effect);
        other.Without(effect => effect.Motion is QuadraticDrag);
        Assert.That(other.Effects, Is.EqualTo(new[] { body.Effects[0], body.Effects[2] }));
        Assert.That(body.Effects.Count, Is.EqualTo(3));
    }

    [Test]
    public void Copy_is_the_same_body_and_can_be_changed_alone()
    {
        BodyDescription body = new BodyDescription("b", Mass)
        {
            Rule = Rules.UnityRigidbody,
            Start = Pushes.State,
            CanMove = false,
            CanTurn = false,
            Lab = new LabSettings { Normalise = false, UnitRotation = true },
            Unity = new UnitySettings { Drag = 3, GyroscopicForces = true },
        }.With(new KeyPush(LabKey.R));
        MassProperties other = Solids.Sphere(2, 2);
        BodyDescription copy = body.Copy("copy", other);
        Assert.That((copy.Name, copy.Mass, copy.Rule.Name, copy.Start), Is.EqualTo(("copy", other, "UnityRigidbody", Pushes.State)));
        Assert.That((copy.CanMove, copy.CanTurn, copy.Lab.Normalise, copy.Lab.UnitRotation), Is.EqualTo((false, false, false, true)));
        Assert.That((copy.Unity.Drag, copy.Unity.GyroscopicForces), Is.EqualTo((3.0, true)));
        Assert.That(copy.Effects, Is.EqualTo(body.Effects));

        copy.With(new Force(Vector3d.Zero));
        copy.Unity.Drag = 4;
        Assert.That((body.Effects.Count, body.Unity.Drag), Is.EqualTo((1, 3.0)));
    }

    [Test]
    public void Settings_of_a_running_body_are_those_of_its_start()
    {
        BodyDescription body = new("b", Mass) { Rule = Rules.UnityRigidbody, Start = Pushes.State };
        Simulation running = new(TimeSteps.Every(0.1), body), unchanged = new(TimeSteps.Every(0.1), body.Copy("b", Mass));
        body.Unity.Drag = 9;
        body.Start = BodyState.AtRest;
        body.With(new Gravity(new Vector3d(0, -10, 0)));
        running.Step(5);
        unchanged.Step(5);
        Assert.That(running.Bodies[0].State, Is.EqualTo(unchanged.Bodies[0].State));
    }
}
