#if NET
using System;
using System.Linq;
using System.Numerics;
using System.Runtime.CompilerServices;
using Lanes = System.Numerics.Vector<double>;

namespace RigidBodyDynamics
{
    /// <summary>An integrator of the bodies in a set of columns, as many at once as a vector has lanes.</summary>
    internal interface ILaneRule : ICrowdRule
    {
        /// <summary>The bodies of the crowd.</summary>
        Columns Bodies { get; }

        /// <summary>Computes the states of bodies.</summary>
        void Show(in Group bodies, out GroupState seen);
    }

    /// <summary><see cref="BodyState"/> of several bodies.</summary>
    internal struct GroupState
    {
        public VectorLanes Position;
        public QuaternionLanes Orientation;
        public VectorLanes Velocity, AngularVelocity;
    }

    /// <summary>A crowd in columns of numbers, neighbours in lanes. Work on a single body is done by its own integrator.</summary>
    internal abstract class LaneCrowd<TBody, TLanes> : CrowdOf<TBody>
        where TBody : struct, IIntegrator
        where TLanes : struct, ILaneRule
    {
        private readonly TLanes _lanes;
        private readonly Columns _now, _kept;
        // holds what all bodies share
        private readonly TBody _one;
        // the columns of the state, without those that the integrator keeps beside it
        private readonly int[] _seen;

        protected LaneCrowd(BodyDescription body, TLanes lanes)
        {
            _lanes = lanes;
            _lanes.Start(new Beginning(body));
            _one = default(TBody);
            _one.Start(new Beginning(body));
            _now = lanes.Bodies;
            _kept = new Columns(_now.Count, areRows: true);
            _seen = Seen();
        }

        public override int Width => Lanes.Count;

        public override void Reserve(int capacity)
        {
            _now.Reserve(capacity);
            _kept.Reserve(capacity);
        }

        public override void Start(int place, BodyDescription body)
        {
            TBody one = default(TBody);
            one.Start(new Beginning(body));
            In(place, ref one);
        }

        public override void Move(int from, int to)
        {
            _now.Move(from, to);
            _kept.Move(from, to);
        }

        public override BodyState StateOf(int place) => One(place, isAll: false).State;

        [MethodImpl(Kernel.Compiled)]
        public override bool Read(int from, int to, Places places, BodyState[] states)
        {
            TLanes lanes = _lanes;
            Lanes squares = Lanes.Zero;
            for (int i = from; i < to; i += Lanes.Count)
            {
                lanes.Show(_now.From(i, i + Lanes.Count).At(0), out GroupState seen);
                if (i < Whole(from, to))
                {
                    squares += VectorLanes.Dot(seen.Position, seen.Position) + seen.Orientation.LengthSquared
                        + (VectorLanes.Dot(seen.Velocity, seen.Velocity) + VectorLanes.Dot(seen.AngularVelocity, seen.AngularVelocity));
                }

                for (int lane = 0; lane < Lanes.Count && i + lane < to; lane++)
                    Write(ref Unsafe.Add(ref Unsafe.As<GroupState, double>(ref seen), lane), ref states[places[i + lane].Index]);
            }

            return FirstLost(Guard.IsFinite(Vector.Sum(squares)) ? Whole(from, to) : from, to) < 0;
        }

        /// <summary>
        /// A sum of squares is finite only if every number is: so all bodies are tested together, column by column, and one by one
        /// only where the sum is not finite.
        /// </summary>
        public override int FirstLost(int from, int to)
        {
            for (int i = AreFinite(from, Whole(from, to)) ? Whole(from, to) : from; i < to; i++)
            {
                if (!One(i, isAll: false).IsFinite)
                    return i;
            }

            return -1;
        }

        // the columns of a body say for which step length it is prepared
        public override void Forget(int from, int to) { }

        public override void Keep(int from, int to) => _now.CopyTo(_kept, from, to);

        public override void Return(int from, int to) => _kept.CopyTo(_now, from, to);

        public override void Leap(int from, int to, DoubleDouble time, in Coasting coasting)
        {
            Leap leap = default(Leap);
            Coasting over = coasting;
            over.Rest = time.Low;
            Return(from, to);
            for (int i = from; i < to; i++)
            {
                TBody one = Out(i);
                one.Prepare(time.High, over);
                one.Step(new Instant(0, 0), ref leap);
                In(i, ref one);
            }
        }

        public override object Save()
        {
            Columns[] saved = { new Columns(_now.Count), new Columns(_now.Count, areRows: true) };
            saved[0].CopyFrom(_now);
            saved[1].CopyFrom(_kept);
            return saved;
        }

        public override void Restore(object saved)
        {
            _now.CopyFrom(((Columns[])saved)[0]);
            _kept.CopyFrom(((Columns[])saved)[1]);
        }

        public override Stepper NewStepper(BodyPlan plan) => new Stepper<TLanes>(plan, _lanes);

        protected override TBody Out(int place) => One(place, isAll: true);

        protected override TBody Kept(int place)
        {
            TBody one = _one;
            Carry(ref one, _kept.Row(place, isOut: false), isAll: true);
            return one;
        }

        protected override void In(int place, ref TBody body) => Carry(ref body, _now.Row(place, isOut: true), isAll: true);

        /// <summary>Copies what changes in a body to its row or back: all of it, or only its state.</summary>
        protected abstract void Carry(ref TBody body, Row row, bool isAll);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Write(ref double seen, ref BodyState state)
        {
            state.Position = new Vector3d(Number(ref seen, 0), Number(ref seen, 1), Number(ref seen, 2));
            state.Orientation = new Quaterniond(Number(ref seen, 3), Number(ref seen, 4), Number(ref seen, 5), Number(ref seen, 6));
            state.Velocity = new Vector3d(Number(ref seen, 7), Number(ref seen, 8), Number(ref seen, 9));
            state.AngularVelocity = new Vector3d(Number(ref seen, 10), Number(ref seen, 11), Number(ref seen, 12));
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static double Number(ref double first, int number) => Unsafe.Add(ref first, number * Lanes.Count);

        /// <summary>The end of the last group without an empty place, whose numbers are undefined.</summary>
        private static int Whole(int from, int to) => to - (to - from) % Lanes.Count;

        [MethodImpl(Kernel.Compiled)]
        private bool AreFinite(int from, int to)
        {
            Lanes squares = Lanes.Zero;
            for (int i = from; i < to; i += Lanes.Count)
            {
                Group group = _now.From(i, i + Lanes.Count).At(0);
                // summed separately for each group, so that the processor need not wait for the sum of the last one
                Lanes ofGroup = Lanes.Zero;
                foreach (int column in _seen)
                    ofGroup += group[column] * group[column];

                squares += ofGroup;
            }

            return Guard.IsFinite(Vector.Sum(squares));
        }

        /// <summary>The columns that a body writes when its state is read.</summary>
        private int[] Seen()
        {
            double[] probe = new double[_now.Count];
            Array.Fill(probe, double.NaN);
            TBody one = _one;
            Carry(ref one, new Row(probe, 1, isOut: true), isAll: false);
            return Enumerable.Range(0, probe.Length).Where(column => !double.IsNaN(probe[column])).ToArray();
        }

        private TBody One(int place, bool isAll)
        {
            TBody one = _one;
            Carry(ref one, _now.Row(place, isOut: false), isAll);
            return one;
        }
    }
}
#endif
