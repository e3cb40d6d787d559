namespace RigidBodyDynamics.Lab.Inertia;

/// <summary>
/// Compares a possible body with its homogeneous geometry. No real link equals it, so only a difference is reported that no
/// distribution of mass explains, or that a common mistake explains to a few per cent.
/// </summary>
internal static class GeometryDiagnosis
{
    // kg/m³: no solid is denser than osmium
    private const double Heaviest = 23_000, Lightest = 0.1;

    private static readonly (double Factor, string Unit)[] Units =
    [
        (1e9, "in g mm² (1 g mm² is 1e-9 kg m²)"), (1e6, "in kg mm² (1 kg mm² is 1e-6 kg m²)"), (1e4, "in kg cm² (1 kg cm² is 1e-4 kg m²)"), (1e3, "in g m²"),
        (1e-3, "in t m²"), (1e-6, "in t mm², or a geometry in millimetres, whose scale of 0.001 is missing"),
    ];

    /// <summary>The doubtful numbers.</summary>
    public static IEnumerable<Finding> Of(DescribedBody body, double mass, Geometry geometry, MassProperties even)
    {
        double volume = geometry.Whole().Mass, density = mass / volume;
        Vector3d half = 0.5 * (geometry.High - geometry.Low);
        Finding? center = Center(body.Center, geometry), tensor = Tensor(body, mass, even, half, center != null);
        if (density < Lightest && tensor?.Code == "units")
        {
            // the error is in the geometry, and has been reported
        }
        else if (density > Heaviest || density < Lightest)
        {
            // the geometry is in the same wrong units
            tensor = tensor?.Code == "units" ? null : tensor;
            yield return new Finding("mass", Severity.Doubtful, FormattableString.Invariant(
                $"{mass:G4} kg in {volume:G3} m³ of geometry are {density:G3} kg/m³, {(density > Heaviest ? "heavier than any metal: grams for kilograms, or a geometry in other units?" : "lighter than air: tonnes for kilograms, or a geometry in millimetres?")}"));
        }

        if (center != null)
            yield return center;

        if (tensor != null)
            yield return tensor;
    }

    private static Finding? Center(Vector3d center, Geometry geometry)
    {
        double off = Outside(center, geometry);
        return off < 0.5 * geometry.Size ? null
            : Outside(0.001 * center, geometry) == 0 && center.Length > 20 * geometry.Size
                ? new Finding("center-units", Severity.Doubtful, FormattableString.Invariant($"the centre of mass is {center.Length:G3} m from the origin and the geometry is {geometry.Size:G3} m large: millimetres for metres?"))
                : new Finding("center", Severity.Doubtful, FormattableString.Invariant($"the centre of mass is {off:G3} m outside the geometry, which is {geometry.Size:G3} m large"));
    }

    private static double Outside(Vector3d p, Geometry box)
    {
        double x = Math.Max(0, Math.Max(box.Low.X - p.X, p.X - box.High.X)), y = Math.Max(0, Math.Max(box.Low.Y - p.Y, p.Y - box.High.Y));
        return new Vector3d(x, y, Math.Max(0, Math.Max(box.Low.Z - p.Z, p.Z - box.High.Z))).Length;
    }

    private static Finding? Tensor(DescribedBody body, double mass, MassProperties even, Vector3d half, bool isCenterOff)
    {
        SymmetricMatrix3 given = body.InBodyAxes, filled = even.Inertia;
        double ratio = Tensors.Spread(given) / Tensors.Spread(filled), apart = Tensors.Apart(given, filled);
        string expected = "; evenly filled it would be " + Tensors.Text(filled, 4);
        // for any distribution of mass: no mass is farther from the middle than the corners of the box
        double most = mass * half.LengthSquared;
        if (apart < 0.3)
            return Mirrored(given, filled);

        if (Diagnosis.Placeholder(body.Tensor) is string placeholder)
            return new Finding("placeholder", Severity.Doubtful, placeholder + expected);

        (double factor, string unit) = Units.MinBy(unit => Math.Abs(Math.Log(ratio / unit.Factor)));
        if (ratio / factor is > 0.2 and < 5)
            return new Finding("units", Severity.Doubtful, FormattableString.Invariant($"its moments are {ratio:G2} times those of the geometry evenly filled: {unit}?") + expected);

        SymmetricMatrix3 aboutOrigin = filled + mass * SymmetricMatrix3.OfPoint(body.Center);
        if (!body.Center.IsZero && !isCenterOff && Tensors.Apart(given, aboutOrigin) < 0.15 && Tensors.Apart(aboutOrigin, filled) > 0.3)
            return new Finding("about-origin", Severity.Doubtful, "it was taken about the origin of the link, and is wanted about the centre of mass" + expected);

        if (Mirrored(given, filled) is Finding mirrored)
            return mirrored;

        foreach ((double times, string how) in new[] { (4.0, "twice the lengths (half edges were wanted, or the diameter stands for the radius)"), (0.25, "half the lengths (full edges were wanted, or the radius stands for the diameter)") })
        {
            if (Tensors.Apart(given, times * filled) < 0.03)
                return new Finding("lengths", Severity.Doubtful, FormattableString.Invariant($"it is {times:R} times that of the geometry: computed with {how}") + expected);
        }

        if (Exchanged(given, filled) is string axes)
            return new Finding("axes", Severity.Doubtful, $"its moments are those of the geometry about other axes: {axes}" + expected);

        return Tensors.Spread(given) > 1.05 * most
            ? new Finding("too-large", Severity.Doubtful, FormattableString.Invariant($"its moments are {ratio:G3} times those of the geometry evenly filled: no mass within it is so far from the centre") + expected)
            : ratio < 0.05
                ? new Finding("too-small", Severity.Doubtful, FormattableString.Invariant($"its moments are {ratio:G2} times those of the geometry evenly filled") + expected)
                : null;
    }

    private static Finding? Mirrored(SymmetricMatrix3 given, SymmetricMatrix3 filled)
    {
        // products large enough to matter, and within three tenths after the rotation
        SymmetricMatrix3 products = filled with { XX = 0, YY = 0, ZZ = 0 }, own = given with { XX = 0, YY = 0, ZZ = 0 };
        bool matter = Tensors.Apart(filled with { XY = 0, XZ = 0, YZ = 0 }, filled) > 0.05;
        return matter && Tensors.Apart(own, -1 * products) < 0.3
            ? new Finding("product-signs", Severity.Doubtful, "the signs of its products are reversed: ixy is minus the integral of x y; evenly filled it would be " + Tensors.Text(filled, 4))
            : null;
    }

    private static string? Exchanged(SymmetricMatrix3 given, SymmetricMatrix3 filled)
    {
        double[] g = [given.XX, given.YY, given.ZZ], f = [filled.XX, filled.YY, filled.ZZ];
        foreach ((int[] order, string axes) in new[] { (new[] { 1, 0, 2 }, "x and y exchanged"), ([2, 1, 0], "x and z exchanged"), ([0, 2, 1], "y and z exchanged"), ([1, 2, 0], "x, y, z as y, z, x"), ([2, 0, 1], "x, y, z as z, x, y") })
        {
            if (Enumerable.Range(0, 3).All(i => Math.Abs(g[i] / f[order[i]] - 1) < 0.1))
                return axes;
        }

        return null;
    }
}
