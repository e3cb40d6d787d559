using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>A simulation saved during its life continues to the same bits, whatever was done to the bodies since.</summary>
public sealed class SavedLifeTests
{
    private static readonly Vector3d J = new(1, -2, 3), P = new(0.5, 0.25, -1);

    /// <summary>The situations of a body or of the simulation when it is saved.</summary>
    private static IEnumerable<TestCaseData> Middles =>
        from rule in Scenery.Integrators
        from middle in new (string Name, Action<Simulation, Body> Do)[]
        {
            ("nothing", (_, _) => { }),
            ("after an impulse", (_, body) => body.ApplyImpulse(J, P)),
            ("with a force that waits", (_, body) => body.ApplyForce(J, P, inBody: true)),
            ("with a force that waits, after another", (simulation, body) =>
            {
                body.ApplyForce(J, P);
                simulation.Step();
                body.ApplyTorque(J);
            }),
            ("after a state was set", (_, body) => body.State = Pushes.State),
            ("after a change", (_, body) => body.Change(Scenery.Busy("Exact4", "other"), Keeping.Momentum)),
            ("after a step of its own length", (simulation, _) => simulation.StepBy(0.0123)),
            ("drawn", (simulation, body) =>
            {
                _ = body.Between(0.5);
                simulation.Step();
            }),
            ("with a rest", (simulation, _) => simulation.Advance(0.013)),
        }
        select new TestCaseData(rule, middle.Do).SetArgDisplayNames(rule, middle.Name);

    [TestCaseSource(nameof(Middles))]
    public void Goes_on_to_the_same_bits(string rule, Action<Simulation, Body> middle)
    {
        Simulation simulation = new(TimeSteps.Every(0.02));
        Body[] bodies =
        [
            simulation.Add(Scenery.Busy(rule, "busy")),
            simulation.Add(Scenery.Body(rule, "free")),
            simulation.Add(new BodyDescription("resting", Scenery.Body(rule).Mass) { Rule = Scenery.Body(rule).Rule }),
        ];
        // the last step is stored from the first time that it is interpolated
        Assert.That(bodies.Select(body => body.Between(0)), Is.EqualTo(bodies.Select(body => body.State)));
        simulation.Step(17);
        foreach (Body body in bodies)
            middle(simulation, body);

        SavedSimulation saved = simulation.Save();
        BodyPlan[] plans = [.. bodies.Select(body => body.Plan)];
        List<BodyState> first = GoOn(simulation, bodies);
        for (int i = 0; i < 3; i++)
        {
            Spoil(simulation, bodies, i);
            simulation.Restore(saved);
            Assert.That(bodies.Select(body => body.Plan), Is.EqualTo(plans));
            Assert.That(GoOn(simulation, bodies), Is.EqualTo(first));
        }
    }

    [Test]
    public void Saved_twice_in_a_row_each_goes_its_own_way()
    {
        Simulation simulation = new(TimeSteps.Every(0.02));
        Body body = simulation.Add(Scenery.Busy("Exact"));
        simulation.Step(10);
        body.ApplyForce(J);
        SavedSimulation pushed = simulation.Save();
        body.ApplyForce(-3 * J);
        SavedSimulation more = simulation.Save();
        BodyState[] ends = [.. new[] { pushed, more, pushed, more }.Select(saved =>
        {
            simulation.Restore(saved);
            simulation.Step();
            return body.State;
        })];
        Assert.That((ends[2], ends[3]), Is.EqualTo((ends[0], ends[1])));
        Assert.That(ends[0], Is.Not.EqualTo(ends[1]));
    }

    private static List<BodyState> GoOn(Simulation simulation, Body[] bodies)
    {
        List<BodyState> seen = [];
        void See() => seen.AddRange(bodies.SelectMany(body => new[] { body.State, body.Between(0.3), body.Between(simulation.Alpha) }));
        See();
        for (int n = 0; n < 30; n++)
        {
            simulation.Step();
            See();
        }

        simulation.StepBy(0.017);
        See();
        simulation.Advance(0.05);
        See();
        seen.Add(new BodyState(new Vector3d(simulation.Time, simulation.Alpha, simulation.StepsDone), Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero));
        return seen;
    }

    private static void Spoil(Simulation simulation, Body[] bodies, int how)
    {
        bodies[0].ApplyImpulse(J, P);
        bodies[1].ApplyForce(J, P);
        bodies[2].State = Pushes.State;
        simulation.Add(Scenery.Busy("Exact", "more"));
        simulation.StepBy(0.1);
        if (how > 0)
            simulation.Remove(bodies[1]);

        if (how > 1)
        {
            bodies[0].Change(Scenery.Busy("Exact6", "spoilt"));
            simulation.Advance(0.5);
        }
    }
}
