using System.Numerics;

namespace RigidBodyDynamics.Lab.Bench;

/// <summary>The bandwidth of memory: every number is read, multiplied and written back, as in a step of a body.</summary>
internal static class InPlaceScale
{
    /// <summary>Scales a number of doubles, as often as requested.</summary>
    public static Action<long> Of(int count, int threads)
    {
        double[] numbers = new double[count];
        Array.Fill(numbers, 1);
        int parts = count >= 1 << 16 ? threads : 1;
        ParallelOptions options = new() { MaxDegreeOfParallelism = threads };
        return times =>
        {
            for (long i = 0; i < times; i++)
            {
                if (parts == 1)
                    Scale(numbers);
                else
                    Parallel.For(0, parts, options, part => Scale(numbers.AsSpan((int)((long)count * part / parts)..(int)((long)count * (part + 1) / parts))));
            }
        };
    }

    private static void Scale(Span<double> numbers)
    {
        Vector<double> factor = new(0.9999999);
        int i = 0;
        for (; i <= numbers.Length - Vector<double>.Count; i += Vector<double>.Count)
            (factor * new Vector<double>(numbers[i..])).CopyTo(numbers[i..]);

        for (; i < numbers.Length; i++)
            numbers[i] *= 0.9999999;
    }
}
