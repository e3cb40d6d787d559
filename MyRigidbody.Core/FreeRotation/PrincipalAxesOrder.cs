namespace RigidBodyDynamics
{
    /// <summary>
    /// Principal axes in the order a top wants them: cyclic, so that the handedness stays. A component is moved, not
    /// computed with, so a tiny one beside a large one keeps all its digits.
    /// </summary>
    internal readonly struct PrincipalAxesOrder
    {
        private readonly Quaterniond _frame;
        private readonly Quaterniond _cycle;
        private readonly int _first;
        private readonly bool _isTurned;

        /// <summary>The order in which principal axis number first (0, 1, 2) comes first.</summary>
        public PrincipalAxesOrder(MassProperties mass, int first) : this(mass.PrincipalMoments, mass.PrincipalFrame, first) { }

        /// <summary>The order in which principal axis number first (0, 1, 2) comes first.</summary>
        public PrincipalAxesOrder(Vector3d principalMoments, Quaterniond frame, int first)
        {
            _frame = frame.Normalized;
            _isTurned = _frame != Quaterniond.Identity;
            _first = first;
            // a third of a turn about (1, 1, 1) takes x to y, y to z, z to x
            _cycle = first == 0 ? Quaterniond.Identity : new Quaterniond(0.5, first == 1 ? 0.5 * Ones : -0.5 * Ones);
            Moments = Cycled(principalMoments, first);
        }

        /// <summary>The moments in this order, kg m².</summary>
        public Vector3d Moments { get; }

        private static Vector3d Ones => new Vector3d(1, 1, 1);

        /// <summary>Takes principal axes to world axes, from what takes body axes there.</summary>
        public Quaterniond FromBody(Quaterniond orientation) =>
            _isTurned ? orientation * _frame * _cycle : _first == 0 ? orientation : orientation * _cycle;

        /// <summary>Takes body axes to world axes, from what takes principal axes there.</summary>
        public Quaterniond ToBody(Quaterniond orientation)
        {
            Quaterniond back = _first == 0 ? orientation : orientation * _cycle.Conjugate;
            return _isTurned ? back * _frame.Conjugate : back;
        }

        /// <summary>A vector in body axes, in principal axes.</summary>
        public Vector3d FromBody(Vector3d v) => Cycled(_isTurned ? _frame.RotateInverse(v) : v, _first);

        /// <summary>A vector in principal axes, in body axes.</summary>
        public Vector3d ToBody(Vector3d v)
        {
            Vector3d back = Cycled(v, _first == 0 ? 0 : 3 - _first);
            return _isTurned ? _frame.Rotate(back) : back;
        }

        private static Vector3d Cycled(Vector3d v, int first) =>
            first == 0 ? v : first == 1 ? new Vector3d(v.Y, v.Z, v.X) : new Vector3d(v.Z, v.X, v.Y);
    }
}
