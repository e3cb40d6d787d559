using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

public sealed class AttemptTests
{
    private static readonly MassProperties Slab = Solids.Box(2, new Vector3d(1, 4, 9));

    [Test]
    public void Impulse_off_centre_wakes_a_rotation()
    {
        Simulation s = new(TimeSteps.Every(1 / 64.0));
        Body b = s.Add(new BodyDescription("b", Slab));
        Assert.That(b.Plan.LeftOut, Is.EqualTo(Omissions.Rotation | Omissions.Translation));
        s.Step(5);
        b.ApplyImpulse(new Vector3d(0, 0, 3), new Vector3d(0.5, 0, 0));
        // L = r × J
        Assert.That(b.AngularMomentum.Y, Is.EqualTo(-1.5).Within(1e-15));
        Assert.That(b.State.Velocity.Z, Is.EqualTo(1.5));
        s.Step(640);
        Assert.That(b.AngularMomentum.Y, Is.EqualTo(-1.5).Within(1e-14));
        Assert.That(b.State.Position.Z, Is.EqualTo(15).Within(1e-13));
    }

    [Test]
    public void Applied_force_equals_effect_force([ValueSource(typeof(Scenery), nameof(Scenery.Integrators))] string integrator)
    {
        Vector3d f = new(1, -2, 3);
        Simulation s = new(TimeSteps.Every(1 / 64.0)), e = new(TimeSteps.Every(1 / 64.0), Scenery.Body(integrator).With(new Force(f)).With(Torque.Constant(f)));
        Body b = s.Add(Scenery.Body(integrator));
        for (int i = 0; i < 100; i++)
        {
            b.ApplyForce(0.5 * f);
            b.ApplyForce(0.5 * f);
            b.ApplyTorque(f);
            s.Step();
        }

        e.Step(100);
        Assert.That((b.State.Position - e.Bodies[0].State.Position).Length, Is.LessThan(1e-12));
        Assert.That(Conserved.AngleBetween(b.State.Orientation, e.Bodies[0].State.Orientation), Is.LessThan(1e-9));
        s.Step(7);
        e.Step(7);
        TestContext.Out.WriteLine(b.State.Velocity + " " + e.Bodies[0].State.Velocity);
    }

    [Test]
    public void Between_is_exact_where_a_body_coasts()
    {
        BodyDescription d = new("b", Slab) { Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(1, 2, 3), new Vector3d(3, 0.1, 9)) };
        d.With(new Gravity(new Vector3d(0, -9.81, 0)));
        FreeMotion free = new(d);
        Simulation s = new(TimeSteps.Every(0.125));
        Body b = s.Add(d);
        s.Step(333);
        foreach (double alpha in new[] { 0, 0.25, 0.7, 1 })
        {
            BodyState want = free.At((332 + alpha) * 0.125), got = b.Between(alpha);
            Assert.That((want.Position - got.Position).Length, Is.LessThan(1e-11));
            Assert.That(Conserved.AngleBetween(want.Orientation, got.Orientation), Is.LessThan(1e-13));
        }

        b.ApplyImpulse(new Vector3d(5, 5, 5), Vector3d.Zero);
        foreach (double alpha in new[] { 0, 0.25, 0.7, 1 })
            Assert.That(Conserved.AngleBetween(free.At((332 + alpha) * 0.125).Orientation, b.Between(alpha).Orientation), Is.LessThan(1e-13));
    }

    [Test]
    public void Steps_of_any_length()
    {
        BodyDescription d = new("b", Slab) { Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(1, 2, 3), new Vector3d(3, 0.1, 9)) };
        d.With(new LinearDamping(0.3));
        FreeMotion free = new(d);
        Simulation s = new(TimeSteps.Every(0.02));
        Body b = s.Add(d), forced = s.Add(new BodyDescription("f", Slab).With(new Force(new Vector3d(2, 0, 0)), 1, 2));
        double t = 0;
        for (int i = 0; i < 200; i++)
        {
            double h = 0.01 + 0.001 * (i % 17);
            s.StepBy(h);
            t += h;
            if (i % 10 == 0)
            {
                s.Step();
                t += 0.02;
            }
        }

        Assert.That(s.Time, Is.EqualTo(t).Within(1e-13));
        Assert.That(Conserved.AngleBetween(free.At(t).Orientation, b.State.Orientation), Is.LessThan(1e-13));
        Assert.That((free.At(t).Position - b.State.Position).Length, Is.LessThan(1e-13));
        Assert.That(forced.State.Velocity.X, Is.EqualTo(1).Within(0.02));
    }

    [Test]
    public void Advance_keeps_the_rest()
    {
        Simulation s = new(TimeSteps.Every(0.02));
        for (int i = 0; i < 1000; i++)
            s.Advance(0.1);
        Assert.That(s.StepsDone, Is.EqualTo(5000));
        Assert.That(s.Advance(0.031), Is.EqualTo(1));
        Assert.That(s.Alpha, Is.EqualTo(0.55).Within(1e-9));
    }

    [Test]
    public void Changed_mass()
    {
        Simulation s = new(TimeSteps.Every(0.02));
        BodyDescription d = new("b", Slab) { Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(1, 2, 3), new Vector3d(3, 0.1, 9)) };
        Body b = s.Add(d);
        s.Step(77);
        Vector3d l = b.AngularMomentum;
        b.Change(new BodyDescription("b", Solids.Sphere(4, 1)), Keeping.Momentum);
        Assert.That((b.AngularMomentum - l).Length, Is.LessThan(1e-13 * l.Length));
        Assert.That(b.State.Velocity, Is.EqualTo(new Vector3d(0.5, 1, 1.5)));
        Assert.That(b.State.Position.X, Is.EqualTo(77 * 0.02).Within(1e-14));
    }

    [Test]
    public void Bounces()
    {
        Simulation s = new(TimeSteps.Every(0.001));
        Body b = s.Add(new BodyDescription("b", Solids.Box(2, new Vector3d(1, 0.4, 0.7))) { Start = new BodyState(new Vector3d(0, 3, 0), Quaterniond.Identity, new Vector3d(0, 0, 0), new Vector3d(0.3, 2, 0.1)) }.With(new Gravity(new Vector3d(0, -9.81, 0))));
        double Energy() => b.KineticEnergy + 2 * 9.81 * b.State.Position.Y;
        double start = Energy();
        int bounces = 0;
        while (bounces < 10000)
        {
            s.Step();
            BodyState now = b.State;
            for (int i = 0; i < 8; i++)
            {
                Vector3d arm = now.Orientation.Rotate(new Vector3d(((i & 1) - 0.5) * 1, ((i >> 1 & 1) - 0.5) * 0.4, ((i >> 2 & 1) - 0.5) * 0.7));
                Vector3d v = now.Velocity + Vector3d.Cross(now.AngularVelocity, arm);
                if (now.Position.Y + arm.Y > 0 || v.Y >= 0)
                    continue;
                Vector3d n = new(0, 1, 0), across = Vector3d.Cross(arm, n), turned = now.Orientation.RotateInverse(across);
                double slow = b.Mass.InverseMass + Vector3d.Dot(turned, Vector3d.Scale(b.Mass.InversePrincipalMoments, turned));
                b.ApplyImpulse(-2 * v.Y / slow * n, now.Position + arm);
                bounces++;
                break;
            }
        }

        TestContext.Out.WriteLine((Energy() - start) / start + " after steps " + s.StepsDone);
        Assert.That(Energy(), Is.EqualTo(start).Within(1e-9 * start));
    }
}
