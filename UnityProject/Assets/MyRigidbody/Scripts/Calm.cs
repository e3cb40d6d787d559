namespace RigidBodyDynamics.Scripts
{
    /// <summary>
    /// Finds when PhysX would let a body fall asleep: when it has hardly moved for 0.2 s. Setting a velocity resets the engine's counter
    /// for that, so a body that should fall asleep must be left alone.
    /// </summary>
    /// <remarks>
    /// As in PhysX, the velocities of the steps are added up, and the energy of the sums is compared with the threshold, which is
    /// multiplied where the body touches others, by one and their number. Here three contacts are assumed if every step has pushed it.
    /// </remarks>
    internal struct Calm
    {
        private const double LongEnough = 0.2, Touching = 1 + 3;

        private Vector3d _velocities, _spins;
        private double _time;
        private bool _isCalm, _isFree;

        /// <summary>Called once a step.</summary>
        /// <param name="body">The body.</param>
        /// <param name="inertia">For 1 kg, body axes.</param>
        /// <param name="step">The step, s.</param>
        /// <param name="isPushed">True if the engine pushed it in the last step; unknown while it is calm.</param>
        public bool Look(in EngineBody body, SymmetricMatrix3 inertia, double step, bool isPushed)
        {
            _isFree |= !isPushed && !_isCalm;
            _velocities += body.Velocity;
            _spins += body.Orientation.Normalized.RotateInverse(body.AngularVelocity);
            _time += step;
            double energy = 0.5 * (_velocities.LengthSquared + Vector3d.Dot(_spins, inertia * _spins) / body.Mass);
            bool isLow = energy < (_isFree ? 1 : Touching) * body.SleepThreshold;
            if (isLow && _time < LongEnough)
                return _isCalm;

            _isCalm = isLow;
            _isFree = false;
            _velocities = _spins = Vector3d.Zero;
            _time = 0;
            return _isCalm;
        }
    }
}
