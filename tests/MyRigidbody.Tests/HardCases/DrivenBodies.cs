namespace RigidBodyDynamics.Tests;

/// <summary>Measures of bodies with effects.</summary>
internal static class DrivenBodies
{
    /// <summary>v against v₀ e^(−ct) after 10 steps of 1 s with c from 1 to 1000 1/s, relative; what is below 1e-300 counts as zero.</summary>
    public static double StiffDamping(string integrator)
    {
        double worst = 0;
        foreach (double rate in new[] { 1.0, 10, 30, 1000 })
        {
            BodyState state = Scenery.Run(TimeSteps.Every(1), Ball(integrator, new Vector3d(3, 0, 0)).With(new LinearDamping(rate)).With(new AngularDamping(rate)), 10);
            double right = 3 * Math.Exp(-10 * rate);
            worst = Math.Max(worst, right > 1e-300 ? Math.Abs(state.Velocity.X / right - 1) : Math.Abs(state.Velocity.X));
            // and it has moved v₀/c
            worst = Math.Max(worst, Math.Abs(state.Position.X * rate / (3 * -Expm1(-10 * rate)) - 1));
        }

        return Finite(worst);

        static double Expm1(double x) => Math.Abs(x) < 1e-5 ? x + 0.5 * x * x : Math.Exp(x) - 1;
    }

    /// <summary>
    /// A ball on a spring in steps of so many of the longest stable one: its largest swing in a million steps against
    /// that of a swing in exact time, which is 1.
    /// </summary>
    public static double Swing(string integrator, double part)
    {
        Spring spring = new(Vector3d.Zero, Vector3d.Zero, 100);
        BodyDescription ball = Ball(integrator, Vector3d.Zero).With(spring);
        ball.Start = new BodyState(new Vector3d(1, 0, 0), Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero);
        Simulation simulation = new(TimeSteps.Every(part * spring.LongestStableStep(ball.Mass)), ball);
        double most = 0;
        for (int n = 0; n < 1000; n++)
        {
            if (!simulation.TryStep(n < 500 ? 1 : 1999))
                return double.PositiveInfinity;

            most = Math.Max(most, Math.Abs(simulation.Bodies[0].State.Position.X));
            if (!(most < 1e6))
                return double.PositiveInfinity;
        }

        return most;
    }

    /// <summary>
    /// A top that stands upright and spins fast enough, ω₃² &gt; 4 m g l I₁/I₃², stays there: the largest tilt in 60 s of one
    /// that starts 1e-6 rad aside, in those.
    /// </summary>
    public static double SleepingTop(string integrator) => 1e6 * LargestTilt(integrator, 10, 60);

    /// <summary>
    /// One that is too slow falls until cos θ = (I₃ω₃)²/(2 m g l I₁) − 1 (Goldstein, Classical Mechanics, § 5.7) and rises again:
    /// how far its largest tilt is from that, rad.
    /// </summary>
    public static double FallenTop(string integrator) => Math.Abs(LargestTilt(integrator, 5, 60) - Math.Acos(2.5 * 2.5 / 6 - 1));

    /// <summary>Energy of a heavy top, kinetic and m g l cos θ, in 60 s: its largest change against m g l.</summary>
    public static double HeavyTopEnergy(string integrator)
    {
        Simulation simulation = new(TimeSteps.Every(0.02), Top(integrator, 8, 0.5));
        double start = Energy(simulation.Bodies[0]), worst = 0;
        for (int n = 0; n < 3000; n++)
        {
            if (!simulation.TryStep())
                return double.PositiveInfinity;

            worst = Math.Max(worst, Math.Abs(Energy(simulation.Bodies[0]) - start) / 3);
        }

        return Finite(worst);

        static double Energy(Body body) => body.KineticEnergy + 3 * body.State.Orientation.Rotate(new Vector3d(0, 0, 1)).Z;
    }

