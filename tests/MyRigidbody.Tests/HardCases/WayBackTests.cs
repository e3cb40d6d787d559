using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>With all velocities reversed a motion goes back the way it came, if its integrator is reversible.</summary>
public sealed class WayBackTests
{
    private const int Steps = 500;

    private static readonly Vector3d[] Moments = [new(1, 2, 2.5), new(2, 2, 1), new(2, 2, 2)];

    private static IEnumerable<string> ThereAndBack => Rules.All.Where(rule => rule.Keeps.HasFlag(Keeps.WayBack)).Select(rule => rule.Name);

    private static IEnumerable<string> OneWay => Rules.All.Where(rule => !rule.Keeps.HasFlag(Keeps.WayBack)).Select(rule => rule.Name);

    // measured at most 8.4e-12, by Exact4
    [TestCaseSource(nameof(ThereAndBack))]
    public void As_many_steps_back_end_at_the_start(string integrator)
    {
        double worst = Moments.Max(moments => Math.Max(Off(integrator, moments, isPushed: true), Off(integrator, moments, isPushed: false)));
        TestContext.Out.WriteLine(FormattableString.Invariant($"{worst:g2}"));
        Assert.That(worst, Is.LessThan(3e-11).And.GreaterThan(0));
    }

    // measured at least 1.5e-3, by RungeKutta4
    [TestCaseSource(nameof(OneWay))]
    public void Integrators_that_do_not_declare_it_do_not_find_back(string integrator)
    {
        double worst = Moments.Max(moments => Off(integrator, moments, isPushed: true));
        TestContext.Out.WriteLine(FormattableString.Invariant($"{worst:g2}"));
        Assert.That(worst, Is.GreaterThan(1e-4));
    }

    private static double Off(string integrator, Vector3d moments, bool isPushed)
    {
        BodyState start = Pushes.State, there = Run(start);
        there.Velocity = -there.Velocity;
        there.AngularVelocity = -there.AngularVelocity;
        BodyState back = Run(there);
        return new[]
        {
            Samples.Apart(back.Position, start.Position),
            Conserved.AngleBetween(back.Orientation, start.Orientation),
            Samples.Apart(-back.Velocity, start.Velocity),
            Samples.Apart(-back.AngularVelocity, start.AngularVelocity),
        }.Max();

        BodyState Run(BodyState from)
        {
            MassProperties mass = MassProperties.FromPrincipal(2, moments, new Quaterniond(0.9, 0.1, -0.3, 0.2), new Vector3d(0.1, -0.2, 0.3));
            BodyDescription body = new("b", mass)
            {
                Rule = Rules.Named(integrator),
                Start = from,
                Unity = new UnitySettings { AngularDrag = 0, MaxAngularVelocity = double.PositiveInfinity, SleepThreshold = 0, InDouble = true },
            };
            if (isPushed)
            {
                // they read the pose and nothing else
                body.With(new Gravity(new Vector3d(0, -9.81, 0)))
                    .With(new Spring(new Vector3d(0, 0.5, 0), new Vector3d(0, 3, 0), 4))
                    .With(new HeavyTop(new Vector3d(0, 0, 1), 0.4, new Vector3d(0, 1, 0)));
            }

            Simulation simulation = Scenery.Stepped(TimeSteps.Every(0.02), body);
            simulation.Step(Steps);
            return simulation.Bodies[0].State;
        }
    }
}
