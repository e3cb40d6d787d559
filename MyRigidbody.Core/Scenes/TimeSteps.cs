using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    /// <summary>How time is divided: steps of one length, or a list of lengths.</summary>
    /// <remarks>Step n starts at n × length, or at the sum of the lengths before it; nothing is added up step by step.</remarks>
    public sealed class TimeSteps
    {
        /// <summary>No step may be longer, s.</summary>
        public const double Longest = 1e9;

        // a start this close to a moment, in steps, is at that moment: n × (1/60) may miss 1.5 by a rounding
        private const double Same = 1e-6;

        private readonly double[] _lengths;
        private readonly double[] _starts, _rests;
        private Grid _grid = new Grid { Done = double.NegativeInfinity };

        private TimeSteps(double length, long count)
        {
            _grid.Length = Possible(length);
            Count = count >= 1 ? count : throw Guard.Refused("steps", count, "must be at least 1");
        }

        private TimeSteps(IReadOnlyList<double> lengths)
        {
            Count = lengths.Count >= 1 ? lengths.Count : throw Guard.Refused("steps", lengths.Count, "must be at least 1");
            _lengths = new double[lengths.Count];
            _starts = new double[lengths.Count + 1];
            _rests = new double[lengths.Count + 1];
            double sum = 0, lost = 0;
            for (int i = 0; i < _lengths.Length; i++)
            {
                _lengths[i] = Possible(lengths[i], i);
                // Kahan: what the sum rounds away is added with the next length
                double add = _lengths[i] - lost, next = sum + add;
                lost = (next - sum) - add;
                sum = next;
                _starts[i + 1] = sum;
                _rests[i + 1] = -lost;
            }
        }

        /// <summary>How many steps there are; <see cref="long.MaxValue"/> where there is no end.</summary>
        public long Count { get; }

        /// <summary>The first step that is not as long as the first of all; −1 if all are.</summary>
        public long FirstOfOtherLength => _lengths == null ? -1 : Array.FindIndex(_lengths, length => length != _lengths[0]);

        /// <summary>Steps of one length (s), without end.</summary>
        public static TimeSteps Every(double length) => new TimeSteps(length, long.MaxValue);

        /// <summary>A number of steps of one length (s).</summary>
        public static TimeSteps Every(double length, long count) => new TimeSteps(length, count);

        /// <summary>As many steps of one length (s) as it takes to reach a time (s).</summary>
        public static TimeSteps Until(double duration, double length)
        {
            Guard.Positive(duration, nameof(duration));
            double count = Math.Max(1, Math.Ceiling(duration / Possible(length) - Same));
            return count < 1e18
                ? new TimeSteps(length, (long)count)
                : throw Guard.Refused(nameof(duration), duration, "must not take more than 1e18 steps");
        }

        /// <summary>Steps of the given lengths, s.</summary>
        public static TimeSteps Of(IReadOnlyList<double> lengths) => new TimeSteps(Guard.NotNull(lengths, nameof(lengths)));

        /// <summary>Length of a step, s.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public double Length(long step) => _lengths == null ? _grid.Length : _lengths[step];

        /// <summary>Time at which a step starts, s; that of step <see cref="Count"/> is the end.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public double StartOf(long step) => _starts == null ? _grid.Start + (step - _grid.Origin) * _grid.Length : _starts[step];

        /// <summary>Time from the start of a step to that of another, s, in twice the digits.</summary>
        internal DoubleDouble Between(long from, long to) => _starts == null
            ? (DoubleDouble)_grid.Length * (to - from)
            : new DoubleDouble(_starts[to], _rests[to]) - new DoubleDouble(_starts[from], _rests[from]);

        /// <summary>The first step that starts at a time or after it; <see cref="Count"/> if none does.</summary>
        public long FirstAt(double time)
        {
            if (_starts == null)
            {
                if (!(time > _grid.Start))
                    return _grid.Origin;

                double first = _grid.Origin + Math.Ceiling((time - _grid.Start) / _grid.Length - Same);
                return first < Count ? (long)first : Count;
            }

            long low = 0, high = Count;
            while (low < high)
            {
                long middle = low + (high - low) / 2;
                if (_starts[middle] + Same * _lengths[middle] >= time)
                    high = middle;
                else
                    low = middle + 1;
            }

            return low;
        }

        /// <summary>True for the step that starts at a time, or is the first to start after it.</summary>
        internal bool Begins(long step, double time) => FirstAt(time) == step && !(time <= _grid.Done);

        /// <summary>Whether a list gives their lengths.</summary>
        internal bool AreListed => _lengths != null;

        /// <summary>Where steps of one length begin. A simulation that takes a step of another moves it.</summary>
        internal Grid Division { get => _grid; set => _grid = value; }

        /// <summary>The same division, to be moved by itself.</summary>
        internal TimeSteps Copy() => (TimeSteps)MemberwiseClone();

        /// <summary>From a step on, all steps have another length; it starts when it would have.</summary>
        internal void Turn(long step, double length)
        {
            if (step > _grid.Origin)
                _grid.Done = StartOf(step - 1) + Same * _grid.Length;

            RunningSum.Add(ref _grid.Start, ref _grid.StartLost, (step - _grid.Origin) * _grid.Length);
            _grid.Origin = step;
            _grid.Length = length;
        }

        internal static double Possible(double length, int index = -1) =>
            length > 0 && length <= Longest
                ? length
                : throw Guard.Refused(index < 0 ? "step" : "step[" + index + "]", length, "must be above zero and at most 1e9 s");

        /// <summary>A step from which on all have one length, and when it starts.</summary>
        internal struct Grid
        {
            public long Origin;
            public double Start, StartLost, Length;

            /// <summary>What is to begin at this time or before has begun in a step before the origin.</summary>
            public double Done;

            public bool Equals(in Grid other) => Origin == other.Origin && Start == other.Start && StartLost == other.StartLost && Length == other.Length;
        }
    }
}
