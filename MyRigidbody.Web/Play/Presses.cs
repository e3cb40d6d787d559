using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Web.Play;

/// <summary>The keys of the lab as held, by the numbers of steps.</summary>
internal sealed class Presses
{
    /// <summary>The end of a key that is still held.</summary>
    public const long Open = long.MaxValue;

    // a body has at most 1000 effects, and some are the scene's own
    private const int Most = 900;

    private static readonly (LabKey One, LabKey Other)[] Opposite = [(LabKey.LeftArrow, LabKey.RightArrow), (LabKey.UpArrow, LabKey.DownArrow)];

    private readonly List<(LabKey Key, long From, long To)> _all = [];
    private int _held;

    /// <summary>Each from its first step to the first step after it; in the order of keys, in which their forces are added.</summary>
    public IEnumerable<(LabKey Key, long From, long To)> All => _all.OrderBy(press => press.Key);

    /// <summary>The keys held at present.</summary>
    public LabKeyboard Keyboard { get; } = new();

    /// <summary>Sets the keys held from a step on. True if that is a change. Keys of opposite directions give no force.</summary>
    /// <param name="held">A bit for each key, the first of <see cref="LabKey"/> the lowest.</param>
    /// <param name="step">The next step.</param>
    /// <exception cref="InputException">There are as many presses as a scene can hold.</exception>
    public bool Hold(int held, long step)
    {
        foreach ((LabKey one, LabKey other) in Opposite)
        {
            int both = (1 << (int)one) | (1 << (int)other);
            held &= (held & both) == both ? ~both : ~0;
        }

        if (held == _held)
            return false;

        if ((held & ~_held) != 0 && _all.Count >= Most)
            throw new InputException($"keys: a scene holds {Most} presses, and these are more");

        foreach (LabKey key in Enum.GetValues<LabKey>())
        {
            int bit = 1 << (int)key;
            if ((held & bit) != 0 && (_held & bit) == 0)
                _all.Add((key, step, Open));
            else if ((held & bit) == 0 && (_held & bit) != 0)
                Release(key, step);

            Keyboard[key] = (held & bit) != 0;
        }

        _held = held;
        return true;
    }

    private void Release(LabKey key, long step)
    {
        int at = _all.FindLastIndex(press => press.Key == key);
        long from = _all[at].From;
        if (from < step)
            _all[at] = (key, from, step);
        else
            _all.RemoveAt(at);
    }
}
