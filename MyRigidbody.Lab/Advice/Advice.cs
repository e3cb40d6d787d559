namespace RigidBodyDynamics.Lab;

/// <summary>By which rule, in which steps, a scene is had exactly enough at the least cost.</summary>
public sealed class Advice
{
    internal Advice(Truth truth, Trial best, Trial? runnerUp, string reason)
    {
        Truth = truth;
        Best = best;
        RunnerUp = runnerUp;
        Reason = reason;
    }

    /// <summary>The motion that the rules were compared with.</summary>
    public Truth Truth { get; }

    /// <summary>True if a rule keeps the error below the bound.</summary>
    public bool Reached => Reason.Length == 0;

    /// <summary>The cheapest rule and step below the bound; if none is, the trial with the smallest error.</summary>
    public Trial Best { get; }

    /// <summary>The cheapest of the other rules below the bound; null if there is none.</summary>
    public Trial? RunnerUp { get; }

    /// <summary>By what factor the runner-up is dearer; NaN if there is none.</summary>
    public double Factor => RunnerUp == null ? double.NaN : RunnerUp.Cost / Best.Cost;

    /// <summary>Why no step keeps the error below the bound; empty if one does.</summary>
    public string Reason { get; }
}
