using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;

namespace RigidBodyDynamics
{
    /// <summary>A division of time: steps of one length, or a list of lengths.</summary>
    /// <remarks>Step n starts at n × length, or at the compensated sum of the lengths before it, so starts do not accumulate roundings.</remarks>
    public sealed class TimeSteps
    {
        /// <summary>No step may be longer, s.</summary>
        public const double Longest = 1e9;

        // a start this close to a time, in steps, is at that time: n × (1/60) may miss 1.5 by a rounding
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
                // Kahan: the rounding error of the sum is added with the next length
                double add = _lengths[i] - lost, next = sum + add;
                lost = (next - sum) - add;
                sum = next;
                _starts[i + 1] = sum;
                _rests[i + 1] = -lost;
            }
        }

        /// <summary>The number of steps; <see cref="long.MaxValue"/> where there is no end.</summary>
        public long Count { get; }

        /// <summary>The first step whose length differs from that of step 0; −1 if there is none.</summary>
        public long FirstOfOtherLength => _lengths == null ? -1 : Array.FindIndex(_lengths, length => length != _lengths[0]);

        /// <summary>Steps of one length (s), without end.</summary>
        public static TimeSteps Every(double length) => new TimeSteps(length, long.MaxValue);

        /// <summary>A number of steps of one length (s).</summary>
        public static TimeSteps Every(double length, long count) => new TimeSteps(length, count);

        /// <summary>The steps of one length (s) that reach a time (s).</summary>
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

        /// <summary>The start of a step, s; for step <see cref="Count"/> the end.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public double StartOf(long step) => _starts == null ? _grid.Start + (step - _grid.Origin) * _grid.Length : _starts[step];

        /// <summary>The time from the start of a step to that of another, s, in twice the digits.</summary>
        internal DoubleDouble Between(long from, long to) => _starts == null
            ? (DoubleDouble)_grid.Length * (to - from)
            : new DoubleDouble(_starts[to], _rests[to]) - new DoubleDouble(_starts[from], _rests[from]);

        /// <summary>The first step that starts at or after a time; <see cref="Count"/> if none does.</summary>
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

        /// <summary>True for the step that starts at a time, or is the first one after it.</summary>
        internal bool Begins(long step, double time) => FirstAt(time) == step && !(time <= _grid.Done);

        /// <summary>Whether a list gives their lengths.</summary>
        internal bool AreListed => _lengths != null;

        /// <summary>The origin of steps of one length. A simulation that takes a step of another length moves it.</summary>
        internal Grid Division { get => _grid; set => _grid = value; }

        /// <summary>A copy whose origin can be moved separately.</summary>
        internal TimeSteps Copy() => (TimeSteps)MemberwiseClone();

        /// <summary>Gives all steps from one on another length; that step starts where it would have.</summary>
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

        /// <summary>A step from which all steps have one length, and its start.</summary>
        internal struct Grid
        {
            public long Origin;
            public double Start, StartLost, Length;

            /// <summary>Effects that begin at this time or before have begun in a step before the origin.</summary>
            public double Done;

            public bool Equals(in Grid other) => Origin == other.Origin && Start == other.Start && StartLost == other.StartLost && Length == other.Length;
        }
    }
}
