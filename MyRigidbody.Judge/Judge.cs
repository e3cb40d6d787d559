using System;

namespace RigidBodyDynamics.Judging
{
    /// <summary>The decision: which of the five steps are as the sheet has them.</summary>
    public static class Judge
    {
        public static Verdict Decide(Recording recording) => throw new NotImplementedException();
    }
}
