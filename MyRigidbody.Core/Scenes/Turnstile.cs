using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Finds a step that begins before another has ended. Costs two stores and no lock, so two threads that come within some
    /// nanoseconds may both pass, but not repeatedly.
    /// </summary>
    internal struct Turnstile
    {
        private volatile bool _isInside;

        /// <param name="what">The kind of what is stepped.</param>
        /// <param name="name">Its name.</param>
        public void Enter(string what, string name)
        {
            if (_isInside)
                throw Refused(what + " \"" + name + "\"");

            _isInside = true;
        }

        public void Leave() => _isInside = false;

        private static InvalidOperationException Refused(string what) => new InvalidOperationException(
            what + ": is being stepped already: one thread may step it at a time, and no effect in it may");
    }
}
