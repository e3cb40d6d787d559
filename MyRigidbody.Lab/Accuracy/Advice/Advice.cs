namespace RigidBodyDynamics.Lab;

/// <summary>By which rule, in which steps, a scene is had exactly enough at the least cost.</summary>
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

    /// <summary>The motion that the rules were compared with.</summary>
    public Truth Truth { get; }

    /// <summary>True if a rule keeps the error below the bound.</summary>
    public bool Reached => Reason.Length == 0;

    /// <summary>The cheapest rule and step below the bound; if none is, the trial with the smallest error.</summary>
    public Trial Best { get; }

    /// <summary>The cheapest of the other rules below the bound, each in its longest step; null if there is none.</summary>
    public Trial? RunnerUp { get; }

    /// <summary>By what factor the runner-up is dearer; NaN if there is none.</summary>
    public double Factor => RunnerUp == null ? double.NaN : RunnerUp.Cost / Best.Cost;

    /// <summary>How often the times of both were taken, in turns.</summary>
    public int Rounds { get; }

    /// <summary>How often the best was the cheaper of the two.</summary>
    public int RoundsWon { get; }

    /// <summary>True if the clock cannot tell which of the two is cheaper: the one that stands first in the catalogue is then advised.</summary>
    public bool IsTie => RunnerUp != null && (Factor < Advisor.SameCost || RoundsWon < 0.75 * Rounds);

    /// <summary>Why no step keeps the error below the bound; empty if one does.</summary>
    public string Reason { get; }
}
