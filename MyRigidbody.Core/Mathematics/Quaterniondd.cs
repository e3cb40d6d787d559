namespace RigidBodyDynamics
{
    /// <summary>A turn in twice the digits (<see cref="DoubleDouble"/>): of a start, and of a state that is shown.</summary>
    internal readonly struct Quaterniondd
    {
        public readonly DoubleDouble W;
        public readonly Vector3dd Vector;

        public Quaterniondd(DoubleDouble w, Vector3dd vector)
        {
            W = w;
            Vector = vector;
        }

        /// <summary>A quaternion and what has been rounded away of it.</summary>
        public Quaterniondd(Quaterniond q, Quaterniond lost) : this(new DoubleDouble(q.W, lost.W), new Vector3dd(q.Vector, lost.Vector)) { }

        /// <summary>The nearest quaternion in double.</summary>
        public Quaterniond Rounded => new Quaterniond(W.High, Vector.Rounded);

        /// <summary>What that lacks.</summary>
        public Quaterniond Lost => new Quaterniond(W.Low, Vector.Lost);

        public Quaterniondd Conjugate => new Quaterniondd(W, -1 * Vector);

        private DoubleDouble LengthSquared => W * W + Vector3dd.Dot(Vector, Vector);

        /// <summary>The quaternion of length 1 in the same direction, to all digits.</summary>
        public static Quaterniondd Unit(Quaterniond q)
        {
            Quaterniondd all = new Quaterniondd(q.W, q.Vector);
            return (1 / DoubleDouble.Sqrt(all.LengthSquared)) * all;
        }

        public static Quaterniondd operator *(DoubleDouble s, Quaterniondd a) => new Quaterniondd(s * a.W, s * a.Vector);

        public static Quaterniondd operator *(Quaterniondd a, Quaterniondd b) => new Quaterniondd(
            a.W * b.W - Vector3dd.Dot(a.Vector, b.Vector), a.W * b.Vector + b.W * a.Vector + Vector3dd.Cross(a.Vector, b.Vector));

        /// <summary>Takes a vector of the body to the world: v + 2u × (w v + u × v)/|q|², for a length that may be off 1 by roundings.</summary>
        public Vector3dd Rotate(Vector3dd v) =>
            v + (4 + -2 * LengthSquared) * Vector3dd.Cross(Vector, W * v + Vector3dd.Cross(Vector, v));
    }
}
