using System;

namespace RigidBodyDynamics
{
    /// <summary>How a body resists being pushed and turned. Immutable; bodies may share one.</summary>
    public sealed class MassProperties
    {
        // three moments of any real body obey I1 + I2 >= I3; sums over points break it by roundings only
        private const double TriangleTolerance = 1e-9;

        private TopShape _shape;

        private MassProperties(double mass, Vector3d moments, Quaterniond frame, SymmetricMatrix3 inertia, Vector3d center)
        {
            Mass = Guard.Positive(mass, nameof(mass));
            Guard.Positive(1 / mass, "1 / mass");
            PrincipalMoments = Possible(moments);
            PrincipalFrame = frame;
            Inertia = inertia;
            CenterOfMass = Guard.Finite(center, "centerOfMass");
            InverseMass = 1 / mass;
            InversePrincipalMoments = new Vector3d(1 / moments.X, 1 / moments.Y, 1 / moments.Z);
        }

        /// <summary>Mass, kg.</summary>
        public double Mass { get; private set; }

        /// <summary>1 / mass, 1/kg.</summary>
        public double InverseMass { get; private set; }

        /// <summary>Moments about the three principal axes through the centre of mass, kg m².</summary>
        public Vector3d PrincipalMoments { get; private set; }

        /// <summary>1 / principal moment, component by component.</summary>
        public Vector3d InversePrincipalMoments { get; private set; }

        /// <summary>
        /// Takes principal axes to body axes. Kept as it was given, so that an integrator in single precision can
        /// scale it to length 1 in its own arithmetic; all others take <c>PrincipalFrame.Normalized</c>.
        /// </summary>
        public Quaterniond PrincipalFrame { get; private set; }

        /// <summary>The inertia tensor in body axes, about the centre of mass, kg m²; the lab's I_ref.</summary>
        public SymmetricMatrix3 Inertia { get; private set; }

        /// <summary>Centre of mass in the body frame, m.</summary>
        public Vector3d CenterOfMass { get; private set; }

        /// <summary>All three moments equal: a turn about any axis goes on unchanged.</summary>
        public bool IsIsotropic => PrincipalMoments.X == PrincipalMoments.Y && PrincipalMoments.Y == PrincipalMoments.Z;

        /// <summary>What the free rotation takes from the moments; all bodies that share these properties share it.</summary>
        internal TopShape Shape => _shape ?? (_shape = new TopShape(PrincipalMoments, PrincipalFrame));

        /// <summary>A body with known principal moments.</summary>
        /// <param name="mass">kg, above zero.</param>
        /// <param name="moments">kg m², each above zero and none larger than the sum of the others.</param>
        /// <param name="frame">Takes principal axes to body axes; scaled to length 1 where it is used.</param>
        /// <param name="centerOfMass">In the body frame, m.</param>
        public static MassProperties FromPrincipal(double mass, Vector3d moments, Quaterniond frame, Vector3d centerOfMass)
        {
            Guard.Turn(frame, "frame");
            SymmetricMatrix3 diagonal = new SymmetricMatrix3(moments, Vector3d.Zero);
            SymmetricMatrix3 inertia = frame == Quaterniond.Identity
                ? diagonal
                : diagonal.RotatedBy(Matrix3.Of(frame.Normalized));
            return new MassProperties(mass, moments, frame, inertia, centerOfMass);
        }

        /// <summary>A body with known principal moments along its own axes, about its origin.</summary>
        public static MassProperties FromPrincipal(double mass, Vector3d moments) =>
            FromPrincipal(mass, moments, Quaterniond.Identity, Vector3d.Zero);

        /// <summary>A body with a known tensor about its centre of mass, in body axes. Diagonalised here, once.</summary>
        public static MassProperties FromTensor(double mass, SymmetricMatrix3 inertia, Vector3d centerOfMass)
        {
            Guard.Finite(inertia.Diagonal, "inertia");
            Guard.Finite(inertia.OffDiagonal, "inertia");
            Vector3d moments = PrincipalAxes.Of(inertia, out Quaterniond frame);
            return new MassProperties(mass, moments, frame, inertia, centerOfMass);
        }

        /// <summary>A body with a known tensor about the origin of its frame, in body axes: less by Steiner's m (d·d 1 − d dᵀ) about its centre of mass d.</summary>
        public static MassProperties FromTensorAboutOrigin(double mass, SymmetricMatrix3 inertia, Vector3d centerOfMass) =>
            FromTensor(mass, inertia - Guard.Positive(mass, nameof(mass)) * Compound.About(Guard.Finite(centerOfMass, nameof(centerOfMass))), centerOfMass);

        /// <summary>The same body with its centre of mass elsewhere in the body frame.</summary>
        public MassProperties WithCenterOfMass(Vector3d centerOfMass) =>
            new MassProperties(Mass, PrincipalMoments, PrincipalFrame, Inertia, centerOfMass);

        /// <summary>The same body with another part of its mass, and of its moments.</summary>
        internal MassProperties Times(double ratio) => ((MassProperties)MemberwiseClone()).Become(this, ratio);

        /// <summary>Makes this, which nobody else may have, such a part of another.</summary>
        internal MassProperties Become(MassProperties whole, double ratio)
        {
            Mass = ratio * whole.Mass;
            InverseMass = 1 / Mass;
            PrincipalMoments = ratio * whole.PrincipalMoments;
            InversePrincipalMoments = 1 / ratio * whole.InversePrincipalMoments;
            Inertia = new SymmetricMatrix3(ratio * whole.Inertia.Diagonal, ratio * whole.Inertia.OffDiagonal);
            PrincipalFrame = whole.PrincipalFrame;
            CenterOfMass = whole.CenterOfMass;
            _shape = null;
            return this;
        }

        private static Vector3d Possible(Vector3d moments)
        {
            Guard.Positive(moments, "principal");
            Guard.Finite(new Vector3d(1 / moments.X, 1 / moments.Y, 1 / moments.Z), "1 / principal");
            double sum = moments.X + moments.Y + moments.Z;
            double largest = Math.Max(moments.X, Math.Max(moments.Y, moments.Z));
            return largest - (sum - largest) <= TriangleTolerance * largest
                ? moments
                : throw Guard.Refused("principal", moments, "no moment can exceed the sum of the other two");
        }
    }
}
