namespace RigidBodyDynamics.Lab.Inertia;

/// <summary>Finds errors in a body's mass and inertia, and the common mistake that explains them.</summary>
internal static class Diagnosis
{
    // rounding explains at most this part of the largest moment: a number of three digits
    private const double MostRounded = 1e-3;

    // a tensor within this part of the homogeneous geometry counts as that of the geometry
    private const double Alike = 0.5;

    private static readonly double[] Slips = [10, 100, 1000, 0.1, 0.01, 0.001];

    /// <summary>All errors, the most certain first.</summary>
    public static IReadOnlyList<Finding> Of(DescribedBody body)
    {
        if (body.Mass is not double mass || body.IsComputed)
            return body.Faults;

        List<Finding> findings = [.. body.Faults];
        if (mass <= 0)
            findings.Add(new Finding("mass", Severity.Wrong, FormattableString.Invariant($"mass is {mass:R} kg: a body that moves has a mass above zero; what is fixed needs no inertial")));

        double[] moments = Tensors.Moments(body.Tensor);
        if (moments[2] == 0 && moments[0] == 0)
            findings.Add(new Finding("no-inertia", Severity.Wrong, "all moments are zero: a body that turns has some"));
        else if (!Tensors.IsPossible(body.Tensor))
            findings.AddRange(Impossible(body, mass, moments));
        else if (mass > 0)
            findings.AddRange(body.Geometry is Geometry geometry && geometry.Weighing(mass) is MassProperties even ? GeometryDiagnosis.Of(body, mass, geometry, even) : Alone(body, mass));

        return findings;
    }

    private static IEnumerable<Finding> Impossible(DescribedBody body, double mass, double[] moments)
    {
        SymmetricMatrix3 tensor = body.Tensor;
        double excess = Tensors.Excess(moments), half = 3 * Largest(body.HalfDigits);
        string nearest = "the nearest possible tensor is " + Tensors.Text(Tensors.Nearest(tensor));
        double missing = Math.Max(excess, -moments[0]);
        if (missing > 0 && missing <= Math.Min(half, MostRounded * moments[2]))
        {
            yield return new Finding("rounded", Severity.Doubtful, FormattableString.Invariant(
                $"the largest moment, {moments[2]:G7}, is above the sum of the others by {excess:G2} kg m², which its last digit explains: written with too few digits; {nearest}"));
            yield break;
        }

        string what = moments[0] <= 0
            ? FormattableString.Invariant($"no body has a moment of {moments[0]:G4} kg m² about an axis")
            : FormattableString.Invariant($"no moment can exceed the sum of the other two, and {moments[2]:G4} is above {moments[0]:G4} + {moments[1]:G4} kg m²");
        yield return Cause(body, mass) is (string code, string cause)
            ? new Finding(code, Severity.Wrong, $"{what}: {cause}")
            : new Finding(moments[0] <= 0 ? "not-positive" : "triangle", Severity.Wrong, $"{what}; {nearest}");
    }

    // the common mistake whose correction gives a possible body, and one like its geometry where that is known
    private static (string Code, string Cause)? Cause(DescribedBody body, double mass)
    {
        SymmetricMatrix3 tensor = body.Tensor;
        SymmetricMatrix3? filled = mass > 0 ? body.Geometry?.Weighing(mass)?.Inertia : null;
        // six in the order xx, yy, zz, xy, xz, yz, read as in URDF: xx, xy, xz, yy, yz, zz
        if (body.Listed is [double xx, double xy, double xz, double yy, double yz, double zz]
            && IsLike(body, new SymmetricMatrix3 { XX = xx, YY = yy, ZZ = zz, XY = xy, XZ = xz, YZ = yz }, filled))
        {
            return ("order", "the six numbers are those of a body if they stand in URDF's order, ixx ixy ixz iyy iyz izz; fullinertia wants xx yy zz xy xz yz");
        }

        if (!Tensors.IsDiagonal(tensor) && IsLike(body, Tensors.Turned(tensor), filled))
            return ("product-signs", "with the signs of the products reversed it is possible: ixy is minus the integral of x y, and many drawing programs print plus; " + Tensors.Text(Tensors.Turned(tensor)));

        SymmetricMatrix3 moved = mass * SymmetricMatrix3.OfPoint(body.Center), back = body.InBodyAxes + moved;
        if (!body.Center.IsZero && mass > 0 && Tensors.IsPossible(back) && (filled is not SymmetricMatrix3 even || Tensors.Apart(back, even) < Alike))
            return ("moved-twice", "with m (d·d 1 − d dᵀ) added it is possible: it was moved from the origin of the link to the centre of mass once more than it should; about the centre of mass in the link's axes it is " + Tensors.Text(back));

        return Slip(body, filled) is (string name, double factor, SymmetricMatrix3 possible)
            ? ("decimal-point", FormattableString.Invariant($"{name} times {factor:R} makes a body of it: its decimal point may have slipped; {Tensors.Text(possible)}"))
            : null;
    }

