using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>Divides a body's time where its effects begin and end, and binds each sum of effects into one type.</summary>
    internal sealed class StretchBuilder<TIntegrator> where TIntegrator : struct, IIntegrator
    {
        // more effects than these share one type, so that no scene can make the runtime compile without end
        private const int MostTyped = 6;

        private readonly List<PushEffect> _pushes = new List<PushEffect>();
        private readonly long _end;
        private readonly Coasting _coasting;

        private StretchBuilder(BodyDescription body, TimeSteps steps, long first, long end)
        {
            _end = end;
            _coasting = Coasting.Free;
            foreach (Effect effect in body.Effects)
            {
                if (steps.FirstAt(effect.From) > first || steps.FirstAt(effect.To) <= first)
                    continue;

                if (effect is CoastEffect coast)
                    coast.AddTo(ref _coasting);
                else
                    _pushes.Add((PushEffect)effect);
            }
        }

        /// <summary>The stretches of a body, one after another, from step 0 to the last.</summary>
        public static Stretch<TIntegrator>[] Divide(BodyDescription body, TimeSteps steps)
        {
            SortedSet<long> cuts = new SortedSet<long> { 0, steps.Count };
            foreach (Effect effect in body.Effects)
            {
                cuts.Add(steps.FirstAt(effect.From));
                cuts.Add(steps.FirstAt(effect.To));
            }

            long[] at = new long[cuts.Count];
            cuts.CopyTo(at);
            Stretch<TIntegrator>[] stretches = new Stretch<TIntegrator>[at.Length - 1];
            for (int i = 0; i < stretches.Length; i++)
                stretches[i] = new StretchBuilder<TIntegrator>(body, steps, at[i], at[i + 1]).Bind(default(Nothing), 0);

            return stretches;
        }

        /// <summary>Goes on with a sum that holds all pushes before the next.</summary>
        public Stretch<TIntegrator> Bind<TSum>(TSum sum, int next) where TSum : struct, IPush
        {
            if (next == _pushes.Count)
                return new Stretch<TIntegrator, TSum>(_end, _coasting, sum);

            if (next < MostTyped)
                return _pushes[next].Join(sum, this, next + 1);

            IPush[] rest = new IPush[_pushes.Count - next];
            for (int i = 0; i < rest.Length; i++)
                rest[i] = _pushes[next + i].Push;

            return Bind(new Both<TSum, Many>(sum, new Many(rest)), _pushes.Count);
        }
    }
}
