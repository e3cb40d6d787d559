#if NET
using System;
using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>A crowd whose bodies share one integrator: work on a single body is done by that struct.</summary>
    internal abstract class CrowdOf<TBody> : Crowd where TBody : struct, IIntegrator
    {
        private readonly List<TBody> _aside = new List<TBody>();
        private Stretch<TBody>[] _loaded, _unloaded;

        public override bool HasClosedForm(int place, in Coasting coasting)
        {
            // the step length does not matter here
            TBody body = Out(place);
            body.Prepare(1, coasting);
            return body.HasClosedForm;
        }

        public override bool Push(Mover mover, int place, in Wrench impulse)
        {
            TBody body = Out(place);
            if (!body.IsFinite)
                return false;

            mover.Push(ref body, impulse);
            In(place, ref body);
            return true;
        }

        public override bool StepAside(Mover mover, int stretch, int place, long step, bool isLoaded)
        {
            TBody body = Out(place);
            BodyPlan plan = mover.Plan;
            Stretch<TBody>[] stretches = isLoaded
                ? _loaded = _loaded ?? StretchBuilder<TBody>.Bind(plan, isWatched: false, loaded: mover)
                : _unloaded = _unloaded ?? StretchBuilder<TBody>.Bind(plan, isWatched: false);
            stretches[stretch].Forget();
            try
            {
                if (plan.Stretches[stretch].GivesAt(step))
                    mover.Give(ref body, plan.Stretches[stretch]);

                stretches[stretch].Run(ref body, plan.Steps, step, step + 1);
            }
            catch (Exception)
            {
                // the exception of an effect; the effect is evaluated again to name it
                return false;
            }

            _aside.Add(body);
            return body.IsFinite;
        }

        public override void TakeBack(int aside, int place)
        {
            TBody body = _aside[aside];
            In(place, ref body);
        }

        public override void ForgetAside() => _aside.Clear();

        public override Exception Blame(BodyPlan plan, int stretch, int place, Body handle, long step, Mover aside = null, bool isLoaded = false)
        {
            TBody body = Out(place);
            try
            {
                if (aside != null && plan.Stretches[stretch].GivesAt(step))
                    aside.Give(ref body, plan.Stretches[stretch]);

                StretchBuilder<TBody>.Bind(plan, isWatched: true, loaded: isLoaded ? aside : null)[stretch].Run(ref body, plan.Steps, step, step + 1);
                return body.IsFinite ? null : new StateOverflowException(plan, step, handle, isLoaded);
            }
            catch (BrokenEffectException broken)
            {
                return new BrokenEffectException(broken, handle);
            }
        }

        public override LoneMover Alone(BodyPlan plan, Clock clock, int place, long since, int keptIn, int stretch, bool coasts) =>
            new Mover<TBody>(plan, clock, Out(place), Kept(place), since, keptIn, stretch, coasts);

        /// <summary>The present state of a body, as its integrator's struct.</summary>
        protected abstract TBody Out(int place);

        /// <summary>The stored state of a body.</summary>
        protected abstract TBody Kept(int place);

        /// <summary>Writes a body, without changing the struct.</summary>
        protected abstract void In(int place, ref TBody body);

        /// <summary>Makes an array a copy of another.</summary>
        protected static void Copy<T>(T[] from, ref T[] to)
        {
            if (to.Length != from.Length)
                to = new T[from.Length];

            Array.Copy(from, to, from.Length);
        }
    }
}
#endif
