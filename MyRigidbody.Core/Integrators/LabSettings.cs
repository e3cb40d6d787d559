namespace RigidBodyDynamics
{
    /// <summary>How exactly a script follows the lab where students differ. For the lab's integrators only.</summary>
    public sealed class LabSettings
    {
        /// <summary>Scale q to length 1 after each step. Without it q grows and R is no rotation any more.</summary>
        public bool Normalise { get; set; } = true;

        /// <summary>Where q is not kept at length 1: make R from a copy that is.</summary>
        public bool UnitRotation { get; set; }

        /// <summary>The same settings, to be changed by themselves.</summary>
        public LabSettings Copy() => new LabSettings { Normalise = Normalise, UnitRotation = UnitRotation };

        internal bool IsLike(LabSettings other) => Normalise == other.Normalise && UnitRotation == other.UnitRotation;
    }
}
