using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>A body composed of others: masses add, and moments add by Steiner's parallel-axis rule.</summary>
    public sealed class Compound
    {
        private readonly List<Part> _parts = new List<Part>();

        /// <summary>Adds a part; its origin has a position and its axes an orientation in the compound's frame.</summary>
        /// <returns>This compound, so that parts can be listed.</returns>
        public Compound With(MassProperties part, Vector3d position, Quaterniond orientation)
        {
            Guard.NotNull(part, nameof(part));
            Guard.Finite(position, nameof(position));
            Quaterniond turn = Guard.Turn(orientation, nameof(orientation)).Normalized;
            _parts.Add(new Part
            {
                Mass = part.Mass,
                Center = position + turn.Rotate(part.CenterOfMass),
                Inertia = part.Inertia.RotatedBy(Matrix3.Of(turn)),
            });
            return this;
        }

        /// <summary>Adds a part whose axes are those of the compound.</summary>
        public Compound With(MassProperties part, Vector3d position) => With(part, position, Quaterniond.Identity);

        /// <summary>The whole, about its common centre of mass: I = Σ (I_part + m (d·d 1 − d dᵀ)).</summary>
        public MassProperties ToMassProperties()
        {
            double mass = 0;
            Vector3d moment = Vector3d.Zero;
            foreach (Part part in _parts)
            {
                mass += part.Mass;
                moment += part.Mass * part.Center;
            }

            Guard.Positive(mass, "mass of all parts");
            Vector3d center = moment / mass;
            SymmetricMatrix3 inertia = default(SymmetricMatrix3);
            foreach (Part part in _parts)
            {
                Vector3d d = part.Center - center;
                inertia += part.Inertia + part.Mass * SymmetricMatrix3.OfPoint(d);
            }

            return MassProperties.FromTensor(mass, inertia, center);
        }

        private struct Part
        {
            public double Mass;
            public Vector3d Center;
            public SymmetricMatrix3 Inertia;
        }
    }
}
