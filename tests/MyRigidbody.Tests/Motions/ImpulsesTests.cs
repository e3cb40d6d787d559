using NUnit.Framework;
using RigidBodyDynamics.Tests.SceneFiles;
using static RigidBodyDynamics.Tests.Samples;

namespace RigidBodyDynamics.Tests;

/// <summary>Impulses of a description: given at the beginning of a step, as a program gives them by <see cref="Body.ApplyImpulse(Vector3d, bool)"/>.</summary>
public sealed class ImpulsesTests
{
    private const double H = 1.0 / 64;
    private static readonly Vector3d P = new(0.3, -1, 0.5), Turn = new(-0.2, 0.4, 0.1), Point = new(0.4, 0.2, -0.3);

    private static IEnumerable<string> Rule => Scenery.Integrators;

    [TestCaseSource(nameof(Rule))]
    public void Impulse_does_what_a_program_does_that_pushes_before_that_step(string rule)
    {
        // the program gives it in two, at a point of the world; single precision rounds that more than half an ulp of ours
        double rounding = rule == "UnityRigidbody" ? 2e-5 : 1e-12;
        foreach (bool inBody in new[] { false, true })
        {
            Body given = Started(Scenery.Busy(rule).With(new Impulse(P, Turn, Point, inBody), 20 * H));
            Body pushed = Started(Scenery.Busy(rule));
            for (int step = 0; step < 50; step++)
            {
                if (step == 20)
                    Push(pushed, inBody);

                given.Simulation.Step();
                pushed.Simulation.Step();
                Assert.That(Far(given.State, pushed.State), Is.LessThanOrEqualTo(step < 20 ? 0 : rounding), "step " + step);
            }
        }
    }

    [TestCaseSource(nameof(Rule))]
    public void State_before_the_step_has_not_got_it_and_reading_it_changes_nothing(string rule)
    {
        BodyDescription body = Scenery.Body(rule).With(new Impulse(P, Turn, Point), 20 * H);
        Body seen = Started(body), unseen = Started(body), free = Started(Scenery.Body(rule));
        for (int step = 0; step < 20; step++)
        {
            seen.Simulation.Step();
            free.Simulation.Step();
            Assert.That(seen.State, Is.EqualTo(free.State));
        }

        seen.Simulation.Step(180);
        unseen.Simulation.Step(200);
        Assert.That(unseen.State, Is.EqualTo(seen.State));
    }

    [TestCase("Exact")]
    [TestCase("Exact4")]
    [TestCase("Exact6")]
    public void Ball_that_is_hit_flies_and_turns_as_the_closed_form_says(string rule)
    {
        // a ball's ω is constant without a torque; the hit changes it by r × P / I and v by P / m
        const double mass = 0.5, radius = 0.1;
        Vector3d gravity = new(0, -9.81, 0), hit = new(2, 0, 0), point = new(0, radius, 0);
        MassProperties ball = Solids.Sphere(mass, radius);
        BodyDescription body = new BodyDescription("ball", ball) { Rule = Rules.Named(rule) }.With(new Gravity(gravity)).With(new Impulse(hit, at: point), 0.5);
        Body moving = new Simulation(TimeSteps.Every(H), body).Bodies[0];
        moving.Simulation.Step(128);
        Vector3d spin = Vector3d.Cross(point, hit) / ball.PrincipalMoments.X;
        BodyState end = moving.State;
        Assert.That(Apart(end.Velocity, 2 * gravity + hit / mass), Is.LessThan(1e-14)); // measured 0
        Assert.That(Apart(end.Position, 2 * gravity + 1.5 * hit / mass), Is.LessThan(1e-14)); // measured 3.6e-15
        Assert.That(Apart(end.AngularVelocity, spin), Is.LessThan(1e-13)); // measured 0
        Assert.That(Conserved.AngleBetween(end.Orientation, Quaterniond.FromAxisAngle(spin, 1.5 * spin.Length)), Is.LessThan(1e-13)); // measured 3.4e-14
    }

