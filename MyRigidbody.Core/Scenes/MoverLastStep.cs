namespace RigidBodyDynamics
{
    /// <summary>Stores the last step of a body that is interpolated.</summary>
    internal sealed partial class Mover<TIntegrator>
    {
        private LastStep Remember()
        {
            CatchUp();
            long step = _clock.Step;
            if (Last != null && Last.Step == step)
                return Last;

            LastStep<TIntegrator> last = Last as LastStep<TIntegrator> ?? new LastStep<TIntegrator>();
            if (_now.IsDormant && _now.Anchored < step)
                last.Coasted(step, _clock.LastLength, _now.Motion, _stretches[_now.Stretch]);
            else if (_keptAt < step && HasCoasted(step))
                last.Coasted(step, _clock.LastLength, _now.Motion, _stretches[_before.Value.Stretch]);
            else if (_keptAt < step)
                last.Went(step, _clock.LastLength, Before(step), _now.Motion.State, Plan.Body.Mass.CenterOfMass);
            else
                last.Jump(step, _now.Motion.State);

            return Last = last;
        }

        /// <summary>True if the step before this one was taken without pushes and with a closed form: it ended a stretch, or had a length of its own.</summary>
        private bool HasCoasted(long step)
        {
            Stretch<TIntegrator> stretch = _stretches[_before.Value.Stretch];
            return Plan.MayCoast && stretch.End >= step && Load.Step != step - 1 && stretch.KnowsWay(_before.Value.Motion);
        }

        /// <summary>The state before the last step, computed once more.</summary>
        private BodyState Before(long step)
        {
            Moment now = _now;
            TIntegrator anchor = Anchor;
            Return();
            Run(_stretches, _loaded, step - 1);
            CatchUp(step - 1);
            if (Gives)
                Give(ref _now.Motion, Plan.Stretches[_now.Stretch]);

            BodyState before = _now.Motion.State;
            _now = now;
            Forget();
            Anchor = anchor;
            return before;
        }
    }
}
