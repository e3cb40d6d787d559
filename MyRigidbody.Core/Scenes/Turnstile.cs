using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Lets one through at a time: finds a step that begins before another has ended. Costs two stores and no lock, so of two threads
    /// that come within some nanoseconds both may pass, but not again and again.
    /// </summary>
    internal struct Turnstile
    {
        // managed numbers of threads are above zero
        private volatile int _inside;

        /// <param name="what">What is stepped.</param>
        /// <param name="name">Its name.</param>
        public void Enter(string what, string name)
        {
            int now = Environment.CurrentManagedThreadId, inside = _inside;
            if (inside != 0)
                throw Refused(what + " \"" + name + "\"", inside == now);

            _inside = now;
        }

        public void Leave() => _inside = 0;

        private static InvalidOperationException Refused(string what, bool isSame) => new InvalidOperationException(
            what + ": is being stepped already, " + (isSame
                ? "by this thread: an effect must not step what it acts in"
                : "by another thread: only one may step it at a time, and no effect"));
    }
}
