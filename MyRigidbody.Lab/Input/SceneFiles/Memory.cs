using System.Globalization;

namespace RigidBodyDynamics.Lab;

/// <summary>What a scene will take, before any of it is taken.</summary>
internal static class Memory
{
    // measured with 10 and 100 bodies of 1000 windows each: 75 bytes for every effect in every stretch in which it acts
    private const double BytesOfEffect = 75, BytesOfStretch = 250;

    /// <summary>What this process may have, bytes: of the machine, the container or the runtime's limit.</summary>
    public static double Available => GC.GetGCMemoryInfo().TotalAvailableMemoryBytes;

    /// <summary>Refuses what cannot fit.</summary>
    /// <param name="what">What it is.</param>
    /// <param name="bytes">What it takes.</param>
    /// <exception cref="ArgumentException">It takes more than there is.</exception>
    public static void MustHold(string what, double bytes)
    {
        if (bytes > Available && Available > 0)
        {
            throw new ArgumentException(string.Create(
                CultureInfo.InvariantCulture, $"{what}: take about {bytes / 1e9:0.0#} GB of memory, and there are {Available / 1e9:0.0#} GB"));
        }
    }

    /// <summary>What the stretches of a body take: time is cut where an effect begins or ends, and each stretch has all that acts in it.</summary>
    public static double OfStretches(BodyDescription body, TimeSteps steps)
    {
        if (body.Effects.Count < 2)
        {
            return BytesOfStretch;
        }

        // how many begin there, less those that end
        SortedDictionary<long, int> changes = [];
        foreach (Effect effect in body.Effects)
        {
            long first = steps.FirstAt(effect.From), end = Math.Max(first, steps.FirstAt(effect.To));
            changes[first] = changes.GetValueOrDefault(first) + 1;
            changes[end] = changes.GetValueOrDefault(end) - 1;
        }

        double bytes = 0;
        int acting = 0;
        foreach (int change in changes.Values)
        {
            acting += change;
            bytes += BytesOfStretch + (BytesOfEffect * acting);
        }

        return bytes;
    }
}
