using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>q and −q are the same rotation; a motion shows the one that q has reached without a jump.</summary>
public sealed class OneSheetTests
{
    private static readonly Dictionary<string, (Vector3d Moments, Vector3d Spin)> Bodies = new()
    {
        ["three equal moments"] = (new(2, 2, 2), new(3, 1, 2)),
        ["a wheel"] = (new(1, 1, 1.9), new(3, 1, 20)),
        ["a needle"] = (new(0.01, 1, 1), new(30, 1, 2)),
        ["three moments"] = (new(1, 2, 2.9), new(1, 1.1, 0.9)),
        ["three moments, fast"] = (new(1, 2, 2.9), new(30, 101, 90)),
        ["near the least moment"] = (new(1, 2, 2.9), new(8, 0.1, 0.02)),
        ["near the largest moment"] = (new(1, 2, 2.9), new(0.02, 0.1, -8)),
        ["turning over"] = (new(1, 2, 2.9), new(1e-3, 5, 1e-3)),
        ["turning over rarely"] = (new(1, 2, 2.9), new(1e-6, 5, -2e-6)),
    };

    private static IEnumerable<string> Names => Bodies.Keys;

    [TestCaseSource(nameof(Names))]
    public void Free_motion_is_continuous_forwards_and_backwards(string name)
    {
        FreeMotion motion = new(Body(name, damping: 0)), damped = new(Body(name, damping: 0.001 * Bodies[name].Spin.Length));
        double step = 0.3 / Bodies[name].Spin.Length;
        foreach ((FreeMotion free, double dt) in new[] { (motion, step), (motion, -step), (damped, step), (damped, -step) })
        {
            double worst = 1;
            Quaterniond last = free.At(0).Orientation;
            for (int n = 1; n <= 2000; n++)
            {
                Quaterniond next = free.At(n * dt).Orientation;
                worst = Math.Min(worst, Dot(last, next));
                last = next;
            }

            TestContext.Out.WriteLine(FormattableString.Invariant($"{worst:g4}"));
            Assert.That(worst, Is.GreaterThan(0.9)); // measured 0.952
        }
    }

    // through 15 closed forms of 128 steps each
    [TestCaseSource(nameof(Names))]
    public void Body_that_is_read_in_every_step_does_not_jump(string name)
    {
        Simulation simulation = new(TimeSteps.Every(0.3 / Bodies[name].Spin.Length), Body(name, damping: 0));
        double worst = 1;
        Quaterniond last = simulation.Bodies[0].State.Orientation;
        for (int n = 1; n <= 2000; n++)
        {
            simulation.Step();
            Quaterniond next = simulation.Bodies[0].State.Orientation;
            worst = Math.Min(worst, Dot(last, next));
            last = next;
        }

        TestContext.Out.WriteLine(FormattableString.Invariant($"{worst:g4}"));
        Assert.That(worst, Is.GreaterThan(0.9)); // measured 0.985
    }

    // short steps and long ones with many revolutions; in lanes and one by one
    [TestCaseSource(nameof(Names))]
    public void Steps_of_any_length_come_to_the_sheet_of_the_closed_form(string name)
    {
        foreach (double angle in new[] { 0.3, 2.5, 4, 7.5, 40, 199 })
        {
            double dt = angle / Bodies[name].Spin.Length;
            BodyDescription body = Body(name, damping: 0);
            Simulation stepped = Scenery.Stepped(TimeSteps.Every(dt), body), coasting = new(TimeSteps.Every(dt), body);
            Together batch = new(body, TimeSteps.Every(dt), Omissions.None);
            int id = batch.Add(body.Start);
            FreeMotion free = new(body);
            for (int n = 1; n <= 200; n++)
            {
                stepped.Step();
                coasting.Step();
                batch.Step();
                Quaterniond expected = free.At(n * dt).Orientation;
                foreach (Quaterniond found in new[] { stepped.Bodies[0].State.Orientation, coasting.Bodies[0].State.Orientation, batch[id].Orientation })
                    Assert.That(Dot(found, expected), Is.GreaterThan(0.999), $"step {n} of {angle} rad");
            }
        }
    }

    private static BodyDescription Body(string name, double damping)
    {
        BodyDescription body = new BodyDescription(name, MassProperties.FromPrincipal(1, Bodies[name].Moments, new Quaterniond(0.9, 0.1, -0.3, 0.2), Vector3d.Zero))
        {
            Rule = Rules.Exact,
            Start = new BodyState(Vector3d.Zero, new Quaterniond(-0.5, 0.5, 0.5, 0.5), Vector3d.Zero, Vector3d.Zero),
            AngularVelocityInBody = new Quaterniond(0.9, 0.1, -0.3, 0.2).Normalized.Rotate(Bodies[name].Spin),
        };
        return damping > 0 ? body.With(new AngularDamping(damping)) : body;
    }

    private static double Dot(Quaterniond a, Quaterniond b) => a.W * b.W + Vector3d.Dot(a.Vector, b.Vector);
}
