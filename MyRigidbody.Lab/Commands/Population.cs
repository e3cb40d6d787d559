using System.Numerics;
using System.Runtime.CompilerServices;
using RigidBodyDynamics.Lab.Output;

namespace RigidBodyDynamics.Lab.Commands;

/// <summary>All bodies of a scene: those that stand alone, and those in numbers, which are stepped together.</summary>
internal sealed class Population
{
    // of fewer it is not worth while to try how much they take
    private const int Many = 100_000, Tried = 4096;

    private readonly Simulation? _alone;
    private readonly List<(BodyDescription Body, Batch Batch, BodyState[] States)> _crowds = [];

    public Population(Scene scene, IReadOnlyDictionary<string, ManyBodies> crowds)
    {
        Steps = scene.Steps;
        Memory.MustHold("bodies", crowds.Values.Where(crowd => crowd.Count > Many).Sum(crowd => BytesOf(crowd, scene.Steps)));
        List<BodyDescription> alone = [.. scene.Bodies.Where(body => !crowds.ContainsKey(body.Name))];
        _alone = alone.Count > 0 ? new Simulation(new Scene(scene.Name, scene.About, scene.Steps, alone)) : null;
        foreach (BodyDescription body in scene.Bodies.Where(body => crowds.ContainsKey(body.Name)))
        {
            Batch batch = crowds[body.Name].Gather(scene.Steps);
            _crowds.Add((body, batch, new BodyState[batch.EndOfIds]));
        }
    }

    public TimeSteps Steps { get; }

    /// <summary>What a crowd takes, as a small one of its kind does, whose columns have grown by doubling: half of what they took is left behind.</summary>
    private static double BytesOf(ManyBodies crowd, TimeSteps steps)
    {
        long before = GC.GetAllocatedBytesForCurrentThread();
        (crowd with { Count = Tried }).Gather(steps);
        double each = (GC.GetAllocatedBytesForCurrentThread() - before) / 2.0 / Tried;
        return (each * BitOperations.RoundUpToPowerOf2((uint)crowd.Count)) + ((double)Unsafe.SizeOf<BodyState>() * crowd.Count);
    }

    /// <summary>How many bodies there are.</summary>
    public int Count => (_alone?.Bodies.Count ?? 0) + _crowds.Sum(crowd => crowd.States.Length);

    public long StepsDone { get; private set; }

    public void Step(long count)
    {
        _alone?.Step(count);
        foreach ((_, Batch batch, _) in _crowds)
        {
            batch.Step(count);
        }

        StepsDone += count;
    }

    /// <summary>The first bodies as they are now; those in numbers are called by their name and number.</summary>
    public IEnumerable<(string Name, BodyDescription Description, BodyState State)> States(int most)
    {
        foreach (Body body in (_alone?.Bodies ?? []).Take(most))
        {
            yield return (body.Name, body.Plan.Asked, body.State);
        }

        int left = most - Math.Min(most, _alone?.Bodies.Count ?? 0);
        foreach ((BodyDescription body, Batch batch, BodyState[] states) in _crowds)
        {
            batch.Read(states);
            for (int i = 0; i < states.Length && left > 0; i++, left--)
            {
                yield return ($"{body.Name} {i}", body, states[i]);
            }
        }
    }

    /// <summary>A row for every body; those in numbers are called by their name and number.</summary>
    public void WriteRows(TrajectoryCsv csv)
    {
        if (_alone is not null)
        {
            csv.WriteRows(_alone);
        }

        foreach ((BodyDescription body, Batch batch, BodyState[] states) in _crowds)
        {
            batch.Read(states);
            for (int i = 0; i < states.Length; i++)
            {
                csv.WriteRow($"{body.Name} {i}", StepsDone, batch.Time, states[i], body.Mass, batch.IsAsleep(i));
            }
        }
    }

    public void MustBeFinite(string path)
    {
        if (_alone is not null)
        {
            RunCommand.MustBeFinite(_alone, path);
        }

        foreach ((BodyDescription body, Batch batch, BodyState[] states) in _crowds)
        {
            batch.Read(states);
            for (int i = 0; i < states.Length; i++)
            {
                // a name for each of millions would cost more than the look
                if (!RunCommand.IsFinite(states[i], body.Mass))
                {
                    RunCommand.MustBeFinite(path, $"{body.Name} {i}", states[i], body, StepsDone);
                }
            }
        }
    }
}
