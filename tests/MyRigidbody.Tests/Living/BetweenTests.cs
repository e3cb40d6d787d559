using NUnit.Framework;
using static RigidBodyDynamics.Tests.Samples;

namespace RigidBodyDynamics.Tests;

/// <summary>The interpolation between two steps: the motion itself where it has a closed form, a smooth path between the states elsewhere.</summary>
public sealed class BetweenTests
{
    private const double H = 0.125;
    private static readonly double[] Alphas = [0, 0.1, 0.5, 0.75, 0.999, 1];

    private static readonly BodyState Tumbling =
        new(new Vector3d(1, -2, 0.5), new Quaterniond(0.8, 0.2, -0.4, 0.4).Normalized, new Vector3d(1, 2, 3), new Vector3d(3, 0.1, 9));

    [TestCaseSource(typeof(PointBody), nameof(PointBody.All))]
    public void Body_that_coasts_is_on_its_exact_way(PointBody points)
    {
        BodyDescription description = Coaster(points.Mass);
        FreeMotion free = new(description);
        Simulation simulation = new(TimeSteps.Every(H));
        Body body = simulation.Add(description);
        // within the blocks in which it is caught up, at their edges, and after one leap
        foreach (int steps in new[] { 1, 126, 1, 1, 1, 300, 10_000 })
        {
            simulation.Step(steps);
            foreach (double alpha in Alphas)
                Assert.That(Distance(body.Between(alpha), free.At((simulation.StepsDone - 1 + alpha) * H)), Is.LessThan(2e-11)); // measured 7.3e-12, at 25 km
        }
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Ends_of_the_step_are_the_states_themselves(string rule)
    {
        Simulation simulation = new(TimeSteps.Every(1 / 64.0));
        Body[] bodies = [simulation.Add(Scenery.Busy(rule, "busy")), simulation.Add(Scenery.Body(rule, "free")), simulation.Add(Resting(rule))];
        for (int n = 0; n < 80; n++)
        {
            BodyState[] before = [.. bodies.Select(body => body.State)];
            simulation.Step();
            for (int i = 0; i < bodies.Length; i++)
            {
                Assert.That(bodies[i].Between(1), Is.EqualTo(bodies[i].State), bodies[i].Name);
                // a body that coasts goes back on its way
                double apart = Distance(bodies[i].Between(0), before[i]);
                Assert.That(apart, Is.LessThan(1e-14), bodies[i].Name + ", step " + n); // measured 4.4e-16
            }
        }
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Way_is_continuous_and_keeps_its_velocities_at_the_ends(string rule)
    {
        // the cubic's slope at an end is the velocity there
        const double h = 1 / 64.0, small = 1e-6;
        Simulation simulation = new(TimeSteps.Every(h));
        Body body = simulation.Add(Scenery.Busy(rule));
        BodyState last = body.Between(1);
        for (int n = 0; n < 60; n++)
        {
            simulation.Step();
            BodyState start = body.Between(0), end = body.Between(1);
            Assert.That(Distance(start, last), Is.LessThan(1e-14)); // measured 0
            Vector3d from = (Centre(body, small) - Centre(body, 0)) / (small * h), to = (Centre(body, 1) - Centre(body, 1 - small)) / (small * h);
            Assert.That(Apart(from, start.Velocity), Is.LessThan(1e-4)); // measured 3.1e-7
            Assert.That(Apart(to, end.Velocity), Is.LessThan(1e-4)); // measured 3.2e-7
            double turn = Conserved.AngleBetween(start.Orientation, end.Orientation);
            for (int i = 0; i < 8; i++)
            {
                Quaterniond a = body.Between(i / 8.0).Orientation, b = body.Between((i + 1) / 8.0).Orientation;
                Assert.That(Conserved.AngleBetween(a, b), Is.EqualTo(turn / 8).Within(rule == "UnityRigidbody" ? 1e-9 : 2e-15)); // at one rate; measured 3.8e-10 in float, 3.9e-16
                Assert.That(Quaterniond.Dot(a, b), Is.Positive);
            }

            last = end;
        }
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Many_steps_at_once_are_drawn_as_the_last_of_them(string rule)
    {
        Simulation one = new(TimeSteps.Every(1 / 64.0)), many = new(TimeSteps.Every(1 / 64.0));
        Body a = one.Add(Scenery.Busy(rule)), b = many.Add(Scenery.Busy(rule));
        foreach (int steps in new[] { 3, 29, 7, 41 })
        {
            for (int i = 0; i < steps; i++)
                one.Step();

            many.Step(steps);
            foreach (double alpha in Alphas)
                Assert.That(a.Between(alpha), Is.EqualTo(b.Between(alpha)));
        }
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void What_is_done_to_a_body_after_a_step_is_not_drawn_in_it(string rule)
    {
        foreach (Action<Body> change in new Action<Body>[]
        {
            body => body.ApplyImpulse(new Vector3d(5, 5, 5), Vector3d.Zero),
            body => body.ApplyForce(new Vector3d(50, 5, 5), Vector3d.Zero),
            body => body.Change(Scenery.Busy("Exact6", "other")),
        })
        {
            Simulation simulation = new(TimeSteps.Every(1 / 64.0));
            Body busy = simulation.Add(Scenery.Busy(rule)), free = simulation.Add(Scenery.Body(rule));
            simulation.Step(10);
            foreach (Body body in new[] { busy, free })
            {
                _ = body.Between(0.5);
                simulation.Step();
                BodyState[] drawn = [.. Alphas[..^1].Select(body.Between)];
                change(body);
                Assert.That(Alphas[..^1].Select(body.Between), Is.EqualTo(drawn), body.Name);

                // and is drawn from where it changed the body in the next
                BodyState from = body.State;
                simulation.Step();
                Assert.That(Distance(body.Between(0), from), Is.LessThan(1e-14)); // measured 0
                Assert.That(body.Between(1), Is.EqualTo(body.State));
            }
        }
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void There_is_no_way_to_a_state_that_was_set(string rule)
    {
        Simulation simulation = new(TimeSteps.Every(1 / 64.0));
        Body body = simulation.Add(Scenery.Busy(rule)), resting = simulation.Add(Resting(rule));
        simulation.Step(10);
        foreach (Body each in new[] { body, resting })
        {
            _ = each.Between(0.5);
            each.State = Tumbling;
            BodyState here = each.State;
            Assert.That(Alphas.Select(each.Between), Is.All.EqualTo(here));
            simulation.Step();
            Assert.That(Distance(each.Between(0), here), Is.LessThan(1e-14)); // measured 4.2e-17
        }
    }

    [Test]
    public void After_a_step_of_its_own_length_it_is_that_step()
    {
        BodyDescription description = Coaster(PointBody.All[4].Mass);
        FreeMotion free = new(description);
        Simulation simulation = new(TimeSteps.Every(H));
        Body body = simulation.Add(description), windowed = simulation.Add(Coaster(PointBody.All[4].Mass).With(new Force(new Vector3d(1, 0, 0)), 100));
        double t = 0;
        _ = (body.Between(0), windowed.Between(0));
        foreach (double length in new[] { 0.01, 0.3, 0.02, H, 0.07 })
        {
            if (length == H)
                simulation.Step();
            else
                simulation.StepBy(length);

            foreach (double alpha in Alphas)
            {
                Assert.That(Distance(body.Between(alpha), free.At(t + alpha * length)), Is.LessThan(1e-13)); // measured 7.5e-15
                double bound = alpha is 0 or 1 ? 1e-13 : 0.5;
                Assert.That(Distance(windowed.Between(alpha), free.At(t + alpha * length)), Is.LessThan(bound));
            }

            t += length;
        }
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Before_the_first_step_it_is_the_start(string rule)
    {
        Simulation simulation = new(TimeSteps.Every(1 / 64.0));
        Body body = simulation.Add(Scenery.Busy(rule));
        Assert.That(Alphas.Select(body.Between), Is.All.EqualTo(body.State));
        simulation.Step(7);
        Body late = simulation.Add(Scenery.Busy(rule));
        Assert.That(Alphas.Select(late.Between), Is.All.EqualTo(late.State));
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Who_draws_changes_no_bit(string rule)
    {
        Simulation drawn = new(TimeSteps.Every(1 / 64.0)), alone = new(TimeSteps.Every(1 / 64.0));
        Body[] seen = [drawn.Add(Scenery.Busy(rule)), drawn.Add(Scenery.Body(rule))], unseen = [alone.Add(Scenery.Busy(rule)), alone.Add(Scenery.Body(rule))];
        Random random = new(5);
        for (int n = 0; n < 200; n++)
        {
            drawn.Step();
            alone.Step();
            if (random.Next(3) == 0)
                _ = (seen[0].Between(random.NextDouble()), seen[1].Between(random.NextDouble()));

            if (n % 50 == 20)
            {
                seen[1].ApplyImpulse(new Vector3d(1, 0, 0), Vector3d.Zero);
                unseen[1].ApplyImpulse(new Vector3d(1, 0, 0), Vector3d.Zero);
            }
        }

        Assert.That(seen.Select(body => body.State), Is.EqualTo(unseen.Select(body => body.State)));
    }

    private static BodyDescription Coaster(MassProperties mass) =>
        new BodyDescription("coaster", mass) { Start = Tumbling }.With(new Gravity(new Vector3d(0, -9.81, 0))).With(new LinearDamping(0.5));

    private static BodyDescription Resting(string rule)
    {
        BodyDescription resting = Scenery.Body(rule, "resting");
        resting.Start = BodyState.AtRest;
        return resting;
    }

    private static Vector3d Centre(Body body, double alpha)
    {
        BodyState state = body.Between(alpha);
        return state.Position + state.Orientation.Rotate(body.Mass.CenterOfMass);
    }

    private static double Distance(BodyState a, BodyState b) => Math.Max(
        Math.Max(Apart(a.Position, b.Position), Conserved.AngleBetween(a.Orientation, b.Orientation)),
        Math.Max(Apart(a.Velocity, b.Velocity), Apart(a.AngularVelocity, b.AngularVelocity)));
}