    [TestCaseSource(nameof(Rule))]
    public void Many_bodies_get_it_to_the_bits_of_one(string rule)
    {
        BodyDescription body = Scenery.Body(rule).With(new Impulse(P, Turn, Point, inBody: true), 20 * H).With(new Impulse(-P), 0).With(new Force(P), 0.6, 0.8);
        Simulation together = new(TimeSteps.Every(H));
        Body[] many = [.. Enumerable.Range(0, 7).Select(i => together.Add(body, Start(i)))];
        Body late = null!;
        for (int step = 0; step < 200; step++)
        {
            if (step == 20)
            {
                late = together.Add(body, Start(9));
                many[3].ApplyForce(P, Point);
            }

            together.Step();
        }

        for (int i = 0; i < many.Length; i++)
        {
            Simulation alone = new(TimeSteps.Every(H));
            Body one = alone.Add(body, Start(i));
            alone.Step(20);
            if (i == 3)
                one.ApplyForce(P, Point);

            alone.Step(180);
            Assert.That(many[i].State, Is.EqualTo(one.State), "body " + i);
        }

        Simulation after = new(TimeSteps.Every(H));
        after.Step(20);
        Body came = after.Add(body, Start(9));
        after.Step(180);
        Assert.That(late.State, Is.EqualTo(came.State));
        Assert.That(came.State.Velocity, Is.Not.EqualTo(many[0].State.Velocity));

        static BodyState Start(int i) => Pushes.State with { Velocity = new Vector3d(i, 1, -i) };
    }

    [Test]
    public void Body_at_rest_is_planned_with_the_rotation_that_an_impulse_beside_its_centre_gives()
    {
        Assert.That(LeftOut(new Impulse(P)), Is.EqualTo(Omissions.Rotation));
        Assert.That(LeftOut(new Impulse(P, at: Point)), Is.EqualTo(Omissions.None));
        Assert.That(LeftOut(new Impulse(Vector3d.Zero, Turn)), Is.EqualTo(Omissions.Translation));

        static Omissions LeftOut(Impulse impulse) =>
            new Simulation(TimeSteps.Every(H), new BodyDescription("b", Pushes.Mass).With(impulse, 1)).Bodies[0].Plan.LeftOut;
    }

    [Test]
    public void Body_coasts_before_and_after()
    {
        Body body = new Simulation(TimeSteps.Every(H), Scenery.Body("Exact").With(new Impulse(P, Turn), 1)).Bodies[0];
        Assert.That(body.IsDormant, Is.True);
        body.Simulation.Step(64);
        body.Simulation.Step(1);
        Assert.That(body.IsDormant, Is.True);
        body.Simulation.Step(1_000_000);
        Assert.That(Apart(body.State.Velocity, Pushes.State.Velocity + 0.5 * P), Is.LessThan(1e-15)); // measured 0
        Assert.That(new Explanation(body.Plan).ToString(), Does.Contain("from 1 s: drift").And.Contain("impulse (0.3, -1, 0.5) N s and (-0.2, 0.4, 0.1) N m s, at once"));
    }

    [Test]
    public void Impulse_is_given_once_however_long_the_steps_are_and_however_the_body_is_planned_anew()
    {
        BodyDescription description = new BodyDescription("b", Pushes.Mass).With(new Impulse(P), 0.1);
        Simulation simulation = new(TimeSteps.Every(0.02));
        Body alone = simulation.Add(description), one = simulation.Add(description), two = simulation.Add(description);
        foreach (double length in new[] { 0.03, 0.03, 0.03 })
            simulation.StepBy(length);

        Moves(0);
        // the next starts at 0.09 s, that after it at 0.11 s
        simulation.StepBy(0.02);
        Moves(0);
        simulation.StepBy(0.004);
        Moves(1);
        simulation.StepBy(0.004);
        alone.ApplyTorque(Turn);
        one.ApplyAngularImpulse(Turn);
        two.Change(description);
        simulation.Step(10);
        Moves(1);

        void Moves(double times) =>
            Assert.That(new[] { alone, one, two }.Select(body => body.State.Velocity), Is.All.EqualTo(times / Pushes.Mass.Mass * P));
    }

