using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>Binds each sum of effects of a plan into one type.</summary>
    internal sealed class StretchBuilder<TIntegrator> where TIntegrator : struct, IIntegrator
    {
        // more pushes than these share one type, so that no scene can make the runtime compile without end
        private const int MostTyped = 6;

        // compiled ahead of time, a program has only the types that the compiler saw, and the number of sums of effects is unlimited
#if NET
        private static bool CanCompile => System.Runtime.CompilerServices.RuntimeFeature.IsDynamicCodeSupported;
#elif ENABLE_IL2CPP
        private static bool CanCompile => false;
#else
        private static bool CanCompile => true;
#endif

        private readonly BodyPlan _plan;
        private readonly StretchPlan _stretch;
        private readonly Mover _loaded;
        private readonly bool _isWatched;

        private StretchBuilder(BodyPlan plan, StretchPlan stretch, bool isWatched, Mover loaded)
        {
            _plan = plan;
            _stretch = stretch;
            _isWatched = isWatched;
            _loaded = loaded;
        }

        /// <summary>True where pushes act on the body of the integrator directly: without locks and with a constant mass.</summary>
        private bool IsPlain => _plan.Bearing == null && _stretch.MassCourse == null;

        /// <summary>The stretches of a body, one after another.</summary>
        /// <param name="plan">The plan of the body.</param>
        /// <param name="isWatched">True for stretches that find the push that is not finite.</param>
        /// <param name="loaded">The mover whose load acts, too; null for stretches without.</param>
        public static Stretch<TIntegrator>[] Bind(BodyPlan plan, bool isWatched, Mover loaded = null)
        {
            Stretch<TIntegrator>[] stretches = new Stretch<TIntegrator>[plan.Stretches.Count];
            for (int i = 0; i < stretches.Length; i++)
                stretches[i] = new StretchBuilder<TIntegrator>(plan, plan.Stretches[i], isWatched, loaded).Bind(default(Nothing), 0);

            return stretches;
        }

        /// <summary>Continues with a sum that contains all pushes before the next.</summary>
        public Stretch<TIntegrator> Bind<TSum>(TSum sum, int next) where TSum : struct, IPush
        {
            IReadOnlyList<PushEffect> pushes = _stretch.Pushes;
            IPush shedding = _stretch.MassCourse?.Shedding;
            if (next == pushes.Count && shedding == null && (IsPlain || _loaded == null))
                return End(sum);

            if (CanCompile && next < MostTyped && !_isWatched && IsPlain)
                return pushes[next].Join(sum, this, next + 1);

            List<IPush> rest = new List<IPush>();
            for (int i = next; i < pushes.Count; i++)
                rest.Add(_isWatched ? new Watched(pushes[i], _plan.Body) : pushes[i].Push);

            if (!IsPlain && _loaded != null)
                rest.Add(new Loaded(_loaded));

            if (_stretch.MassCourse != null)
                rest = rest.ConvertAll(_stretch.MassCourse.On);

            if (shedding != null)
                rest.Add(shedding);

            if (_plan.Bearing != null)
                rest = rest.ConvertAll(_plan.Bearing.On);

            return End(new Both<TSum, Many>(sum, new Many(rest.ToArray())));
        }

        private Stretch<TIntegrator> End<TSum>(TSum sum) where TSum : struct, IPush => _loaded == null || !IsPlain
            ? new Stretch<TIntegrator, TSum>(_stretch.End, _stretch.Coasting, sum)
            : (Stretch<TIntegrator>)new Stretch<TIntegrator, Both<TSum, Loaded>>(
                _stretch.End, _stretch.Coasting, new Both<TSum, Loaded>(sum, new Loaded(_loaded)));
    }
}
