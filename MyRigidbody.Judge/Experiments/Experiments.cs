using System;

namespace RigidBodyDynamics.Judging
{
    /// <summary>What a script is put through.</summary>
    public static class Experiments
    {
        /// <summary>Plays all experiments; what the script throws is thrown on.</summary>
        public static Recording Record(ILaboratory laboratory) => throw new NotImplementedException();
    }
}
