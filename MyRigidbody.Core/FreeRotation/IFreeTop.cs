namespace RigidBodyDynamics
{
    /// <summary>
    /// The rotation of a body between pushes, exact for any time: a struct that holds orientation and angular velocity in the form
    /// that suits the body's moments. The three kinds are those of the textbooks: spherical, symmetric, asymmetric top.
    /// </summary>
    internal interface IFreeTop
    {
        /// <summary>Takes body axes to world axes.</summary>
        Quaterniond Orientation { get; }

        /// <summary>ω in world axes, rad/s; for pushes that read it, within a few roundings.</summary>
        Vector3d AngularVelocity { get; }

        /// <summary>Orientation and angular velocity, rounded once.</summary>
        void Show(out Quaterniond orientation, out Vector3d angularVelocity);

        /// <summary>False once a number in it is infinite or NaN.</summary>
        bool IsFinite { get; }

        /// <summary>True if a rotation over any time costs about as much as one over a short time, and is as exact.</summary>
        bool HasClosedForm { get; }

        /// <summary>Starts with a body; ω in body axes.</summary>
        void Start(MassProperties mass, in Quaterniondd orientation, in Vector3dd angularVelocity);

        /// <summary>Rotates freely for a time (s) of any length and sign.</summary>
        void Advance(double time);

        /// <summary>
        /// Rotates freely for a time (s) in one closed form, whose error does not grow with the number of revolutions.
        /// </summary>
        void Leap(DoubleDouble time);

        /// <summary>Adds an angular momentum, N m s: a part in world axes and a part in body axes.</summary>
        void Kick(in Vector3d world, in Vector3d body);

        /// <summary>Applies damping to ω.</summary>
        void Damp(in Decay decay);
    }
}
