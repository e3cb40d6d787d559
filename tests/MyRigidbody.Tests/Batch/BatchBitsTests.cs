using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>A body gets the same bits among many as alone.</summary>
public sealed class BatchBitsTests
{
    private static readonly Dictionary<string, Func<BodyDescription, BodyDescription>> Acting = new()
    {
        ["nothing"] = body => body,
        ["gravity"] = body => body.With(new Gravity(new Vector3d(0.1, -9.81, 0))),
        ["gravity and damping"] = body => body.With(new Gravity(new Vector3d(0.1, -9.81, 0))).With(new LinearDamping(0.3)).With(new AngularDamping(0.2)),
        ["damping that leaves nothing"] = body => body.With(new LinearDamping(300)).With(new AngularDamping(400)),
        ["factors per step"] = body => body.With(new DecayPerStep(0.5, 0.4)).With(new Gravity(new Vector3d(0, 0, -1)), 0.3, 0.5),
        ["force"] = body => body.With(new Force(new Vector3d(5, 0, -1))).With(new AngularDamping(0.2)),
        ["torque in world axes"] = body => body.With(new Torque(new Vector3d(1, 0, 0), new Vector3d(0, 2, 0), new Vector3d(0, 0, 1), 3, inBody: false)),
        ["torque in body axes"] = body => body.With(new Torque(new Vector3d(1e-3, 0, 0), new Vector3d(0, 2e-3, 0), Vector3d.Zero, 3, inBody: true)).With(new LinearDamping(0.3)),
        ["keys in windows"] = body => body.With(new KeyPush(LabKey.R), 0.1, 0.7).With(new KeyPush(LabKey.UpArrow), 0.1, 0.3).With(new Gravity(new Vector3d(0, -1, 0)), 0.5),
        ["what reads the state"] = body => body.With(new Spring(new Vector3d(0, 0.5, 0), new Vector3d(0, 3, 0), 4), 0.2, 0.8).With(new QuadraticDrag(1e-4), 0.4),
        ["all there is"] = body => body.With(new KeyPush(LabKey.R)).With(new PerStep([new Vector3d(1, 2, 3)], [new Vector3d(3, 2, 1)])).With(new DecayPerStep(0.98, 0.97), 0.4, 0.7)
            .With(new AngularDamping(0.2), 0.2).With(new Torque(new Vector3d(0.1, 0, 0), new Vector3d(0, 0.2, 0), Vector3d.Zero, 1.5, inBody: true), 0.3, 0.9),
    };

    private static readonly string[] InLanes = ["Exact", "Exact4", "LabEuler"];

    private static readonly long[] Looks = [1, 2, 5, 30, 31, 49];

    private static IEnumerable<TestCaseData> Cases() =>
        from rule in Rules.All from act in Acting.Keys where InLanes.Contains(rule.Name) || act == "all there is" select new TestCaseData(rule.Name, act);

    [TestCaseSource(nameof(Cases))]
    public void Body_among_many_moves_as_it_does_alone(string rule, string act)
    {
        foreach (MassProperties mass in Crowding.Masses)
        {
            BodyDescription body = Acting[act](new BodyDescription("body", mass) { Rule = Rules.Named(rule) });
            Crowding.Same(body, TimeSteps.Every(0.02, 49), Crowding.Starts(13, 1, body), Looks);
        }
    }

    [TestCase(0)]
    [TestCase(1)]
    [TestCase(3)]
    [TestCase(7)]
    [TestCase(8)]
    [TestCase(9)]
    [TestCase(1000)]
    public void Any_number_of_them_does(int count)
    {
        foreach (string act in count == 1000 ? ["nothing"] : new[] { "nothing", "torque in world axes", "what reads the state" })
        {
            BodyDescription body = Acting[act](new BodyDescription("body", Crowding.Masses.ElementAt(1)));
            Crowding.Same(body, TimeSteps.Every(0.02), Crowding.Starts(count, count, body), [1, 7, 20]);
        }
    }

