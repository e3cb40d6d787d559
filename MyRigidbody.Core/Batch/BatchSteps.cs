#if NET
using System;
using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>Steps the bodies, and takes all of them back where one cannot go on.</summary>
    /// <remarks>
    /// States are tested for being finite after every 64th step, at the end of a call with that many steps, and when they are read;
    /// so a lost body may be found in a later call, which still names the body and the step. For that purpose each body is stored
    /// at most 1024 steps back, and effects are evaluated again in those steps: they are functions of time and state. What a
    /// program changes between steps is a load on a body or a <see cref="LabKeyboard"/>; with either of these, all bodies are
    /// tested and stored in every call.
    /// </remarks>
    internal sealed partial class Batch
    {
        // storing all bodies takes about as long as testing them
        private const long StepsBetweenCopies = 16 * Parts.StepsBetweenLooks;

        // the step that all bodies had reached when it was last certain that none goes back
        private long _stayed;
        // a step in which a body was lost; a stretch in which bodies could coast, and do not because a step has another length
        private long _suspect = -1;
        private int _halted = -1;
        private bool _isHalted, _areAllAside;

        private long EndOfStretch => Plan.Stretches[_stretch].End;

        /// <summary>True where the next step begins with an impulse, which the states do not contain yet.</summary>
        private bool Gives => Plan.HasImpulses && Plan.Stretches[_stretch].GivesAt(_step);

        public override long Limit(long end)
        {
            long limit = Math.Min(end, EndOfStretch);
            if (_loads.Count > 0 || Gives)
                limit = Math.Min(limit, _step + 1);

            return _coasts[_stretch] ? limit : _step + Math.Min(limit - _step, StepsBetweenCopies - _step % StepsBetweenCopies);
        }

        public override long Advance(long end, ref Exception failure)
        {
            if (end == _step)
                return end;

            Exception found = StepAside();
            if (found != null)
            {
                failure = found;
                return _step;
            }

            Move(end);
            if (_parts.AnyFailed)
            {
                long step = end;
                found = _parts.FindLost(ref step);
                if (found != null)
                {
                    failure = found;
                    return _suspect = Math.Max(_step, step);
                }

                _parts.GoBack(end);
            }

            _step = end;
            return end;
        }

        public override void GoBack()
        {
            _step = _clock.Step;
            _crowd.ForgetAside();
            _parts.GoBack(_step);
            _crowd.Forget(0, _capacity);
        }

        public override void Stay()
        {
            if (_step == _stayed)
                return;

            _stayed = _step;
            TakeBack();
            if (_step == EndOfStretch && _stretch + 1 < _coasts.Length)
            {
                bool coasted = _coasts[_stretch];
                Enter(_stretch + 1);
                if (coasted || _coasts[_stretch])
                    _parts.Keep(_step);
            }
            else if (!_coasts[_stretch] && _step % StepsBetweenCopies == 0)
            {
                _parts.Keep(_step);
            }
        }

        /// <summary>A step of another length cannot belong to a closed form that goes by step numbers.</summary>
        public override void Arrive(bool mayCoast)
        {
            if (mayCoast && !_isHalted)
                return;

            if (!mayCoast)
            {
                _parts.Follow(_step);
                if (_parts.AnyFailed)
                    throw Lost();

                if (_coasts[_stretch])
                    _coasts[_halted = _stretch] = false;
            }
            else if (_halted >= 0)
            {
                _coasts[_halted] = true;
                _halted = -1;
            }

            _isHalted = !mayCoast;

            Enter(_stretch);
            _parts.Keep(_step);
        }

        private void Move(long end)
        {
            bool isNext = end == EndOfStretch && _stretch + 1 < _coasts.Length;
            if (!_coasts[_stretch])
            {
                if (_isSteered)
                    _parts.Keep(_step);

                _parts.Step(_step, end, looksAtStop: _isSteered || _isHalted || _step <= _suspect || (isNext && _coasts[_stretch + 1]));
            }
            else if (end == EndOfStretch)
            {
                _parts.Follow(end);
            }
        }

        /// <summary>Bodies with a load take the step one by one, apart from the others; all bodies do where the step begins with an impulse.</summary>
        private Exception StepAside()
        {
            Exception found = null;
            _areAllAside = Gives;
            if (!_areAllAside)
            {
                foreach (KeyValuePair<Body, Load> loaded in _loads)
                    found = found ?? StepAside(loaded.Key, loaded.Value, isLoaded: true);
            }

            for (int i = 0; _areAllAside && found == null && i < Count; i++)
                found = StepAside(_places[i], _loads.TryGetValue(_places[i], out Load load) ? load : Load.None, isLoaded: _loads.ContainsKey(_places[i]));

            return found;
        }

        private Exception StepAside(Body body, in Load load, bool isLoaded)
        {
            Load = load;
            if (_crowd.StepAside(this, _stretch, body.Place, _step, isLoaded))
                return null;

            Exception found = _crowd.Blame(Plan, _stretch, body.Place, body, _step, this, isLoaded) ?? new StateOverflowException(Plan, _step, body);
            // the load is dropped with the step, as for a single body
            if (found is StateOverflowException)
                _loads.Remove(body);

            return found;
        }

        private void TakeBack()
        {
            int aside = 0;
            if (!_areAllAside)
            {
                foreach (KeyValuePair<Body, Load> loaded in _loads)
                    TakeBack(aside++, loaded.Key.Place);
            }

            for (; _areAllAside && aside < Count; aside++)
                TakeBack(aside, aside);

            _areAllAside = false;

            _crowd.ForgetAside();
            _loads.Clear();
        }

        private void TakeBack(int aside, int place)
        {
            Follow(place);
            _crowd.TakeBack(aside, place);
            Keep(place);
        }

        /// <summary>Called when the first bodies are added.</summary>
        private void Awake()
        {
            _step = _stayed = _clock.Step;
            Enter(_retrace.StretchOf(_step));
        }

        private void Enter(int stretch)
        {
            _stretch = stretch;
            _crowd.Forget(0, _capacity);
            _parts.Begin(stretch, _coasts[stretch]);
            if (_coasts[stretch])
                _coasters.Begin(stretch, Plan.Stretches[stretch].Coasting);
        }

        private Exception Lost()
        {
            long step = _step;
            Exception lost = _parts.FindLost(ref step);
            _parts.GoBack(_step);
            return lost ?? new StateOverflowException(Plan, Math.Max(0, _step - 1));
        }
    }
}
#endif
