namespace RigidBodyDynamics
{
    /// <summary>How exactly a script follows the lab where students differ. For the lab's integrators only.</summary>
    public sealed class LabSettings
    {
        /// <summary>Scale q to length 1 after each step. Without it q grows and R is no rotation any more.</summary>
        public bool Normalise { get; set; } = true;

        /// <summary>Where q is not kept at length 1: make R from a copy that is.</summary>
        public bool UnitRotation { get; set; }

        /// <summary>
        /// q + [0, ½ Δt ω] q, as the sheet has it, which turns by 2 atan(ω Δt / 2). False: the whole angle ω Δt, as
        /// scripts do that turn by <c>Quaternion.AngleAxis</c>.
        /// </summary>
        public bool FirstOrderOrientation { get; set; } = true;

        /// <summary>The same settings, to be changed by themselves.</summary>
        public LabSettings Copy() => (LabSettings)MemberwiseClone();

        internal bool IsLike(LabSettings other) =>
            Normalise == other.Normalise && UnitRotation == other.UnitRotation && FirstOrderOrientation == other.FirstOrderOrientation;
    }
}
