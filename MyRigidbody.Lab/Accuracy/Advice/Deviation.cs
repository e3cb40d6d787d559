namespace RigidBodyDynamics.Lab;

/// <summary>The largest error of a body over all compared states.</summary>
internal sealed class Deviation
{
    private double _energy, _momentum, _energyOff, _momentumOff;

    /// <summary>Angle to the true orientation, rad.</summary>
    public double Angle { get; private set; }

    /// <summary>Distance from the true position, m.</summary>
    public double Distance { get; private set; }

    /// <summary>The larger of the two.</summary>
    public double Largest => Math.Max(Angle, Distance);

    /// <summary>Error of the kinetic energy, relative to its largest value; in J where that is zero.</summary>
    public double Energy => _energyOff / (_energy > 0 ? _energy : 1);

    /// <summary>Error of the angular momentum as a vector, relative to its largest value; in kg m²/s where that is zero.</summary>
    public double Momentum => _momentumOff / (_momentum > 0 ? _momentum : 1);

    /// <summary>Compares one more state; false if its error exceeds the limit.</summary>
    public bool Add(in BodyState found, in BodyState right, MassProperties mass, double most)
    {
        Angle = Larger(Angle, Conserved.AngleBetween(found.Orientation, right.Orientation));
        Distance = Larger(Distance, (found.Position - right.Position).Length);
        double energy = Conserved.KineticEnergy(right, mass);
        Vector3d momentum = Conserved.AngularMomentum(right, mass);
        _energy = Larger(_energy, energy);
        _momentum = Larger(_momentum, momentum.Length);
        _energyOff = Larger(_energyOff, Math.Abs(Conserved.KineticEnergy(found, mass) - energy));
        _momentumOff = Larger(_momentumOff, (Conserved.AngularMomentum(found, mass) - momentum).Length);
        return Largest <= most;
    }

    /// <summary>Keeps a NaN, which Math.Max does not do on every runtime.</summary>
    private static double Larger(double a, double b) => a >= b ? a : b + 0 * a;
}
