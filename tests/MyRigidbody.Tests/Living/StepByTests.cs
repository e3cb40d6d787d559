using NUnit.Framework;
using static RigidBodyDynamics.Tests.Samples;

namespace RigidBodyDynamics.Tests;

/// <summary>Steps that are each as long as the caller says.</summary>
public sealed class StepByTests
{
    private static readonly BodyState Tumbling =
        new(new Vector3d(1, -2, 0.5), new Quaterniond(0.8, 0.2, -0.4, 0.4).Normalized, new Vector3d(1, 2, 3), new Vector3d(3, 0.1, 9));

    [TestCaseSource(typeof(PointBody), nameof(PointBody.All))]
    public void Body_that_coasts_is_exact_in_frames_of_any_length(PointBody points)
    {
        BodyDescription description = new BodyDescription("coaster", points.Mass) { Start = Tumbling }.With(new LinearDamping(0.3));
        FreeMotion free = new(description);
        Simulation simulation = new(TimeSteps.Every(0.02));
        Body body = simulation.Add(description);
        Random random = new(3);
        double t = 0;
        for (int i = 0; i < 2000; i++)
        {
            double h = 0.005 + 0.02 * random.NextDouble();
            if (i % 7 == 0)
            {
                simulation.Step(3);
                t += 0.06;
            }

            simulation.StepBy(h);
            t += h;
        }

        Assert.That(simulation.Time, Is.EqualTo(t).Within(1e-11)); // measured 7.8e-14
        Assert.That(Conserved.AngleBetween(free.At(t).Orientation, body.State.Orientation), Is.LessThan(2e-11)); // measured 7.1e-13
        Assert.That(Apart(free.At(t).Position, body.State.Position), Is.LessThan(1e-12)); // measured 1.7e-13
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Steps_as_long_as_ever_are_Step_to_the_bit(string rule)
    {
        // of what nothing makes coast; a body that coasts is stepped, and so comes to other roundings
        Simulation by = new(TimeSteps.Every(1 / 64.0), Scenery.Busy(rule)), all = Scenery.Stepped(TimeSteps.Every(1 / 64.0), Scenery.Busy(rule));
        for (int n = 0; n < 90; n++)
        {
            by.StepBy(1 / 64.0);
            all.Step();
            Assert.That(by.Bodies[0].State, Is.EqualTo(all.Bodies[0].State), "step " + n);
        }
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Lengths_of_a_list_come_to_the_same_bits(string rule)
    {
        Random random = new(9);
        double[] lengths = [.. Enumerable.Range(0, 90).Select(_ => 0.005 + 0.02 * random.NextDouble())];
        Simulation by = new(TimeSteps.Every(0.02), Scenery.Busy(rule)), list = Scenery.Stepped(TimeSteps.Of(lengths), Scenery.Busy(rule));
        for (int n = 0; n < lengths.Length; n++)
        {
            by.StepBy(lengths[n]);
            list.Step();
            Assert.That(by.Time, Is.EqualTo(list.Time).Within(1e-15)); // measured 0
            Assert.That(by.Bodies[0].State, Is.EqualTo(list.Bodies[0].State), "step " + n);
        }
    }

    [Test]
    public void Windows_open_and_close_with_the_first_step_at_their_time_or_after_it()
    {
        Simulation simulation = new(TimeSteps.Every(0.02));
        Body body = simulation.Add(new BodyDescription("body", Solids.Sphere(1, 1)).With(new Force(new Vector3d(1, 0, 0)), 1, 2).With(new Force(new Vector3d(0, 1, 0)), 1.5));
        Random random = new(4);
        double t = 0, x = 0, y = 0;
        while (t < 3)
        {
            double h = random.Next(4) == 0 ? 0.02 : 0.001 + 0.3 * random.NextDouble();
            x += t >= 1 && t < 2 ? h : 0;
            y += t >= 1.5 ? h : 0;
            if (h == 0.02)
                simulation.Step();
            else
                simulation.StepBy(h);

            t += h;
            Assert.That(Apart(body.State.Velocity, new Vector3d(x, y, 0)), Is.LessThan(1e-14)); // measured 2.2e-16
        }

        Assert.That(new Explanation(body).ToString(), Does.Contain(": drift, force (0, 1, 0) N").And.Not.Contain("force (1, 0, 0) N"));
    }

    [Test]
    public void Unitys_body_falls_asleep_while_a_window_is_to_come()
    {
        Simulation simulation = new(TimeSteps.Every(0.02));
        BodyDescription slow = new("slow", Solids.Sphere(1, 1)) { Rule = Rules.UnityRigidbody };
        slow.Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(0.01, 0, 0), Vector3d.Zero);
        Body body = simulation.Add(slow.With(new Force(new Vector3d(1, 0, 0)), 5, 6));
        for (int n = 0; n < 40; n++)
            simulation.StepBy(0.025);

        Assert.That(body.IsAsleep, Is.True);
        for (int n = 0; n < 200; n++)
            simulation.StepBy(0.025);

        Assert.That(body.State.Velocity.X, Is.GreaterThan(0.5));
    }

    [Test]
    public void Failure_leaves_all_as_it_was()
    {
        BodyDescription[] all = [Scenery.Busy("Exact", "busy"), Scenery.Body("Exact", "free"), Scenery.Busy("LabEuler", "lab")];
        Simulation simulation = new(TimeSteps.Every(0.02), all);
        simulation.Step(3);
        simulation.StepBy(0.013);
        Body bad = simulation.Add(new BodyDescription("bad", Solids.Sphere(1, 1)).With(new Spring(Vector3d.Zero, new Vector3d(1e300, 0, 0), 1)));
        double time = simulation.Time;
        BodyState[] before = [.. simulation.Bodies.Select(body => body.State)];
        simulation.Bodies[0].ApplyForce(new Vector3d(1, 2, 3));
        SavedSimulation saved = simulation.Save();
        Assert.That(() => simulation.StepBy(0.1), Throws.TypeOf<StateOverflowException>().With.Message.Contains("\"bad\""));
        Assert.That((simulation.Time, simulation.StepsDone), Is.EqualTo((time, 4L)));
        Assert.That(simulation.Bodies.Select(body => body.State), Is.EqualTo(before));

        // and the force still waits
        simulation.Remove(bad);
        simulation.Step(30);
        BodyState[] after = [.. simulation.Bodies.Select(body => body.State)];
        simulation.Restore(saved);
        simulation.Remove(bad);
        simulation.Step(30);
        for (int i = 0; i < after.Length; i++)
            Assert.That(Distance(simulation.Bodies[i].State, after[i]), Is.LessThan(1e-13)); // measured 0
    }

    [Test]
    public void Same_calls_twice_come_to_the_same_bits()
    {
        Assert.That(Run(), Is.EqualTo(Run()));

        static IEnumerable<BodyState> Run()
        {
            Simulation simulation = new(TimeSteps.Every(0.02), [.. Scenery.Integrators.SelectMany(rule => new[] { Scenery.Busy(rule, rule + " busy"), Scenery.Body(rule, rule) })]);
            Random random = new(8);
            for (int i = 0; i < 100; i++)
            {
                simulation.StepBy(0.001 + 0.02 * random.NextDouble());
                simulation.Step(random.Next(3));
            }

            return [.. simulation.Bodies.Select(body => body.State)];
        }
    }

    [TestCase(0)]
    [TestCase(-1)]
    [TestCase(double.NaN)]
    [TestCase(double.PositiveInfinity)]
    [TestCase(1e10)]
    public void Length_that_is_none_is_refused(double length)
    {
        Simulation simulation = new(TimeSteps.Every(0.02), Scenery.Busy("Exact"));
        simulation.Step(10);
        BodyState before = simulation.Bodies[0].State;
        Assert.That(() => simulation.StepBy(length), Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.StartsWith("step: must be above zero and at most 1e9 s"));
        Assert.That((simulation.StepsDone, simulation.Bodies[0].State), Is.EqualTo((10L, before)));
    }

    [Test]
    public void Steps_from_a_list_and_time_that_is_over_have_none_of_their_own_length()
    {
        Assert.That(() => new Simulation(TimeSteps.Of([0.1, 0.2])).StepBy(0.1), Throws.InvalidOperationException.With.Message.Contains("list"));
        Simulation over = new(TimeSteps.Every(0.02, 1));
        over.StepBy(0.5);
        Assert.That(over.Time, Is.EqualTo(0.5));
        Assert.That(() => over.StepBy(0.5), Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains("0 steps left"));
    }

    private static double Distance(BodyState a, BodyState b) => Math.Max(
        Math.Max(Apart(a.Position, b.Position), Conserved.AngleBetween(a.Orientation, b.Orientation)),
        Math.Max(Apart(a.Velocity, b.Velocity), Apart(a.AngularVelocity, b.AngularVelocity)));
}