    /// <summary>
    /// A ball of 1e9 kg and one of 1e-3 kg on a rod, rotating end over end: the angle to the rotation of a body with two equal
    /// moments after 100 s, rad.
    /// </summary>
    public static double HugeMassRatio(string integrator)
    {
        MassProperties mass = new Compound()
            .With(Solids.Sphere(1e9, 1e-6), Vector3d.Zero)
            .With(Solids.Sphere(1e-3, 0.1), new Vector3d(1, 0, 0))
            .ToMassProperties();
        BodyDescription body = new("dumbbell", mass)
        {
            Rule = Rules.Named(integrator),
            Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, new Vector3d(3, 4, 0)),
        };
        Simulation simulation = new(TimeSteps.Every(0.02), body);
        simulation.Step(5000);
        // about L at |L|/I₁, about its own axis at (1 − I₃/I₁) ω₃
        double along = mass.PrincipalMoments.X, across = mass.PrincipalMoments.Y;
        Vector3d momentum = new(3 * along, 4 * across, 0);
        Quaterniond right = Quaterniond.FromAxisAngle(momentum, momentum.Length / across * 100)
            * Quaterniond.FromAxisAngle(new Vector3d(1, 0, 0), (across - along) / across * 3 * 100);
        return Conserved.AngleBetween(simulation.Bodies[0].State.Orientation, right);
    }

    /// <summary>
    /// A body 10⁹ m away under gravity and the key R: the difference of its displacement from that of the same one at the origin after
    /// 10 s, in last bits of 10⁹ m; infinite if its rotation or velocity has other bits.
    /// </summary>
    public static double FarAway(string integrator)
    {
        Vector3d far = new(1e9, -1e9, 1e9);
        BodyState here = Run(Vector3d.Zero), there = Run(far);
        bool same = (here.Orientation, here.Velocity, here.AngularVelocity) == (there.Orientation, there.Velocity, there.AngularVelocity);
        double lastBit = Math.BitIncrement(1e9) - 1e9;
        return same ? (there.Position - far - here.Position).Length / lastBit : double.PositiveInfinity;

        BodyState Run(Vector3d from)
        {
            BodyDescription body = new BodyDescription("body", MassProperties.FromPrincipal(1, new Vector3d(1, 2, 2.5)))
            {
                Rule = Rules.Named(integrator),
                Start = new BodyState(from, Quaterniond.Identity, new Vector3d(1, 2, 3), new Vector3d(0.3, 1.1, -0.7)),
            }.With(new Gravity(new Vector3d(0, -9.81, 0))).With(new KeyPush(LabKey.R));
            return Scenery.Run(TimeSteps.Every(0.02), body, 500);
        }
    }

    private static double LargestTilt(string integrator, double spin, double duration)
    {
        Simulation simulation = new(TimeSteps.Every(0.02), Top(integrator, spin, 1e-6));
        double most = 0;
        for (int n = 0; n < duration / 0.02; n++)
        {
            if (!simulation.TryStep())
                return double.PositiveInfinity;

            Vector3d axis = simulation.Bodies[0].State.Orientation.Rotate(new Vector3d(0, 0, 1));
            most = Math.Max(most, Math.Atan2(Math.Sqrt(axis.X * axis.X + axis.Y * axis.Y), axis.Z));
        }

        return Finite(most);
    }

    // moments 1, 1, 1/2 about the pivot, m g l = 3: upright it is stable above a spin of sqrt(48) = 6.93 rad/s
    private static BodyDescription Top(string integrator, double spin, double tilt)
    {
        Quaterniond q = Quaterniond.FromAxisAngle(new Vector3d(1, 0, 0), tilt);
        return new BodyDescription("top", MassProperties.FromPrincipal(1, new Vector3d(1, 1, 0.5)))
        {
            Rule = Rules.Named(integrator),
            Start = new BodyState(Vector3d.Zero, q, Vector3d.Zero, q.Rotate(new Vector3d(0, 0, spin))),
        }.With(new HeavyTop(new Vector3d(0, 0, 1), 3, new Vector3d(0, 0, 1)));
    }

    private static BodyDescription Ball(string integrator, Vector3d velocity) => new("ball", Solids.Sphere(1, 0.5))
    {
        Rule = Rules.Named(integrator),
        Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, velocity, Vector3d.Zero),
    };

    private static double Finite(double figure) => double.IsFinite(figure) ? figure : double.PositiveInfinity;
}
