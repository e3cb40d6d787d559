namespace RigidBodyDynamics
{
    /// <summary>Choices that differ between scripts of the lab. For the lab's integrators only.</summary>
    public sealed class LabSettings
    {
        /// <summary>Scale q to length 1 after each step. Without it q grows and R is no longer a rotation.</summary>
        public bool Normalise { get; set; } = true;

        /// <summary>Where q is not scaled: compute R from a scaled copy.</summary>
        public bool UnitRotation { get; set; }

        /// <summary>
        /// q + [0, ½ Δt ω] q, as on the sheet, which rotates by 2 atan(ω Δt / 2). False: the whole angle ω Δt, as in scripts that
        /// rotate by <c>Quaternion.AngleAxis</c>.
        /// </summary>
        public bool FirstOrderOrientation { get; set; } = true;

        /// <summary>A separate copy of the settings.</summary>
        public LabSettings Copy() => (LabSettings)MemberwiseClone();

        internal bool IsLike(LabSettings other) =>
            Normalise == other.Normalise && UnitRotation == other.UnitRotation && FirstOrderOrientation == other.FirstOrderOrientation;
    }
}
