using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>What is locked stays zero, whatever acts on the body and however it lies.</summary>
public sealed class LockedZeroTests
{
    private static readonly Quaterniond Frame = new Quaterniond(0.9, 0.1, -0.3, 0.2).Normalized, Tilt = new Quaterniond(0.4, -0.3, 0.5, 0.7).Normalized;
    private static readonly Vector3d Moments = new(1, 2, 2.5);

    private static IEnumerable<string> Rule => Scenery.Integrators;

    /// <summary>
    /// Exactly, wherever what is locked can be seen in world axes; in a tilted body to rounding, or, by an integrator that takes a step in
    /// stages, to a small multiple of the power of the step that the catalogue says.
    /// </summary>
    [TestCaseSource(nameof(Rule))]
    public void What_is_locked_stays_zero_by_every_integrator_whatever_acts(string rule)
    {
        double coarse = Unlocked(rule, 60), fine = Unlocked(rule, 120);
        TestContext.Out.WriteLine(FormattableString.Invariant($"{rule}: {coarse:g2}, {fine:g2}"));
        if (!Scenery.TakesStages(rule))
        {
            Assert.That(new[] { coarse, fine }, Is.All.LessThanOrEqualTo(rule == "UnityRigidbody" ? 1e-5 : 5e-14)); // measured 1.3e-6 in single precision, 2.8e-14
            return;
        }

        int order = Scenery.Body(rule).Rule.Order;
        Assert.That(coarse, Is.LessThan(5 * Math.Pow(1.0 / 60, order))); // measured 4.8e-8 below 3.9e-7 of RungeKutta4
        Assert.That(coarse / fine, Is.GreaterThan(0.7 * Math.Pow(2, order))); // measured 37 of RungeKutta4
    }

    /// <summary>How large, at most, an angular velocity about a locked axis of a tilted body is, rad/s.</summary>
    private static double Unlocked(string rule, int stepsPerSecond)
    {
        double worst = 0;
        for (Locks locked = Locks.None; locked <= (Locks.Move | Locks.Turn); locked++)
        {
            foreach (bool isUpright in new[] { true, false })
            {
                BodyDescription body = Scenery.Busy(rule);
                BodyState start = body.Start;
                body = body.Copy("locked", MassProperties.FromPrincipal(2, Moments, isUpright ? Quaterniond.Identity : Frame, isUpright ? Vector3d.Zero : new Vector3d(0.1, 0.2, 0)));
                start.Orientation = isUpright ? Quaterniond.Identity : Tilt;
                body.Lock = locked;
                body.Start = locked.Applied(start, body.Mass);
                Simulation simulation = new(TimeSteps.Every(1.0 / stepsPerSecond), body);
                for (int step = 0; step < 1.5 * stepsPerSecond; step++)
                {
                    simulation.Step();
                    BodyState now = simulation.Bodies[0].State;
                    Vector3d w = (now.Orientation * body.Mass.PrincipalFrame).Normalized.RotateInverse(now.AngularVelocity);
                    Vector3d about = w - locked.Turning(w);
                    worst = Math.Max(worst, about.Length);
                    Assert.That(now.Velocity, Is.EqualTo(locked.Moving(now.Velocity)), $"{locked}");
                    if (isUpright && locked.TurnNames().Length > 1)
                        Assert.That(about.Length, Is.Zero, $"{locked}, step {step}");

                    if (isUpright)
                        Assert.That(now.Position - start.Position, Is.EqualTo(locked.Moving(now.Position - start.Position)), $"{locked}");
                }
            }
        }

        return worst;
    }
}
