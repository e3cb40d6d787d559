using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>A collision in ten lines of user code, by impulses alone.</summary>
public sealed class BounceTests
{
    private const double G = 9.81;

    [Test]
    public void Tumbling_box_that_bounces_off_a_plane_ten_thousand_times_keeps_its_energy()
    {
        Vector3d edges = new(1, 0.4, 0.7), up = new(0, 1, 0);
        Simulation simulation = new(TimeSteps.Every(0.01));
        Body box = simulation.Add(new BodyDescription("box", Solids.Box(2, edges))
        {
            Start = new BodyState(up, Quaterniond.Identity, Vector3d.Zero, new Vector3d(0.3, 2, 0.1)),
        }.With(new Gravity(-G * up)));
        Vector3d[] corners = [.. Corners(edges)];
        double start = Energy(box), largest = 0;
        for (int bounces = 0; bounces < 10_000; simulation.Step())
        {
            BodyState now = box.State;
            foreach (Vector3d arm in corners.Select(now.Orientation.Rotate))
            {
                double v = Vector3d.Dot(now.Velocity + Vector3d.Cross(now.AngularVelocity, arm), up);
                if (now.Position.Y + arm.Y > 0 || v >= 0)
                    continue;

                Vector3d turn = now.Orientation.RotateInverse(Vector3d.Cross(arm, up));
                double give = box.Mass.InverseMass + Vector3d.Dot(turn, Vector3d.Scale(box.Mass.InversePrincipalMoments, turn));
                box.ApplyImpulse(-2 * v / give * up, now.Position + arm);
                bounces++;
                break;
            }

            largest = Math.Max(largest, Math.Abs(Energy(box) / start - 1));
        }

        Assert.That(largest, Is.LessThan(1e-9)); // measured 1.1e-13
    }

    [Test]
    public void Ball_that_bounces_straight_up_and_down_comes_back_at_the_times_of_free_fall()
    {
        // dropped from g/8 it falls for half a second, and is back after one: exactly, in steps of 1/64 s
        Simulation simulation = new(TimeSteps.Every(1 / 64.0));
        Body ball = simulation.Add(new BodyDescription("ball", Solids.Sphere(1, 0.1))
        {
            Start = new BodyState(new Vector3d(0, G / 8, 0), Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero),
        }.With(new Gravity(new Vector3d(0, -G, 0))));
        for (int bounce = 0; bounce < 1000; bounce++)
        {
            simulation.Step(bounce == 0 ? 32 : 64);
            Assert.That(ball.State.Position.Y, Is.EqualTo(0).Within(1e-12)); // measured 6.9e-14
            Assert.That(ball.State.Velocity.Y, Is.EqualTo(-G / 2).Within(1e-12)); // measured 0
            ball.ApplyImpulse(new Vector3d(0, -2 * ball.State.Velocity.Y, 0));
        }
    }

    private static double Energy(Body body) => body.KineticEnergy + body.Mass.Mass * G * body.State.Position.Y;

    private static IEnumerable<Vector3d> Corners(Vector3d edges)
    {
        for (int i = 0; i < 8; i++)
            yield return 0.5 * new Vector3d((i & 1) == 0 ? edges.X : -edges.X, (i & 2) == 0 ? edges.Y : -edges.Y, (i & 4) == 0 ? edges.Z : -edges.Z);
    }
}
