namespace RigidBodyDynamics.Lab;

/// <summary>The cheapest integrator and step length that keep the error of a scene below a bound.</summary>
public sealed class Advice
{
    internal Advice(Truth truth, Contest contest)
    {
        Truth = truth;
        Best = contest.Best;
        RunnerUp = contest.RunnerUp;
        Rounds = contest.RoundsOfBoth;
        RoundsWon = contest.RoundsWon;
        Reason = string.Empty;
    }

    internal Advice(Truth truth, Trial closest, string reason)
    {
        Truth = truth;
        Best = closest;
        Reason = reason;
    }

    /// <summary>The motion with which the integrators were compared.</summary>
    public Truth Truth { get; }

    /// <summary>True if an integrator keeps the error below the bound.</summary>
    public bool Reached => Reason.Length == 0;

    /// <summary>The cheapest integrator and step length below the bound; if there is none, the trial with the smallest error.</summary>
    public Trial Best { get; }

    /// <summary>The cheapest of the other integrators below the bound, each with its longest step; null if there is none.</summary>
    public Trial? RunnerUp { get; }

    /// <summary>The cost of the runner-up divided by that of the best; NaN if there is none.</summary>
    public double Factor => RunnerUp == null ? double.NaN : RunnerUp.Cost / Best.Cost;

    /// <summary>The number of rounds in which both were timed.</summary>
    public int Rounds { get; }

    /// <summary>The number of rounds in which the best was the cheaper of the two.</summary>
    public int RoundsWon { get; }

    /// <summary>True if the measurement cannot separate the two: the one that is first in the catalogue is then advised.</summary>
    public bool IsTie => RunnerUp != null && (Factor < Advisor.SameCost || RoundsWon < 0.75 * Rounds);

    /// <summary>Why no step keeps the error below the bound; empty if one does.</summary>
    public string Reason { get; }
}
