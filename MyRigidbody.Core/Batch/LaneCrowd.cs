#if NET
using Lanes = System.Numerics.Vector<double>;

namespace RigidBodyDynamics
{
    /// <summary>A rule for the bodies in a set of columns, as many at once as a vector has lanes.</summary>
    internal interface ILaneRule : ICrowdRule
    {
        /// <summary>The bodies of the crowd.</summary>
        Columns Bodies { get; }
    }

    /// <summary>A crowd in columns of numbers, neighbours in lanes. What a single body wants is done by its own rule.</summary>
    internal abstract class LaneCrowd<TBody, TLanes> : Crowd
        where TBody : struct, IIntegrator
        where TLanes : struct, ILaneRule
    {
        private readonly TLanes _lanes;
        private readonly Columns _now, _kept;
        // knows what all bodies share
        private readonly TBody _one;

        protected LaneCrowd(BodyDescription body, TLanes lanes)
        {
            _lanes = lanes;
            _lanes.Start(body);
            _one = default(TBody);
            _one.Start(body);
            _now = lanes.Bodies;
            _kept = new Columns(_now.Count);
        }

        public override int Width => Lanes.Count;

        public override void Reserve(int capacity, bool isKept)
        {
            _now.Reserve(capacity);
            if (isKept)
                _kept.Reserve(capacity);
        }

        public override void Start(int place, BodyDescription body)
        {
            TBody one = default(TBody);
            one.Start(body);
            Carry(ref one, _now.Row(place, isOut: true), isAll: true);
        }

        public override void Move(int from, int to)
        {
            _now.Move(from, to);
            if (_kept.Rows > 0)
                _kept.Move(from, to);
        }

        public override BodyState StateOf(int place) => One(place, isAll: false).State;

        // what a body is prepared for is said in its own columns
        public override void Forget() { }

        public override bool HasClosedForm(int place, in Coasting coasting)
        {
            TBody one = One(place, isAll: true);
            one.Prepare(1, coasting);
            return one.HasClosedForm;
        }

        public override void Keep(int from, int to) => _now.CopyTo(_kept, from, to);

        public override void Leap(int from, int to, DoubleDouble time, in Coasting coasting)
        {
            Leap leap = default(Leap);
            Coasting over = coasting;
            over.Rest = time.Low;
            _kept.CopyTo(_now, from, to);
            for (int i = from; i < to; i++)
            {
                TBody one = One(i, isAll: true);
                one.Prepare(time.High, over);
                one.Step(new Instant(0, 0), ref leap);
                Carry(ref one, _now.Row(i, isOut: true), isAll: true);
            }
        }

        public override Stepper NewStepper(BodyPlan plan) => new Stepper<TLanes>(plan, _lanes);

        /// <summary>Carries what changes in a body to its row or from there: all of it, or what one sees of it.</summary>
        protected abstract void Carry(ref TBody body, Row row, bool isAll);

        private TBody One(int place, bool isAll)
        {
            TBody one = _one;
            Carry(ref one, _now.Row(place, isOut: false), isAll);
            return one;
        }
    }
}
#endif
