using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>The two gyroscopic integrators of game engines against their equations.</summary>
public sealed class GyroscopicRuleTests
{
    private static readonly Vector3d[] Moments = [new(1, 2, 2.5), new(2.5, 1, 2), new(0.4, 0.9, 1)];
    private static readonly Vector3d[] Spins = [new(1, 2, -1.5), new(-3, 0.5, 4), new(0.2, -6, 0.3)];

    [Test]
    public void Implicit_integrator_is_one_Newton_step([Values(0.01, 0.1, 1)] double dt)
    {
        // F(w₊) = I (w₊ − w) + Δt w₊ × I w₊ is quadratic, so its derivative along d is (F(w + d) − F(w − d))/2 without an error
        foreach (Vector3d i in Moments)
        {
            foreach (Vector3d w in Spins)
            {
                Vector3d d = default(ImplicitRule).After(w, i, dt) - w;
                Vector3d left = F(w) + 0.5 * (F(w + d) - F(w - d));
                Assert.That(left.Length, Is.LessThan(1e-14)); // measured at most 2.5e-15 of 18

                Vector3d F(Vector3d next) => Vector3d.Scale(i, next - w) + dt * Vector3d.Cross(next, Vector3d.Scale(i, next));
            }
        }
    }

    [Test]
    public void Explicit_integrator_turns_the_momentum_as_Euler_would_and_keeps_its_length([Values(0.01, 0.1, 1)] double dt)
    {
        foreach (Vector3d i in Moments)
        {
            foreach (Vector3d w in Spins)
            {
                Vector3d before = Vector3d.Scale(i, w), after = Vector3d.Scale(i, default(ExplicitRule).After(w, i, dt));
                Vector3d euler = before + dt * Vector3d.Cross(before, w);
                Assert.That(after.Length / before.Length, Is.EqualTo(1).Within(1e-15)); // measured at most 4.4e-16
                Assert.That(Samples.Apart(after / after.Length, euler / euler.Length), Is.LessThan(1e-15)); // measured at most 3.3e-16
            }
        }
    }

    [Test]
    public void Body_at_rest_stays_at_rest()
    {
        Assert.That(default(ImplicitRule).After(Vector3d.Zero, Moments[0], 0.1), Is.EqualTo(Vector3d.Zero));
        Assert.That(default(ExplicitRule).After(Vector3d.Zero, Moments[0], 0.1), Is.EqualTo(Vector3d.Zero));
    }
}