    [Test]
    public void What_was_to_begin_with_the_next_step_waits_where_that_starts_too_early()
    {
        // at 0.01 s: step 1 of 0.02 s; after one of 0.005 s that is step 2
        Simulation simulation = new(TimeSteps.Every(0.02));
        Body hit = simulation.Add(new BodyDescription("b", Pushes.Mass).With(new Impulse(P), 0.01));
        Body pushed = simulation.Add(new BodyDescription("c", Pushes.Mass).With(new Force(P), 0.01));
        simulation.StepBy(0.005);
        simulation.Step();
        Assert.That(new[] { hit.State.Velocity, pushed.State.Velocity }, Is.All.EqualTo(Vector3d.Zero));
        simulation.Step();
        Assert.That(Apart(hit.State.Velocity, P / Pushes.Mass.Mass), Is.LessThan(1e-15)); // measured 0
        Assert.That(Apart(pushed.State.Velocity, 0.02 * P / Pushes.Mass.Mass), Is.LessThan(1e-15)); // measured 0
    }

    [Test]
    public void Saved_before_it_a_body_gets_it_again()
    {
        Body body = Started(Scenery.Body("Exact").With(new Impulse(P, Turn, Point), 20 * H));
        body.Simulation.Step(20);
        SavedSimulation before = body.Simulation.Save();
        body.Simulation.Step(30);
        BodyState end = body.State;
        body.Simulation.Restore(before);
        body.Simulation.Step(30);
        Assert.That(body.State, Is.EqualTo(end));
    }

    [Test]
    public void Impulse_that_takes_the_velocity_out_of_the_numbers_is_named_with_body_and_step()
    {
        Body body = Started(Scenery.Body("Exact").With(new Impulse(new Vector3d(1e300, 0, 0)), 20 * H));
        BrokenEffectException broken = Assert.Throws<BrokenEffectException>(() => body.Simulation.Step(100))!;
        Assert.That(broken.Message, Does.Contain("body \"body\": effects[0]").And.Contain("in step 20"));
        Assert.That(body.Simulation.StepsDone, Is.EqualTo(20));
    }

    [Test]
    public void Scene_says_when_and_where()
    {
        BodyDescription body = SceneText.Read("""
            { "schema": "rigid-body-scene/1", "name": "n", "step": 0.1, "steps": 30, "bodies": [ { "name": "b", "effects": [
              { "impulse": { "time": 1, "frame": "body", "linear": [1, 0, 0], "angular": [0, 0, 2], "at": [0, 0.5, 0] } } ] } ] }
            """).Scene.Bodies[0];
        Assert.That(body.Effects[0].Motion, Is.EqualTo(new Impulse(new Vector3d(1, 0, 0), new Vector3d(0, 0, 2), new Vector3d(0, 0.5, 0), inBody: true)));
        Assert.That(body.Effects[0].From, Is.EqualTo(1));
        Assert.That(SceneText.Error(Impulses("\"time\": -1")), Is.EqualTo("scene.json: bodies[0].effects[0].impulse.time: must be finite and not below zero, found -1"));
        Assert.That(SceneText.Error(Impulses("\"time\": 1").Replace("} }", "}, \"to\": 3 }")), Is.EqualTo("scene.json: bodies[0].effects[0].to: must not stand beside impulse, which says itself when it acts"));

        static string Impulses(string what) =>
            "{ \"schema\": \"rigid-body-scene/1\", \"name\": \"n\", \"step\": 0.1, \"steps\": 30, \"bodies\": [ { \"name\": \"b\", \"effects\": [ { \"impulse\": { " + what + " } } ] } ] }";
    }

    private static Body Started(BodyDescription body) => new Simulation(TimeSteps.Every(H), body).Bodies[0];

    private static double Far(in BodyState a, in BodyState b) => new[]
    {
        Apart(a.Position, b.Position), Apart(a.Velocity, b.Velocity), Apart(a.AngularVelocity, b.AngularVelocity), Conserved.AngleBetween(a.Orientation, b.Orientation),
    }.Max();

    private static void Push(Body body, bool inBody)
    {
        Vector3d point = inBody ? Point : body.State.Position + body.State.Orientation.Rotate(Point);
        body.ApplyImpulse(P, point, inBody);
        body.ApplyAngularImpulse(Turn, inBody);
    }
}
