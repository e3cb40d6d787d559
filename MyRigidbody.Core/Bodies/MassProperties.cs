using System;
using System.Globalization;

namespace RigidBodyDynamics
{
    /// <summary>Mass, inertia and centre of mass of a body. Immutable; bodies may share one.</summary>
    public sealed class MassProperties
    {
        // the moments of a real body obey I1 + I2 >= I3; sums over points violate it only by rounding
        private const double TriangleTolerance = 1e-9;

        private TopShape _shape;

        // least moment, as a part of the largest, of a tensor that is diagonalised: rounding errors of the largest moment are in all three
        private const double SmallestPart = 4e-15;

        private MassProperties(double mass, Vector3d moments, Quaterniond frame, SymmetricMatrix3 inertia, Vector3d center)
        {
            Mass = Guard.Positive(mass, nameof(mass));
            Guard.Positive(1 / mass, "1 / mass");
            PrincipalMoments = moments;
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
        /// Takes principal axes to body axes. Stored as given, so that an integrator in single precision can scale it to length 1 in
        /// its own arithmetic; all others use <c>PrincipalFrame.Normalized</c>.
        /// </summary>
        public Quaterniond PrincipalFrame { get; private set; }

        /// <summary>The inertia tensor in body axes, about the centre of mass, kg m²; the lab's I_ref.</summary>
        public SymmetricMatrix3 Inertia { get; private set; }

        /// <summary>Centre of mass in the body frame, m.</summary>
        public Vector3d CenterOfMass { get; private set; }

        /// <summary>True if all three moments are equal: a rotation about any axis continues unchanged.</summary>
        public bool IsIsotropic => PrincipalMoments.X == PrincipalMoments.Y && PrincipalMoments.Y == PrincipalMoments.Z;

        /// <summary>Constants of free rotation that depend on the moments alone; shared by all bodies with these properties.</summary>
        internal TopShape Shape => _shape ?? (_shape = new TopShape(PrincipalMoments, PrincipalFrame));

        /// <summary>A body with given principal moments.</summary>
        /// <param name="mass">kg, above zero.</param>
        /// <param name="moments">kg m², each above zero and none larger than the sum of the others.</param>
        /// <param name="frame">Takes principal axes to body axes; scaled to length 1 in use.</param>
        /// <param name="centerOfMass">In the body frame, m.</param>
        public static MassProperties FromPrincipal(double mass, Vector3d moments, Quaterniond frame, Vector3d centerOfMass)
        {
            Guard.Turn(frame, "frame");
            SymmetricMatrix3 diagonal = new SymmetricMatrix3(moments, Vector3d.Zero);
            SymmetricMatrix3 inertia = frame == Quaterniond.Identity
                ? diagonal
                : diagonal.RotatedBy(Matrix3.Of(frame.Normalized));
            return new MassProperties(mass, Possible(moments, frame, 0, moments), frame, inertia, centerOfMass);
        }

        /// <summary>A body with given principal moments along its own axes, about its origin.</summary>
        public static MassProperties FromPrincipal(double mass, Vector3d moments) =>
            FromPrincipal(mass, moments, Quaterniond.Identity, Vector3d.Zero);

        /// <summary>A body with a given tensor about its centre of mass, in body axes. Diagonalised here, once.</summary>
        public static MassProperties FromTensor(double mass, SymmetricMatrix3 inertia, Vector3d centerOfMass)
        {
            Guard.Finite(inertia.Diagonal, "inertia");
            Guard.Finite(inertia.OffDiagonal, "inertia");
            Vector3d moments = PrincipalAxes.Of(inertia, out Quaterniond frame);
            double rounding = inertia.OffDiagonal.IsZero ? 0 : SmallestPart;
            return new MassProperties(mass, Possible(moments, frame, rounding, "principal moments " + moments), frame, inertia, centerOfMass);
        }

        /// <summary>A body with a given tensor about the origin of its frame, in body axes, from which Steiner's m (d·d 1 − d dᵀ) of the centre of mass d is subtracted.</summary>
        public static MassProperties FromTensorAboutOrigin(double mass, SymmetricMatrix3 inertia, Vector3d centerOfMass) =>
            FromTensor(mass, inertia - Guard.Positive(mass, nameof(mass)) * SymmetricMatrix3.OfPoint(Guard.Finite(centerOfMass, nameof(centerOfMass))), centerOfMass);

        /// <summary>The same body with another centre of mass in the body frame.</summary>
        public MassProperties WithCenterOfMass(Vector3d centerOfMass) =>
            new MassProperties(Mass, PrincipalMoments, PrincipalFrame, Inertia, centerOfMass);

        /// <summary>The same body with mass and moments multiplied by a ratio.</summary>
        internal MassProperties Times(double ratio) => ((MassProperties)MemberwiseClone()).Become(this, ratio);

        /// <summary>Makes this, which must not be shared, another one multiplied by a ratio.</summary>
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

        /// <summary>
        /// The same body held at the origin of its frame, as a <see cref="HeavyTop"/> is: its inertia is the one about that point, greater
        /// by Steiner's term m (d·d 1 − d dᵀ) than about the centre of mass d, and the origin takes the place of the centre of mass.
        /// </summary>
        public MassProperties HeldAtOrigin()
        {
            SymmetricMatrix3 more = Mass * SymmetricMatrix3.OfPoint(PrincipalFrame.Normalized.RotateInverse(CenterOfMass));
            return more.OffDiagonal.IsZero
                ? FromPrincipal(Mass, PrincipalMoments + more.Diagonal, PrincipalFrame, Vector3d.Zero)
                : FromTensor(Mass, Inertia + Mass * SymmetricMatrix3.OfPoint(CenterOfMass), Vector3d.Zero);
        }

        /// <summary>
        /// The nearest moments that a body can have, where one exceeds the sum of the other two; else the same moments. Each changes
        /// in proportion to its uncertainty.
        /// </summary>
        public static Vector3d NearestPossible(Vector3d moments, Vector3d uncertainty)
        {
            Guard.Positive(moments, nameof(moments));
            Vector3d by = Guard.Positive(uncertainty, nameof(uncertainty));
            double excess = Excess(moments), part = excess / (by.X + by.Y + by.Z);
            double largest = Largest(moments);
            return excess <= 0 ? moments : new Vector3d(
                moments.X + (moments.X == largest ? -part : part) * by.X,
                moments.Y + (moments.Y == largest ? -part : part) * by.Y,
                moments.Z + (moments.Z == largest ? -part : part) * by.Z);
        }

        private static Vector3d Possible(Vector3d moments, Quaterniond frame, double rounding, object found)
        {
            double largest = Largest(moments), least = -Largest(-moments), middle = moments.X + moments.Y + moments.Z - largest - least;
            if (Math.Abs(least) <= rounding * largest && largest - middle <= TriangleTolerance * largest)
                throw Guard.Refused("principal", found, OnALine(moments, least, frame));

            Guard.Positive(moments, "principal");
            Guard.Finite(new Vector3d(1 / moments.X, 1 / moments.Y, 1 / moments.Z), "1 / principal");
            return Excess(moments) <= TriangleTolerance * largest
                ? moments
                : throw Guard.Refused("principal", found, "no moment can exceed the sum of the other two, and the nearest that do not are " + NearestPossible(moments, new Vector3d(1, 1, 1)));
        }

        private static double Largest(Vector3d v) => Math.Max(v.X, Math.Max(v.Y, v.Z));

        /// <summary>The largest moment minus the sum of the others.</summary>
        private static double Excess(Vector3d moments) => Largest(moments) - (moments.X + moments.Y + moments.Z - Largest(moments));

        private static string OnALine(Vector3d moments, double least, Quaterniond frame)
        {
            const double One = 1 - 1e-12;
            if (moments.IsZero)
                return "all points are one, so the inertia is zero";

            Vector3d axis = frame.Normalized.Rotate(
                moments.X == least ? new Vector3d(1, 0, 0) : moments.Y == least ? new Vector3d(0, 1, 0) : new Vector3d(0, 0, 1));
            string along = Math.Abs(axis.X) > One ? "x" : Math.Abs(axis.Y) > One ? "y" : Math.Abs(axis.Z) > One ? "z"
                : string.Format(CultureInfo.InvariantCulture, "({0:g6}, {1:g6}, {2:g6})", axis.X, axis.Y, axis.Z);
            return "all points lie on a line along " + along + ", so the inertia about it is zero";
        }
    }
}
