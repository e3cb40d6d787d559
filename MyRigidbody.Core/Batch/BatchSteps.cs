#if NET
using System;
using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>How many bodies are stepped, and go back where one of them cannot go on.</summary>
    /// <remarks>
    /// They are looked at after every 64th step, after so many in one call, and when they are read; so it may be a later call that
    /// finds one lost. The body and the step are named all the same. For that each is kept once more, as it was at most 1024 steps
    /// before, and effects are asked again about those steps: they are functions of time and state. What a program changes between
    /// steps is a push on a body, or belongs into a <see cref="LabKeyboard"/>; with one of these, all are looked at and kept in
    /// every call.
    /// </remarks>
    internal sealed partial class Batch
    {
        // to keep all bodies takes about as long as to look at them
        private const long StepsBetweenCopies = 16 * Parts.StepsBetweenLooks;

        // the step up to which all had come when it was last certain that nobody goes back
        private long _stayed;
        // a step at which a body was lost; a stretch in which bodies could coast, and do not because of a step of another length
        private long _suspect = -1;
        private int _halted = -1;
        private bool _isHalted, _areAllAside;

        private long EndOfStretch => Plan.Stretches[_stretch].End;

        /// <summary>True where the next step begins with an impulse, which the states do not have yet.</summary>
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

        /// <summary>A step of another length is no part of a way that goes by the number of its steps.</summary>
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

        /// <summary>Those that the program pushes make the step by themselves, aside; and all where it begins with an impulse.</summary>
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
            // what was applied is refused with the step, as it is for one body
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

        /// <summary>The first bodies come.</summary>
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
