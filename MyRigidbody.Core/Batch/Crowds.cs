#if NET
namespace RigidBodyDynamics
{
    /// <summary>Chooses the storage of bodies: lanes where the integrator supports them and no push reads a state.</summary>
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

    /// <summary>An integrator that can be computed in lanes.</summary>
    internal interface IRuleInLanes
    {
        /// <summary>A crowd in lanes; null where this kind of body has none.</summary>
        Crowd InLanes(BodyDescription body);
    }
}
#endif
