namespace RigidBodyDynamics
{
    /// <summary>A body that does not rotate: it has an orientation, and nothing is computed.</summary>
    internal partial struct HeldTop : IFreeTop
    {
        public Quaterniond Orientation { get; private set; }

        public Vector3d AngularVelocity => Vector3d.Zero;

        public bool IsFinite => true;

        public bool HasClosedForm => true;

        public void Start(MassProperties mass, in Quaterniondd orientation, in Vector3dd angularVelocity) => Orientation = orientation.Rounded;

        public void Show(out Quaterniond orientation, out Vector3d angularVelocity)
        {
            orientation = Orientation;
            angularVelocity = Vector3d.Zero;
        }

        public void Advance(double time) { }

        public void Leap(DoubleDouble time) { }

        public void Kick(in Vector3d world, in Vector3d body) { }

        public void Damp(in Decay decay) { }
    }
}
