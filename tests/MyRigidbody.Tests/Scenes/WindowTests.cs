using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>An effect acts during exactly the steps of its window: the same bits as an integrator driven by hand.</summary>
public sealed class WindowTests
{
    private static readonly Force Pull = new(new Vector3d(5, -1, 2));
    private static readonly Torque Swing =
        new(new Vector3d(0.1, 0, 0), new Vector3d(0, 0.2, 0), new Vector3d(0, 0, 0.3), 1.5, inBody: true);

    // steps of the two windows below, for steps of 1/60 s and for steps of 5, 20 and 25 ms one after another
    private static readonly object[] Cases =
    [
        new object[] { 0, 15, 45, 30, 60 },
        new object[] { 1, 15, 45, 30, 60 },
    ];

    [TestCaseSource(nameof(Cases))]
    public void Two_windows_act_from_their_first_step_to_the_one_before_their_end(int division, int a, int b, int c, int d)
    {
        TimeSteps steps = Scenery.Divisions().ElementAt(division);
        double At(int step) => Math.Round(steps.StartOf(step), 9);
        BodyDescription Described(string integrator) => Scenery.Body(integrator)
            .With(Pull, At(a), At(b))
            .With(Swing, At(c), At(d))
            .With(new Gravity(new Vector3d(0, -9.81, 0)), At(c), At(d))
            .With(new AngularDamping(0.3), At(c), At(d));

        Check<LabEuler>("LabEuler");
        Check<ExplicitEuler>("ExplicitEuler");
        Check<UnityRigidbody<ToSingle>>("UnityRigidbody");
        Check<UnityRigidbody<ToDouble>>("UnityRigidbody in double");

        void Check<TIntegrator>(string integrator) where TIntegrator : struct, IIntegrator
        {
            TIntegrator byHand = default;
            byHand.Start(new Beginning(Scenery.Body(integrator)));
            Simulation simulation = new(steps, Described(integrator));
            for (int n = 0; n < Scenery.Steps; n++)
            {
                simulation.Step();
                bool forced = n >= a && n < b, turned = n >= c && n < d;
                Coasting coasting = Coasting.Free;
                if (turned)
                {
                    coasting.Acceleration = new Vector3d(0, -9.81, 0);
                    coasting.AngularDampingRate = 0.3;
                }

                byHand.Prepare(steps.Length(n), coasting);
                Push(ref byHand, new Instant(n, steps.StartOf(n)), forced, turned);
                Assert.That(simulation.Bodies[0].State, Is.EqualTo(byHand.State), $"{integrator}, step {n}");
            }
        }
    }

    [Test]
    public void Window_that_contains_no_start_of_a_step_never_acts()
    {
        TimeSteps steps = TimeSteps.Every(0.02, 50);
        BodyState without = Scenery.Run(steps, Scenery.Body("LabEuler"), 50);
        BodyState with = Scenery.Run(steps, Scenery.Body("LabEuler").With(Pull, 0.201, 0.219).With(Pull, 5, 6).With(Pull, -3, 0), 50);
        Assert.That(with, Is.EqualTo(without));
    }

    [Test]
    public void Window_of_one_step_is_one_kick()
    {
        BodyDescription body = new BodyDescription("b", Solids.Sphere(2, 1)).With(new Force(new Vector3d(8, 0, 0)), 0.5, 0.75);
        Simulation simulation = new(TimeSteps.Every(0.25, 8), body);
        List<double> velocities = [];
        for (int i = 0; i < 8; i++)
        {
            simulation.Step();
            velocities.Add(simulation.Bodies[0].State.Velocity.X);
        }

        Assert.That(velocities, Is.EqualTo(new double[] { 0, 0, 1, 1, 1, 1, 1, 1 }));
    }

    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Any_number_of_effects_pushes_as_one_sum_of_them(string integrator)
    {
        TimeSteps steps = TimeSteps.Every(1.0 / 60, 90);
        IPush[] pushes =
        [
            new KeyPush(LabKey.UpArrow), Swing, new KeyPush(LabKey.R), new QuadraticDrag(0.05), new KeyPush(LabKey.LeftArrow),
            new Spring(new Vector3d(0, 0.5, 0), new Vector3d(0, 3, 0), 4), new HeavyTop(new Vector3d(0, 0, 1), 0.4, new Vector3d(0, 1, 0)),
            new KeyPush(LabKey.RightArrow), new PerStep([new Vector3d(1, 2, 3)], []), Torque.Constant(new Vector3d(0.01, 0, 0)),
        ];
        BodyDescription apart = Scenery.Body(integrator)
            .With(new KeyPush(LabKey.UpArrow)).With(Swing).With(new KeyPush(LabKey.R)).With(new QuadraticDrag(0.05)).With(new KeyPush(LabKey.LeftArrow))
            .With(new Spring(new Vector3d(0, 0.5, 0), new Vector3d(0, 3, 0), 4))
            .With(new HeavyTop(new Vector3d(0, 0, 1), 0.4, new Vector3d(0, 1, 0)))
            .With(new KeyPush(LabKey.RightArrow)).With(new PerStep([new Vector3d(1, 2, 3)], []))
            .With(Torque.Constant(new Vector3d(0.01, 0, 0)));
        BodyState sum = Scenery.Run(steps, Scenery.Body(integrator).With(new Many(pushes)), 90);
        Assert.That(Scenery.Run(steps, apart, 90), Is.EqualTo(sum));

        // the last of them counts too
        pushes[^1] = Torque.Constant(new Vector3d(0.02, 0, 0));
        Assert.That(Scenery.Run(steps, Scenery.Body(integrator).With(new Many(pushes)), 90), Is.Not.EqualTo(sum));
    }

    [Test]
    public void Effect_that_is_not_there_leaves_the_same_bits_as_one_that_pushes_with_nothing()
    {
        TimeSteps steps = TimeSteps.Every(1.0 / 60, 90);
        BodyState without = Scenery.Run(steps, Scenery.Body("LabEuler"), 90);
        BodyDescription idle = Scenery.Body("LabEuler")
            .With(new QuadraticDrag(0)).With(new LinearDamping(0)).With(new Gravity(Vector3d.Zero)).With(new Force(Vector3d.Zero));
        BodyState with = Scenery.Run(steps, idle, 90);
        Assert.That(with, Is.EqualTo(without));
    }

    private static void Push<TIntegrator>(ref TIntegrator body, in Instant now, bool forced, bool turned)
        where TIntegrator : struct, IIntegrator
    {
        Nothing nothing = default;
        Force force = Pull;
        Torque torque = Swing;
        Both<Force, Torque> both = new(force, torque);
        if (forced && turned)
            body.Step(now, ref both);
        else if (forced)
            body.Step(now, ref force);
        else if (turned)
            body.Step(now, ref torque);
        else
            body.Step(now, ref nothing);
    }
}
