#if NET
using System;

namespace RigidBodyDynamics
{
    /// <summary>A crowd for any integrator and any push: an array of the integrator's own structs.</summary>
    internal sealed class StructCrowd<TIntegrator> : CrowdOf<TIntegrator> where TIntegrator : struct, IIntegrator
    {
        private TIntegrator[] _now = Array.Empty<TIntegrator>(), _kept = Array.Empty<TIntegrator>();
        private double[] _preparedFor = Array.Empty<double>();

        public override int Width => 1;

        public override void Reserve(int capacity)
        {
            Array.Resize(ref _now, capacity);
            Array.Resize(ref _kept, capacity);
            Array.Resize(ref _preparedFor, capacity);
        }

        public override void Start(int place, BodyDescription body)
        {
            _now[place] = default(TIntegrator);
            _now[place].Start(new Beginning(body));
            _preparedFor[place] = 0;
        }

        public override void Move(int from, int to)
        {
            _now[to] = _now[from];
            _kept[to] = _kept[from];
            _preparedFor[to] = _preparedFor[from];
        }

        public override BodyState StateOf(int place) => _now[place].State;

        public override int FirstLost(int from, int to)
        {
            for (int i = from; i < to; i++)
            {
                if (!_now[i].IsFinite)
                    return i;
            }

            return -1;
        }

        public override bool IsAsleep(int place) => _now[place].IsAsleep;

        public override void Forget(int from, int to) => Array.Clear(_preparedFor, from, to - from);

        public override void Keep(int from, int to) => Array.Copy(_now, from, _kept, from, to - from);

        public override void Return(int from, int to)
        {
            Array.Copy(_kept, from, _now, from, to - from);
            Forget(from, to);
        }

        public override void Leap(int from, int to, DoubleDouble time, in Coasting coasting)
        {
            Leap leap = default(Leap);
            Coasting over = coasting;
            over.Rest = time.Low;
            Return(from, to);
            for (int i = from; i < to; i++)
            {
                _now[i].Prepare(time.High, over);
                _now[i].Step(new Instant(0, 0), ref leap);
            }
        }

        public override object Save()
        {
            Saved saved = new Saved();
            Copy(_now, ref saved.Now);
            Copy(_kept, ref saved.Kept);
            return saved;
        }

        public override void Restore(object saved)
        {
            Copy(((Saved)saved).Now, ref _now);
            Copy(((Saved)saved).Kept, ref _kept);
            _preparedFor = new double[_now.Length];
        }

        public override Stepper NewStepper(BodyPlan plan) => new Stepper<EachInTurn>(plan, new EachInTurn(this));

        protected override TIntegrator Out(int place) => _now[place];

        protected override TIntegrator Kept(int place) => _kept[place];

        protected override void In(int place, ref TIntegrator body)
        {
            _now[place] = body;
            _preparedFor[place] = 0;
        }

        private sealed class Saved
        {
            public TIntegrator[] Now = Array.Empty<TIntegrator>(), Kept = Array.Empty<TIntegrator>();
        }

        /// <summary>The same step for one body after another.</summary>
        private struct EachInTurn : ICrowdRule
        {
            private readonly StructCrowd<TIntegrator> _crowd;
            private int _from, _to;
            private double _duration;
            private Coasting _coasting;

            public EachInTurn(StructCrowd<TIntegrator> crowd) : this() => _crowd = crowd;

            public BodyState State => throw new NotSupportedException();

            public bool IsAsleep => false;

            public bool IsFinite => true;

            public bool HasClosedForm => false;

            public void Start(in Beginning body) { }

            public void Push(in Wrench impulse) => throw new NotSupportedException();

            public void Select(int from, int to)
            {
                _from = from;
                _to = to;
            }

            public void Prepare(double duration, in Coasting coasting)
            {
                _duration = duration;
                _coasting = coasting;
            }

            public void Step<TPush>(in Instant now, ref TPush push) where TPush : struct, IPush
            {
                TIntegrator[] bodies = _crowd._now;
                double[] preparedFor = _crowd._preparedFor;
                for (int i = _from; i < _to; i++)
                {
                    if (preparedFor[i] != _duration)
                    {
                        bodies[i].Prepare(_duration, _coasting);
                        preparedFor[i] = _duration;
                    }

                    bodies[i].Step(now, ref push);
                }
            }
        }
    }
}
#endif
