#if NET
namespace RigidBodyDynamics
{
    /// <summary><see cref="IFreeTop"/> for several bodies at once, whose numbers are in columns from a row on.</summary>
    internal interface ITopLanes
    {
        /// <summary>The number of columns of a body.</summary>
        int Columns { get; }

        void Start(MassProperties mass);

        /// <summary>A vector in body axes, in the axes of the top.</summary>
        Vector3d FromBody(Vector3d v);

        /// <summary>A vector in world axes, in the axis order of the top.</summary>
        Vector3d FromWorld(Vector3d v);

        /// <summary>Rotates the bodies of a block.</summary>
        void Advance(in Block bodies, double time);

        void Kick(in Group bodies, in SharedImpulse impulse);

        void Damp(in Group bodies, in Decay decay);

        /// <summary>Orientations and angular velocities, to the bits of <see cref="IFreeTop.Show"/>.</summary>
        void Show(in Group bodies, out QuaternionLanes orientation, out VectorLanes angularVelocity);
    }

    /// <summary>A top that can be computed in lanes.</summary>
    internal interface IHasLanes
    {
        Crowd InLanes<TScheme>(BodyDescription body) where TScheme : struct, IScheme;

        /// <summary>Copies what changes in it to its row or back: all of it, or only its orientation and angular velocity.</summary>
        void Carry(Row row, bool isAll);
    }

    internal partial struct HeldTop : IHasLanes
    {
        public Crowd InLanes<TScheme>(BodyDescription body) where TScheme : struct, IScheme =>
            new Composition<HeldTop, TScheme>.InColumns<HeldTop, HeldLanes>(body);

        public void Carry(Row row, bool isAll)
        {
            Quaterniond q = Orientation;
            row.Carry(CompositionLanes.Columns, ref q);
            Orientation = q;
        }
    }

    /// <summary>Bodies that do not rotate.</summary>
    internal struct HeldLanes : ITopLanes
    {
        public int Columns => CompositionLanes.Columns + 4;

        public void Start(MassProperties mass) { }

        public Vector3d FromBody(Vector3d v) => v;

        public Vector3d FromWorld(Vector3d v) => v;

        public void Advance(in Block bodies, double time) { }

        public void Kick(in Group bodies, in SharedImpulse impulse) { }

        public void Damp(in Group bodies, in Decay decay) { }

        public void Show(in Group bodies, out QuaternionLanes orientation, out VectorLanes angularVelocity)
        {
            orientation = new QuaternionLanes(bodies, CompositionLanes.Columns);
            angularVelocity = new VectorLanes(Vector3d.Zero);
        }
    }
}
#endif
