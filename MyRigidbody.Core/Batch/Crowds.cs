#if NET
namespace RigidBodyDynamics
{
    /// <summary>Chooses how bodies are stored: in lanes where their rule has such a form and no push reads their states.</summary>
    internal static class Crowds
    {
        internal const EffectTraits ReadsState =
            EffectTraits.ReadsPosition | EffectTraits.ReadsOrientation | EffectTraits.ReadsVelocity | EffectTraits.ReadsAngularVelocity;

        public static Crowd Choose(BodyPlan plan)
        {
            bool readsState = false;
            foreach (StretchPlan stretch in plan.Stretches)
                readsState |= (stretch.Does & ReadsState) != 0;

            return plan.Rule.Use(plan.Body, new Maker(plan.Body, !readsState));
        }

        private sealed class Maker : IRuleUse<Crowd>
        {
            private readonly BodyDescription _body;
            private readonly bool _mayUseLanes;

            public Maker(BodyDescription body, bool mayUseLanes)
            {
                _body = body;
                _mayUseLanes = mayUseLanes;
            }

            public Crowd With<TIntegrator>() where TIntegrator : struct, IIntegrator
            {
                Crowd lanes = _mayUseLanes && default(TIntegrator) is IRuleInLanes rule ? rule.InLanes(_body) : null;
                return lanes ?? new StructCrowd<TIntegrator>();
            }
        }
    }

    /// <summary>A rule that has a form for several bodies at once.</summary>
    internal interface IRuleInLanes
    {
        /// <summary>A crowd in lanes; null where a body of this kind has none.</summary>
        Crowd InLanes(BodyDescription body);
    }
}
#endif
