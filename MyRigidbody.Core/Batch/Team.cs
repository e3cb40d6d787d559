#if NET
using System;
using System.Runtime.ExceptionServices;
using System.Threading;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Divides work into parts for the calling thread and threads of the pool. A free thread takes the next part; the caller does
    /// all parts if no other thread comes. Allocates nothing.
    /// </summary>
    /// <remarks>
    /// Each thread has a tool of its own, even a helper that was called, dismissed and starts late: no two share one.
    /// </remarks>
    /// <typeparam name="TTool">What one thread needs for the work.</typeparam>
    internal sealed class Team<TTool>
    {
        private readonly Func<TTool> _newTool;
        private readonly Action<TTool, int> _work;
        private readonly TTool _own;
        private readonly ManualResetEventSlim _done = new ManualResetEventSlim();
        private Helper[] _helpers = Array.Empty<Helper>();
        private Exception _failure;
        // counted down: a helper that starts late finds no part left, whatever is being prepared next
        private int _parts, _untaken, _unfinished;

        /// <summary>A team for one kind of work.</summary>
        /// <param name="newTool">Makes a tool.</param>
        /// <param name="work">Gets a tool that no other thread has, and the number of the part.</param>
        public Team(Func<TTool> newTool, Action<TTool, int> work)
        {
            _newTool = newTool;
            _work = work;
            _own = newTool();
        }

        /// <summary>The largest number of threads that work at a time, the calling one included.</summary>
        public int Threads
        {
            get => _helpers.Length + 1;
            set
            {
                int old = _helpers.Length;
                for (int i = value - 1; i < old; i++)
                    _helpers[i].Dismiss();

                Array.Resize(ref _helpers, value - 1);
                for (int i = old; i < _helpers.Length; i++)
                    _helpers[i] = new Helper(this, _newTool());
            }
        }

        /// <summary>The tool of the calling thread.</summary>
        public TTool Own => _own;

        public void Do(int parts)
        {
            if (parts == 0)
                return;

            _failure = null;
            _parts = _unfinished = parts;
            _done.Reset();
            Volatile.Write(ref _untaken, parts);
            for (int i = 0; i < _helpers.Length && i < parts - 1; i++)
                _helpers[i].Call();

            TakeParts(_own);
            _done.Wait();
            if (_failure != null)
                ExceptionDispatchInfo.Capture(_failure).Throw();
        }

        private void TakeParts(TTool tool)
        {
            for (int part = Take(); part >= 0; part = Take())
            {
                try
                {
                    // in the order of memory
                    _work(tool, _parts - 1 - part);
                }
                catch (Exception failure)
                {
                    // an effect may be foreign code, and may throw
                    _failure = failure;
                }

                if (Interlocked.Decrement(ref _unfinished) == 0)
                    _done.Set();
            }
        }

        private int Take() => Volatile.Read(ref _untaken) > 0 ? Interlocked.Decrement(ref _untaken) : -1;

        private sealed class Helper : IThreadPoolWorkItem
        {
            private readonly Team<TTool> _team;
            private readonly TTool _tool;
            private int _isCalled;
            private bool _isDismissed;

            public Helper(Team<TTool> team, TTool tool)
            {
                _team = team;
                _tool = tool;
            }

            /// <summary>Calls a helper, unless it is on its way.</summary>
            public void Call()
            {
                if (Interlocked.Exchange(ref _isCalled, 1) == 0)
                    ThreadPool.UnsafeQueueUserWorkItem(this, preferLocal: false);
            }

            /// <summary>Dismisses helpers, even those that were called and have not started.</summary>
            public void Dismiss() => Volatile.Write(ref _isDismissed, true);

            public void Execute()
            {
                if (Volatile.Read(ref _isDismissed))
                    return;

                do
                {
                    _team.TakeParts(_tool);
                    Volatile.Write(ref _isCalled, 0);
                    // called once more just before that
                }
                while (Volatile.Read(ref _team._untaken) > 0 && Interlocked.Exchange(ref _isCalled, 1) == 0);
            }
        }
    }
}
#endif
