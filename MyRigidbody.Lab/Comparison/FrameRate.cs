namespace RigidBodyDynamics.Lab.Comparison;

/// <summary>The effect of calling AddForce for the keys in Update, as the course's script does, on DefaultRigidbody.</summary>
/// <param name="FramesPerSecond">The number of calls of Update in a second.</param>
/// <param name="Impulse">The impulse of the keys, as a multiple of that in FixedUpdate; NaN if they give none.</param>
/// <param name="AngularImpulse">The same for the torque.</param>
/// <param name="Apart">The difference from the same body with forces applied in FixedUpdate.</param>
internal sealed record FrameRate(int FramesPerSecond, double Impulse, double AngularImpulse, Apart Apart)
{
    /// <summary>The rates that are shown.</summary>
    public static readonly int[] Shown = [30, 60, 144, 240];

    // hours; every frame of it is computed
    private const double LongestScene = 1e5;

    /// <summary>True if keys act on the body, and its scene does not last for days.</summary>
    public static bool Matters(BodyDescription body, TimeSteps steps) =>
        body.Effects.Any(IsKey) && steps.StartOf(steps.Count) <= LongestScene;

    /// <summary>
    /// Runs the body once with its keys as they are, and once with the sums of the frames. AddForce only adds to a sum, which the
    /// next physics step applies, so a step may apply the same force never, once or several times.
    /// </summary>
    public static FrameRate Of(BodyDescription body, TimeSteps steps, int framesPerSecond)
    {
        Vector3d[] force = new Vector3d[steps.Count], torque = new Vector3d[steps.Count];
        double end = steps.StartOf(steps.Count);
        for (long frame = 0; frame / (double)framesPerSecond < end; frame++)
        {
            double time = frame / (double)framesPerSecond;
            long next = FirstAfter(steps, time);
            if (next < steps.Count)
            {
                Wrench wrench = Keys(body, framesPerSecond, frame, time);
                force[next] += wrench.Force;
                torque[next] += wrench.Torque;
            }
        }

        BodyDescription inUpdate = body.Copy(body.Name, body.Mass).Without(effect => IsKey(effect));
        inUpdate.With(new PerStep(force, torque));
        (double impulse, double angular) = Given(body, steps);
        return new FrameRate(
            framesPerSecond,
            Sum(force, steps) / impulse,
            Sum(torque, steps) / angular,
            Apart.Between(body, inUpdate, steps));
    }

    private static bool IsKey(Effect effect) => effect.Motion is KeyPush;

    /// <summary>Within a frame Unity runs the due physics steps first, then Update.</summary>
    private static long FirstAfter(TimeSteps steps, double time)
    {
        long step = steps.FirstAt(time);
        bool isDueNow = step < steps.Count && Math.Abs(steps.StartOf(step) - time) <= 2e-6 * steps.Length(step);
        return isDueNow ? step + 1 : step;
    }

    private static Wrench Keys(BodyDescription body, int framesPerSecond, long frame, double time)
    {
        TimeSteps frames = TimeSteps.Every(1.0 / framesPerSecond);
        Wrench wrench = default;
        foreach (Effect effect in body.Effects.Where(IsKey))
        {
            if (frames.FirstAt(effect.From) <= frame && frame < frames.FirstAt(effect.To))
                ((KeyPush)effect.Motion).At(new Instant(0, time), body.Start, body.Mass, ref wrench);
        }

        return wrench;
    }

    /// <summary>The impulses of the keys in FixedUpdate, N s and N m s.</summary>
    private static (double Impulse, double AngularImpulse) Given(BodyDescription body, TimeSteps steps)
    {
        Vector3d[] force = new Vector3d[steps.Count], torque = new Vector3d[steps.Count];
        for (long step = 0; step < steps.Count; step++)
        {
            Wrench wrench = default;
            foreach (Effect effect in body.Effects.Where(IsKey))
            {
                if (steps.FirstAt(effect.From) <= step && step < steps.FirstAt(effect.To))
                    ((KeyPush)effect.Motion).At(new Instant(step, steps.StartOf(step)), body.Start, body.Mass, ref wrench);
            }

            force[step] = wrench.Force;
            torque[step] = wrench.Torque;
        }

        return (Sum(force, steps), Sum(torque, steps));
    }

    private static double Sum(Vector3d[] values, TimeSteps steps) =>
        values.Select((value, step) => value.Length * steps.Length(step)).Sum();
}
