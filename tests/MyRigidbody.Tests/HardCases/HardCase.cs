namespace RigidBodyDynamics.Tests;

/// <summary>A motion that breaks programs, a number that shows it, and the bound that a good integrator keeps.</summary>
/// <param name="Name">The claim, as the name of its test.</param>
/// <param name="Figure">The measure, with its unit.</param>
/// <param name="Elsewhere">The results of other programs; versions as measured.</param>
/// <param name="Bound">The upper bound.</param>
/// <param name="Measure">The number for an integrator of the catalogue.</param>
internal sealed record HardCase(string Name, string Figure, string Elsewhere, double Bound, Func<string, double> Measure)
{
    private readonly Dictionary<string, Lazy<double>> _measured = [];

    /// <summary>The integrators that keep the bound.</summary>
    public string[] Strong { get; init; } = ["Exact", "Exact4", "Exact6"];

    /// <summary>An integrator that does not: the same assertion has to fail with it.</summary>
    public string Weak { get; init; } = "LabEuler";

    /// <summary>The weak integrator's number is at least this.</summary>
    public double WeakFrom { get; init; }

    /// <summary>Measured once, however many tests and tables ask.</summary>
    public double By(string integrator)
    {
        Lazy<double> figure;
        lock (_measured)
        {
            if (!_measured.TryGetValue(integrator, out figure!))
                _measured.Add(integrator, figure = new Lazy<double>(() => Measure(integrator)));
        }

        return figure.Value;
    }

    public override string ToString() => Name;
}
