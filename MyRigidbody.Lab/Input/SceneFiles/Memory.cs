using System.Globalization;

namespace RigidBodyDynamics.Lab;

/// <summary>The memory that a scene needs, before any of it is allocated.</summary>
internal static class Memory
{
    // measured with 10 and 100 bodies of 1000 windows each: 75 bytes for every effect in every stretch in which it acts
    private const double BytesOfEffect = 75, BytesOfStretch = 250;

    /// <summary>The memory available to this process, bytes: of the machine, the container or the runtime's limit.</summary>
    public static double Available => GC.GetGCMemoryInfo().TotalAvailableMemoryBytes;

    /// <summary>Refuses what needs more memory than there is.</summary>
    /// <param name="what">Its name in the message.</param>
    /// <param name="bytes">The memory it needs.</param>
    /// <exception cref="ArgumentException">It needs more than there is.</exception>
    public static void MustHold(string what, double bytes)
    {
        if (bytes > Available && Available > 0)
        {
            throw new ArgumentException(string.Create(
                CultureInfo.InvariantCulture, $"{what}: take about {bytes / 1e9:0.0#} GB of memory, and there are {Available / 1e9:0.0#} GB"));
        }
    }

    /// <summary>The memory of the stretches of a body: time is cut where an effect begins or ends, and each stretch stores its effects.</summary>
    public static double OfStretches(BodyDescription body, TimeSteps steps)
    {
        if (body.Effects.Count < 2)
            return BytesOfStretch;

        // how many effects begin there, less those that end
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