    [TestCase(2)]
    [TestCase(5)]
    public void Any_number_of_threads_steps_them_alike(int threads)
    {
        foreach (string act in new[] { "nothing", "keys in windows", "what reads the state" })
        {
            BodyDescription body = Acting[act](new BodyDescription("body", Crowding.Masses.First()));
            Together one = new(body, TimeSteps.Every(0.02)) { Threads = 1 }, many = new(body, TimeSteps.Every(0.02)) { Threads = threads };
            BodyState[] starts = Crowding.Starts(2100, 3, body), expected = new BodyState[2100], found = new BodyState[2100];
            foreach (BodyState start in starts)
            {
                one.Add(start);
                many.Add(start);
            }

            for (int look = 0; look < 3; look++)
            {
                one.Step(3);
                many.Step(3);
                one.Read(expected);
                many.Read(found);
                for (int i = 0; i < found.Length; i++)
                    Crowding.Same(found[i], expected[i], $"body {i}, {act}");
            }
        }
    }

    [TestCase("Exact")]
    [TestCase("LabEuler")]
    public void Body_that_is_held_does(string rule)
    {
        foreach (MassProperties mass in Crowding.Masses)
        {
            foreach ((bool moves, bool turns) in new[] { (true, false), (false, true), (false, false) })
            {
                foreach (string act in new[] { "nothing", "factors per step", "all there is" })
                {
                    BodyDescription body = Acting[act](new BodyDescription("body", mass) { Rule = Rules.Named(rule), CanMove = moves, CanTurn = turns });
                    Crowding.Same(body, TimeSteps.Every(0.02), Crowding.Starts(9, 5, body), [1, 20, 150]);
                }
            }
        }
    }

    [TestCase(Locks.MoveY)]
    [TestCase(Locks.TurnX | Locks.TurnZ)]
    [TestCase(Locks.MoveX | Locks.TurnY)]
    public void Body_with_locked_axes_does(Locks locked)
    {
        foreach (string act in new[] { "nothing", "gravity", "torque in body axes", "all there is" })
        {
            BodyDescription body = Acting[act](new BodyDescription("body", Crowding.Masses.ElementAt(1)) { Lock = locked });
            Crowding.Same(body, TimeSteps.Every(0.02), Crowding.Starts(9, 5, body), [1, 20, 150]);
        }
    }

    [TestCase(false, false)]
    [TestCase(false, true)]
    [TestCase(true, true)]
    public void Script_that_does_not_normalise_does(bool normalise, bool unitRotation)
    {
        BodyDescription body = Acting["all there is"](new BodyDescription("body", Crowding.Masses.ElementAt(1)))
            .Copy("script", Crowding.Masses.ElementAt(1));
        body.Rule = Rules.LabEuler;
        body.Lab = new LabSettings { Normalise = normalise, UnitRotation = unitRotation };
        // a faster one stretches its q beyond all numbers
        BodyState[] slow = [.. Crowding.Starts(13, 5, body).Where(start => start.AngularVelocity.Length < 10)];
        Crowding.Same(body, TimeSteps.Every(0.02), slow, Looks);
    }

    [TestCase("Exact")]
    [TestCase("LabEuler")]
    public void Bodies_damped_until_no_number_is_left_do(string rule)
    {
        foreach (MassProperties mass in Crowding.Masses)
        {
            foreach (string act in new[] { "factors per step", "damping that leaves nothing" })
            {
                BodyDescription body = Acting[act](new BodyDescription("body", mass) { Rule = Rules.Named(rule) });
                Crowding.Same(body, TimeSteps.Every(0.02), Crowding.Starts(13, 7, body), [200, 400, 1100]);
            }
        }
    }

    [TestCase("Exact")]
    [TestCase("Exact4")]
    [TestCase("LabEuler")]
    public void Steps_of_many_lengths_do(string rule)
    {
        double[] lengths = [.. Enumerable.Range(0, 40).Select(n => new[] { 1e-3, 0.02, 0.02, 1.5, 40 }[n % 5])];
        foreach (MassProperties mass in Crowding.Masses)
        {
            foreach (string act in new[] { "nothing", "gravity and damping", "all there is" })
            {
                BodyDescription body = Acting[act](new BodyDescription("body", mass) { Rule = Rules.Named(rule) });
                Crowding.Same(body, TimeSteps.Of(lengths), Crowding.Starts(26, 11, body), [3, 4, 40]);
            }
        }
    }
}
