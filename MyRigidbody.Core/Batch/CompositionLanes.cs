#if NET
using System;
using System.Runtime.CompilerServices;
using Lanes = System.Numerics.Vector<double>;

namespace RigidBodyDynamics
{
    /// <summary>
    /// <see cref="Composition{TTop, TScheme}"/> for several bodies at once, with pushes that read only the time:
    /// they give the same to all bodies.
    /// </summary>
    internal struct CompositionLanes<TTop, TScheme> : ILaneRule
        where TTop : struct, ITopLanes
        where TScheme : struct, IScheme
    {
        private const int X = CompositionLanes.X, V = CompositionLanes.V, XLost = CompositionLanes.XLost, VLost = CompositionLanes.VLost;

        private TTop _top;
        private MassProperties _mass;
        private bool _canMove, _decaysPerStep;
        private double _dt;
        private Coasting _coasting;
        private Decay _perStep;
        private Drift _whole;
        private int _from, _to;

        public CompositionLanes(Columns bodies) : this() => Bodies = bodies;

        public Columns Bodies { get; }

        public BodyState State => throw new NotSupportedException();

        public bool IsAsleep => false;

        public bool IsFinite => true;

        public bool HasClosedForm => false;

        public void Start(in Beginning body)
        {
            _mass = body.Mass;
            _canMove = body.CanMove;
            _top = default(TTop);
            _top.Start(body.Mass);
        }

        public void Push(in Wrench impulse) => throw new NotSupportedException();

        public void Select(int from, int to)
        {
            _from = from;
            _to = to;
        }

        public void Prepare(double duration, in Coasting coasting)
        {
            _dt = duration;
            _coasting = coasting;
            _whole = new Drift(coasting, duration);
            _perStep = Decay.To(coasting.AngularFactorPerStep);
            _decaysPerStep = coasting.LinearFactorPerStep != 1 || coasting.AngularFactorPerStep != 1;
        }

        public void Step<TPush>(in Instant now, ref TPush push) where TPush : struct, IPush
        {
            EffectTraits does = push.Traits & (EffectTraits.Moves | EffectTraits.Turns);
            if (does == 0)
            {
                Coast();
                return;
            }

            TScheme scheme = default(TScheme);
            double[] kicks = scheme.Kicks, drifts = scheme.Drifts;
            Span<SharedImpulse> impulses = stackalloc SharedImpulse[kicks.Length];
            Span<Stage> stages = stackalloc Stage[drifts.Length];
            Instant at = new Instant(now.Step, now.Time, scheme.HoldsTime);
            for (int i = 0; i < kicks.Length; i++)
            {
                double kick = kicks[i] * _dt, length = i < drifts.Length ? drifts[i] * _dt : 0;
                BodyState unread = default(BodyState);
                Wrench given = default(Wrench);
                push.Over(at, kick, unread, _mass, ref given);
                impulses[i] = new SharedImpulse(_canMove ? does : does & ~EffectTraits.Moves, given, _mass.InverseMass, _top.FromWorld(given.Torque), _top.FromBody(given.BodyTorque));
                if (i < drifts.Length)
                    stages[i] = new Stage(length, length == _dt ? _whole : new Drift(_coasting, length));

                at = at.Later(scheme.HoldsTime ? length : kick);
            }

            Compose(impulses, stages);
        }

        [MethodImpl(Kernel.Compiled)]
        public void Show(in Group bodies, out GroupState seen)
        {
            VectorLanes x = new VectorLanes(bodies, X);
            _top.Show(bodies, out seen.Orientation, out seen.AngularVelocity);
            seen.Position = _mass.CenterOfMass.IsZero ? x : x - seen.Orientation.Rotate(new VectorLanes(_mass.CenterOfMass));
            seen.Velocity = new VectorLanes(bodies, V);
        }

        private void Coast()
        {
            for (int i = _from, end; i < _to; i = end)
            {
                Block bodies = Bodies.From(i, end = Math.Min(_to, Columns.EndOfBlock(i)));
                Advance(bodies, _dt, _whole);
                if (_decaysPerStep)
                    Decelerate(bodies);
            }
        }

        private void Compose(ReadOnlySpan<SharedImpulse> impulses, ReadOnlySpan<Stage> stages)
        {
            for (int i = _from, end; i < _to; i = end)
            {
                Block bodies = Bodies.From(i, end = Math.Min(_to, Columns.EndOfBlock(i)));
                for (int k = 0; k < stages.Length; k++)
                {
                    Kick(bodies, impulses[k]);
                    Advance(bodies, stages[k].Length, stages[k].Drift);
                }

                Kick(bodies, impulses[stages.Length]);
                if (_decaysPerStep)
                    Decelerate(bodies);
            }
        }

        [MethodImpl(Kernel.Compiled)]
        private void Advance(in Block bodies, double length, in Drift drift)
        {
            for (int i = 0; drift.IsFree && i < bodies.Rows; i += Lanes.Count)
                Add(bodies.At(i), X, XLost, length * new VectorLanes(bodies.At(i), V));

            for (int i = 0; !drift.IsFree && _canMove && i < bodies.Rows; i += Lanes.Count)
            {
                Group group = bodies.At(i);
                VectorLanes x = new VectorLanes(group, X), xLost = new VectorLanes(group, XLost);
                VectorLanes v = new VectorLanes(group, V), vLost = new VectorLanes(group, VLost);
                drift.Move(ref x, ref xLost, ref v, ref vLost);
                x.Write(group, X);
                xLost.Write(group, XLost);
                v.Write(group, V);
                vLost.Write(group, VLost);
            }

            _top.Advance(bodies, drift.IsFree ? length : drift.TurningTime);
            Damp(bodies, drift.AngularDecay);
        }

        [MethodImpl(Kernel.Compiled)]
        private void Kick(in Block bodies, in SharedImpulse impulse)
        {
            for (int i = 0; (impulse.Does & EffectTraits.Moves) != 0 && i < bodies.Rows; i += Lanes.Count)
                Add(bodies.At(i), V, VLost, new VectorLanes(impulse.Velocity));

            if ((impulse.Does & EffectTraits.Turns) == 0)
                return;

            bodies.ReadyFor = double.NaN;
            for (int i = 0; i < bodies.Rows; i += Lanes.Count)
                _top.Kick(bodies.At(i), impulse);
        }

        [MethodImpl(Kernel.Compiled)]
        private void Damp(in Block bodies, in Decay decay)
        {
            if (decay.IsNone)
                return;

            bodies.ReadyFor = double.NaN;
            for (int i = 0; i < bodies.Rows; i += Lanes.Count)
                _top.Damp(bodies.At(i), decay);
        }

        [MethodImpl(Kernel.Compiled)]
        private void Decelerate(in Block bodies)
        {
            for (int i = 0; i < bodies.Rows; i += Lanes.Count)
            {
                Group group = bodies.At(i);
                Decay.By(_coasting.LinearFactorPerStep, new VectorLanes(group, V)).Write(group, V);
                Decay.By(_coasting.LinearFactorPerStep, new VectorLanes(group, VLost)).Write(group, VLost);
            }

            Damp(bodies, _perStep);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Add(in Group bodies, int sum, int lost, VectorLanes add)
        {
            VectorLanes all = new VectorLanes(bodies, sum), away = new VectorLanes(bodies, lost);
            RunningSum.Add(ref all, ref away, add);
            all.Write(bodies, sum);
            away.Write(bodies, lost);
        }
    }

    /// <summary>The columns of every body of such a crowd, whatever its top; the columns of the top follow.</summary>
    internal static class CompositionLanes
    {
        public const int X = 0, V = 3, XLost = 6, VLost = 9, Columns = 12;
    }

    internal partial struct Composition<TTop, TScheme> : IRuleInLanes
    {
        public Crowd InLanes(BodyDescription body) => default(TTop) is IHasLanes top ? top.InLanes<TScheme>(body) : null;

        /// <summary>A crowd of bodies whose kind of top can be computed in lanes.</summary>
        internal sealed class InColumns<TCarried, TLanes> : LaneCrowd<Composition<TCarried, TScheme>, CompositionLanes<TLanes, TScheme>>
            where TCarried : struct, IFreeTop, IHasLanes
            where TLanes : struct, ITopLanes
        {
            public InColumns(BodyDescription body)
                : base(body, new CompositionLanes<TLanes, TScheme>(new Columns(default(TLanes).Columns))) { }

            protected override void Carry(ref Composition<TCarried, TScheme> body, Row row, bool isAll)
            {
                row.Carry(CompositionLanes.X, ref body._x);
                row.Carry(CompositionLanes.V, ref body._v);
                body._top.Carry(row, isAll);
                if (!isAll)
                    return;

                row.Carry(CompositionLanes.XLost, ref body._xLost);
                row.Carry(CompositionLanes.VLost, ref body._vLost);
            }
        }
    }

    /// <summary>A length of free motion, s, and its flow.</summary>
    internal readonly struct Stage
    {
        public readonly double Length;
        public readonly Drift Drift;

        public Stage(double length, in Drift drift)
        {
            Length = length;
            Drift = drift;
        }
    }

    /// <summary>The impulse that pushes give to every body alike.</summary>
    internal readonly struct SharedImpulse
    {
        public readonly EffectTraits Does;

        /// <summary>The change of the velocity, m/s.</summary>
        public readonly Vector3d Velocity;

        /// <summary>Angular momentum in world axes and in body axes, N m s, each in the axis order of the top.</summary>
        public readonly Vector3d World, Body;

        public readonly bool HasWorld, HasBody;

        public SharedImpulse(EffectTraits does, in Wrench given, double inverseMass, Vector3d inWorld, Vector3d inOwnAxes)
        {
            HasWorld = !given.Torque.IsZero;
            HasBody = !given.BodyTorque.IsZero;
            Does = does & ~((given.Force.IsZero ? EffectTraits.Moves : 0) | (HasWorld || HasBody ? 0 : EffectTraits.Turns));
            Velocity = inverseMass * given.Force;
            World = inWorld;
            Body = HasBody ? inOwnAxes : given.BodyTorque;
        }
    }
}
#endif
