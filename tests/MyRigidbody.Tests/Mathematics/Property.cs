using System.Globalization;
using CsCheck;
using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>A claim about every sample of a generator.</summary>
internal static class Property
{
    /// <summary>No sample's error exceeds the bound. A failure prints the smallest failing sample and its seed.</summary>
    public static void Holds<T>(Gen<T> samples, Func<T, double> error, double bound, int count = 2000)
    {
        double largest = 0;
        object gate = new();

        bool WithinBound(T sample)
        {
            double e = error(sample);
            lock (gate)
                largest = Math.Max(largest, e);
            return e <= bound;
        }

        Assert.That(() => samples.Sample(WithinBound, iter: count), Throws.Nothing);
        TestContext.Out.WriteLine(string.Create(CultureInfo.InvariantCulture, $"largest error {largest:g3}, bound {bound:g3}"));
    }

    /// <summary>Every sample is as claimed, to the bit.</summary>
    public static void Always<T>(Gen<T> samples, Func<T, bool> claim, int count = 2000) =>
        Assert.That(() => samples.Sample(claim, iter: count), Throws.Nothing);
}
