namespace RigidBodyDynamics
{
    /// <summary>
    /// Principal axes in the order of a top: cyclic, so that the handedness stays. The axes of the world are in the same order, so
    /// components are moved without arithmetic, and a tiny one beside a large one keeps all its digits.
    /// </summary>
    internal readonly partial struct PrincipalAxesOrder
    {
        private readonly Quaterniond _frame, _frameLost;
        private readonly int _first;
        private readonly bool _isTurned;

        /// <summary>The order that begins with principal axis number first (0, 1, 2).</summary>
        public PrincipalAxesOrder(MassProperties mass, int first) : this(mass.PrincipalMoments, mass.PrincipalFrame, first) { }

        /// <summary>The order that begins with principal axis number first (0, 1, 2).</summary>
        public PrincipalAxesOrder(Vector3d principalMoments, Quaterniond frame, int first)
        {
            Quaterniondd unit = Quaterniondd.Unit(frame);
            _frame = unit.Rounded;
            _frameLost = unit.Lost;
            _isTurned = _frame != Quaterniond.Identity;
            _first = first;
            Moments = Cycled(principalMoments, first);
        }

        /// <summary>The moments in this order, kg m².</summary>
        public Vector3d Moments { get; }

        private int Last => _first == 0 ? 0 : 3 - _first;

        private Quaterniondd Frame => new Quaterniondd(_frame, _frameLost);

        /// <summary>From a quaternion that takes body axes to world axes, the one that takes principal axes to world axes, both in this order.</summary>
        public Quaterniondd FromBody(Quaterniondd orientation)
        {
            Quaterniondd turned = _isTurned ? orientation * Frame : orientation;
            return new Quaterniondd(turned.W, Cycled(turned.Vector, _first));
        }

        /// <summary>From a quaternion that takes principal axes to world axes, both in this order, the one that takes body axes to world axes.</summary>
        public Quaterniond ToBody(Quaterniond orientation)
        {
            Quaterniond back = new Quaterniond(orientation.W, Cycled(orientation.Vector, Last));
            return _isTurned ? back * _frame.Conjugate : back;
        }

        /// <summary>The same in twice the digits.</summary>
        public Quaterniondd ToBody(Quaterniondd orientation)
        {
            Quaterniondd back = new Quaterniondd(orientation.W, Cycled(orientation.Vector, Last));
            return _isTurned ? back * Frame.Conjugate : back;
        }

        /// <summary>A vector given in body axes, in principal axes.</summary>
        public Vector3d FromBody(Vector3d v) => Cycled(_isTurned ? _frame.RotateInverse(v) : v, _first);

        /// <summary>The same in twice the digits.</summary>
        public Vector3dd FromBody(Vector3dd v) => Cycled(_isTurned ? Frame.Conjugate.Rotate(v) : v, _first);

        /// <summary>A vector given in principal axes, in body axes.</summary>
        public Vector3d ToBody(Vector3d v)
        {
            Vector3d back = Cycled(v, Last);
            return _isTurned ? _frame.Rotate(back) : back;
        }

        /// <summary>A vector in world axes, put in this order.</summary>
        public Vector3d FromWorld(Vector3d v) => Cycled(v, _first);

        /// <summary>A vector of this order, in world axes.</summary>
        public Vector3d ToWorld(Vector3d v) => Cycled(v, Last);

        private static Vector3d Cycled(Vector3d v, int first) =>
            first == 0 ? v : first == 1 ? new Vector3d(v.Y, v.Z, v.X) : new Vector3d(v.Z, v.X, v.Y);

        private static Vector3dd Cycled(Vector3dd v, int first) =>
            first == 0 ? v : first == 1 ? new Vector3dd(v.Y, v.Z, v.X) : new Vector3dd(v.Z, v.X, v.Y);
    }
}
