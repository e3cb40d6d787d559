namespace RigidBodyDynamics
{
    /// <summary>
    /// Free rotation, not exact but by five rotations about the principal axes, 1-2-3-2-1, of order 2: the flow of the
    /// energy M₁²/2I₁ alone rotates M about axis 1, and so on. |L| and its direction are conserved by construction, the energy
    /// oscillates without drift. Angles enter by their tangent (Cayley), so there is no trigonometry.
    /// </summary>
    /// <remarks>McLachlan, "Explicit Lie–Poisson integration and the Euler equations", Phys. Rev. Lett. 71 (1993).</remarks>
    internal struct SplitTop : IFreeTop
    {
        private PrincipalAxesOrder _axes;
        private Vector3d _inverseMoments;
        private Quaterniond _q;
        private Vector3d _m;

        public Quaterniond Orientation => _axes.ToBody(_q);

        public Vector3d AngularVelocity => Orientation.Rotate(_axes.ToBody(Vector3d.Scale(_inverseMoments, _m)));

        public bool IsFinite => _q.IsFinite && Guard.IsFinite(Vector3d.Scale(_inverseMoments, _m).LengthSquared);

        public bool HasClosedForm => false;

        public void Show(out Quaterniond orientation, out Vector3d angularVelocity)
        {
            Quaterniondd q = new Quaterniondd(_q.W, _q.Vector);
            orientation = _axes.ToBody(q).Rounded;
            angularVelocity = q.Rotate(Vector3d.Scale(_inverseMoments, _m)).Rounded;
        }

        public void Start(MassProperties mass, in Quaterniondd orientation, in Vector3dd angularVelocity)
        {
            _axes = new PrincipalAxesOrder(mass, 0);
            _inverseMoments = mass.InversePrincipalMoments;
            _q = _axes.FromBody(orientation).Rounded;
            _m = Vector3d.Scale(mass.PrincipalMoments, _axes.FromBody(angularVelocity).Rounded);
        }

        public void Kick(in Vector3d world, in Vector3d body)
        {
            Vector3d j = world.IsZero ? Vector3d.Zero : _q.RotateInverse(world);
            _m += body.IsZero ? j : j + _axes.FromBody(body);
        }

        public void Damp(in Decay decay) => _m = decay.Of(_m);

        public void Leap(DoubleDouble time) => Advance(time.High);

        public void Advance(double time)
        {
            Quaterniond q = _q;
            double m1 = _m.X, m2 = _m.Y, m3 = _m.Z;
            double h1 = 0.25 * time * _inverseMoments.X, h2 = 0.25 * time * _inverseMoments.Y, h3 = 0.5 * time * _inverseMoments.Z;
            Turn(h1 * m1, ref m2, ref m3, ref q.W, ref q.X, ref q.Y, ref q.Z);
            Turn(h2 * m2, ref m3, ref m1, ref q.W, ref q.Y, ref q.Z, ref q.X);
            Turn(h3 * m3, ref m1, ref m2, ref q.W, ref q.Z, ref q.X, ref q.Y);
            Turn(h2 * m2, ref m3, ref m1, ref q.W, ref q.Y, ref q.Z, ref q.X);
            Turn(h1 * m1, ref m2, ref m3, ref q.W, ref q.X, ref q.Y, ref q.Z);
            _m = new Vector3d(m1, m2, m3);
            _q = q.Normalized;
        }

        /// <summary>
        /// Rotates the body about one axis by the angle whose half has tangent t: q (1, t) up to its length, and M, constant in the
        /// world, rotates by the opposite angle in the body.
        /// </summary>
        private static void Turn(double t, ref double a, ref double b, ref double w, ref double x, ref double y, ref double z)
        {
            double f = 2 / (1 + t * t), cosine = f - 1, sine = f * t;
            double a0 = a, w0 = w, y0 = y;
            a = cosine * a0 + sine * b;
            b = cosine * b - sine * a0;
            w = w0 - t * x;
            x = x + t * w0;
            y = y0 + t * z;
            z = z - t * y0;
        }
    }
}
