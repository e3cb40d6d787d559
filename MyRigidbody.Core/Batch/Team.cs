#if NET
using System;
using System.Runtime.ExceptionServices;
using System.Threading;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Does work that is divided into parts, on the calling thread and on others of the pool. Whoever is free takes the next
    /// part; the caller does all of them if nobody comes. Allocates nothing.
    /// </summary>
    internal sealed class Team
    {
        private readonly Action<int, int> _work;
        private readonly ManualResetEventSlim _done = new ManualResetEventSlim();
        private Helper[] _helpers = Array.Empty<Helper>();
        private Exception _failure;
        // counted down: one who comes late finds none left, whatever is being prepared next
        private int _untaken, _unfinished;

        /// <summary>A team for one kind of work.</summary>
        /// <param name="work">Gets the number of the thread, which no other has at the time, and the number of the part.</param>
        public Team(Action<int, int> work) => _work = work;

        /// <summary>How many threads may work at a time, the calling one among them.</summary>
        public int Threads
        {
            get => _helpers.Length + 1;
            set
            {
                Helper[] helpers = new Helper[value - 1];
                for (int i = 0; i < helpers.Length; i++)
                    helpers[i] = i < _helpers.Length ? _helpers[i] : new Helper(this, i + 1);

                _helpers = helpers;
            }
        }

        public void Do(int parts)
        {
            if (parts == 0)
                return;

            _failure = null;
            _unfinished = parts;
            _done.Reset();
            Volatile.Write(ref _untaken, parts);
            for (int i = 0; i < _helpers.Length && i < parts - 1; i++)
                _helpers[i].Call();

            TakeParts(0);
            _done.Wait();
            if (_failure != null)
                ExceptionDispatchInfo.Capture(_failure).Throw();
        }

        private void TakeParts(int thread)
        {
            for (int part = Take(); part >= 0; part = Take())
            {
                try
                {
                    _work(thread, part);
                }
                catch (Exception failure)
                {
                    // an effect is somebody else's code, and may throw
                    _failure = failure;
                }

                if (Interlocked.Decrement(ref _unfinished) == 0)
                    _done.Set();
            }
        }

        private int Take() => Volatile.Read(ref _untaken) > 0 ? Interlocked.Decrement(ref _untaken) : -1;

        private sealed class Helper : IThreadPoolWorkItem
        {
            private readonly Team _team;
            private readonly int _thread;
            private int _isCalled;

            public Helper(Team team, int thread)
            {
                _team = team;
                _thread = thread;
            }

            /// <summary>Asks for help, unless the helper is on its way.</summary>
            public void Call()
            {
                if (Interlocked.Exchange(ref _isCalled, 1) == 0)
                    ThreadPool.UnsafeQueueUserWorkItem(this, preferLocal: false);
            }

            public void Execute()
            {
                do
                {
                    _team.TakeParts(_thread);
                    Volatile.Write(ref _isCalled, 0);
                    // called once more just before that
                }
                while (Volatile.Read(ref _team._untaken) > 0 && Interlocked.Exchange(ref _isCalled, 1) == 0);
            }
        }
    }
}
#endif