    /// <summary>One number times or by 10, 100, 1000; of the corrections that give a possible body the one most like the geometry, or else the roundest.</summary>
    private static (string Name, double Factor, SymmetricMatrix3 Possible)? Slip(DescribedBody body, SymmetricMatrix3? filled)
    {
        SymmetricMatrix3 t = body.Tensor;
        return Slips
            .SelectMany(factor => new[]
            {
                ("ixx", factor, t with { XX = factor * t.XX }), ("iyy", factor, t with { YY = factor * t.YY }), ("izz", factor, t with { ZZ = factor * t.ZZ }),
                ("ixy", factor, t with { XY = factor * t.XY }), ("ixz", factor, t with { XZ = factor * t.XZ }), ("iyz", factor, t with { YZ = factor * t.YZ }),
            })
            .Where(slip => IsLike(body, slip.Item3, filled))
            .Select(slip => ((string, double, SymmetricMatrix3)?)slip)
            .MinBy(slip => filled is SymmetricMatrix3 even ? Tensors.Apart(InBodyAxes(body, slip!.Value.Item3), even) : Roundness(slip!.Value.Item3));
    }

    private static double Roundness(SymmetricMatrix3 tensor) => Tensors.Moments(tensor) is [double least, _, double most] ? most / least : 0;

    private static bool IsLike(DescribedBody body, SymmetricMatrix3 tensor, SymmetricMatrix3? filled) =>
        Tensors.IsPossible(tensor) && (filled is not SymmetricMatrix3 even || Tensors.Apart(InBodyAxes(body, tensor), even) < Alike);

    private static SymmetricMatrix3 InBodyAxes(DescribedBody body, SymmetricMatrix3 tensor) => (body with { Tensor = tensor }).InBodyAxes;

    /// <summary>For a body without geometry in the file.</summary>
    private static IEnumerable<Finding> Alone(DescribedBody body, double mass)
    {
        if (Placeholder(body.Tensor) is string placeholder)
        {
            yield return new Finding("placeholder", Severity.Doubtful, placeholder);
            yield break;
        }

        double radius = Math.Sqrt(Tensors.Spread(body.Tensor) / mass);
        if (radius > 10)
        {
            yield return new Finding("units", Severity.Doubtful, FormattableString.Invariant(
                $"its mass would lie {radius:G3} m from its centre in the mean: kg mm² or g mm² for kg m²? {(radius > 1e4 ? "1 g mm² is 1e-9 kg m²" : "1 kg mm² is 1e-6 kg m²")}"));
        }
        else if (radius < 1e-5)
        {
            yield return new Finding("units", Severity.Doubtful, FormattableString.Invariant($"its mass would lie within {radius:G3} m of its centre: lengths or masses in other units?"));
        }

        SymmetricMatrix3 moved = body.InBodyAxes - mass * SymmetricMatrix3.OfPoint(body.Center);
        if (body.Center.LengthSquared > 2.5 * Tensors.Spread(moved) / mass && Tensors.IsPossible(moved))
        {
            yield return new Finding("about-origin", Severity.Note,
                "it may have been taken about the origin of the link: less m (d·d 1 − d dᵀ) it is that of a body much smaller than its centre of mass is far from the origin, " + Tensors.Text(moved));
        }
    }

    /// <summary>The default of generators: three equal moments, a power of ten.</summary>
    public static string? Placeholder(SymmetricMatrix3 t)
    {
        double power = t.XX > 0 ? Math.Pow(10, Math.Round(Math.Log10(t.XX))) : 0;
        return t.XX == t.YY && t.YY == t.ZZ && Tensors.IsDiagonal(t) && Math.Abs(t.XX / power - 1) < 1e-9
            ? FormattableString.Invariant($"three equal moments of {t.XX:R} kg m² are a placeholder, and not a computed value")
            : null;
    }

    private static double Largest(SymmetricMatrix3 t) =>
        new[] { t.XX, t.YY, t.ZZ, t.XY, t.XZ, t.YZ }.Max();
}
