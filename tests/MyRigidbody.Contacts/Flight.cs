namespace RigidBodyDynamics.Contacts;

/// <summary>A slab thrown about its middle axis without contacts, compared with the closed form.</summary>
internal static class Flight
{
    private const int Minute = 3000;

    public static bool Holds(PhysX engine)
    {
        Console.WriteLine("\nfree flight of a slab about its middle axis, 60 s: flips, largest angle to the free top rad, energy and abs(L) off at most");
        bool holds = true;
        foreach (double drag in new[] { 0, 0.05 })
        {
            (int flips, double angle, double energy, double momentum) = Fly(engine, drag);
            Console.WriteLine($"angularDrag {drag,-6}{flips,8}{angle,12:e1}{(drag == 0 ? $"{energy,12:e1}{momentum,12:e1}" : string.Empty)}");
            holds &= flips >= (drag == 0 ? 9 : 1) && angle < 1e-6; // measured 1.5e-7
        }

        return holds;
    }

    private static (int Flips, double Angle, double Energy, double Momentum) Fly(PhysX engine, double drag)
    {
        double[] still = [0, 0, 0];
        World world = new(engine, new Setting { Gravity = still, Bodies = [new Box([1, 0.4, 0.1], still, still, [0.02, 6, 0.01]) { IsExact = true, AngularDrag = drag, SleepThreshold = 0 }] });
        BodyDescription slab = new("slab", world[0].MassProperties(out _)) { Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, world[0].AngularVelocity) };
        if (drag > 0)
            slab.With(new AngularDamping(-Math.Log(1 - ((float)drag * World.Dt)) / 0.02));

        FreeMotion free = new(slab);
        int flips = 0;
        double angle = 0, energy = 0, momentum = 0, firstEnergy = world.Spin(0), firstMomentum = world.Momentum(0).Length;
        bool isUp = true;
        for (int step = 1; step <= Minute; step++)
        {
            world.Step();
            angle = Math.Max(angle, Conserved.AngleBetween(free.At(step * 0.02).Orientation, world[0].Orientation.Normalized));
            energy = Math.Max(energy, Math.Abs(world.Spin(0) / firstEnergy - 1));
            momentum = Math.Max(momentum, Math.Abs(world.Momentum(0).Length / firstMomentum - 1));
            bool wasUp = isUp;
            isUp = world.Orientation(0).RotateInverse(world.AngularVelocity(0)).Y > 0;
            flips += isUp != wasUp ? 1 : 0;
        }

        return (flips, angle, energy, momentum);
    }
}
