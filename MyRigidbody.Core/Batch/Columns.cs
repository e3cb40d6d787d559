#if NET
using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Lanes = System.Numerics.Vector<double>;

namespace RigidBodyDynamics
{
    /// <summary>
    /// The numbers of many bodies, a column for each kind of number and a row for each body, so that the same number of
    /// neighbouring bodies is one vector. The rows up to a multiple of the vector's width are there, lived in or not. What is touched
    /// one body at a time lies row after row instead.
    /// </summary>
    internal sealed class Columns
    {
        // columns that start at the same address modulo 4096 would push one another out of the cache
        private const int Apart = 12;

        private readonly bool _areRows;
        private double[] _numbers = Array.Empty<double>();
        // from a number to the next of the same body, and to the same of the next body
        private int _stride, _next;

        public Columns(int count, bool areRows = false)
        {
            Count = count;
            _areRows = areRows;
        }

        /// <summary>How many columns there are.</summary>
        public int Count { get; }

        /// <summary>How many rows there are.</summary>
        public int Rows { get; private set; }

        /// <summary>As many neighbours as a vector has lanes, from a row on that is a multiple of them.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Group At(int row) => new Group(_numbers.AsSpan(row, (Count - 1) * _stride + Lanes.Count), _stride);

        /// <summary>The numbers of one body, to be carried into its struct or out of it.</summary>
        public Row Row(int row, bool isOut) => new Row(_numbers.AsSpan(row * _next), _stride, isOut);

        /// <summary>The squares of one number of some bodies, summed in any order.</summary>
        [MethodImpl(Kernel.Compiled)]
        public double SumOfSquares(int column, int from, int to)
        {
            ReadOnlySpan<double> numbers = _numbers.AsSpan((column * _stride) + from, to - from);
            ReadOnlySpan<Lanes> lanes = MemoryMarshal.Cast<double, Lanes>(numbers);
            Lanes a = Lanes.Zero, b = Lanes.Zero;
            int i = 0;
            for (; i + 1 < lanes.Length; i += 2)
            {
                a += lanes[i] * lanes[i];
                b += lanes[i + 1] * lanes[i + 1];
            }

            double sum = 0;
            for (i *= Lanes.Count; i < numbers.Length; i++)
                sum += numbers[i] * numbers[i];

            return sum + Vector.Sum(a + b);
        }

        /// <summary>Makes room for a power of two of rows, at least <see cref="Vector{T}.Count"/>.</summary>
        public void Reserve(int rows)
        {
            int stride = _areRows ? 1 : rows + Apart;
            double[] numbers = new double[checked(Count * (rows + Apart))];
            if (_areRows)
                Array.Copy(_numbers, numbers, Count * Rows);

            for (int i = 0; !_areRows && i < Count; i++)
                Array.Copy(_numbers, i * _stride, numbers, i * stride, Rows);

            _numbers = numbers;
            Rows = rows;
            _stride = stride;
            _next = _areRows ? Count : 1;
        }

        /// <summary>Copies rows to another with the same columns.</summary>
        public void CopyTo(Columns other, int from, int to)
        {
            double[] numbers = _numbers, others = other._numbers;
            for (int row = from; row < to; row++)
            {
                for (int i = 0, here = row * _next, there = row * other._next; i < Count; i++, here += _stride, there += other._stride)
                    others[there] = numbers[here];
            }
        }

        /// <summary>Makes them as others are that have as many columns.</summary>
        public void CopyFrom(Columns other)
        {
            if (_numbers.Length != other._numbers.Length)
                _numbers = new double[other._numbers.Length];

            Array.Copy(other._numbers, _numbers, _numbers.Length);
            Rows = other.Rows;
            _stride = other._stride;
            _next = other._next;
        }

        /// <summary>Copies one row over another.</summary>
        public void Move(int from, int to)
        {
            for (int i = 0; i < Count; i++)
                _numbers[i * _stride + to * _next] = _numbers[i * _stride + from * _next];
        }
    }

    /// <summary>The numbers of neighbours that are computed together: of each column one vector.</summary>
    internal readonly ref struct Group
    {
        private readonly Span<double> _numbers;
        // in the width of an address, so that it need not be widened for every access
        private readonly long _stride;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Group(Span<double> numbers, int stride)
        {
            _numbers = numbers;
            _stride = stride;
        }

        /// <summary>One of the neighbours.</summary>
        public Row Row(int lane, bool isOut) => new Row(_numbers.Slice(lane), (int)_stride, isOut);

        /// <summary>A number of each; the column is not checked, because that would cost as much as the arithmetic.</summary>
        public ref Lanes this[int column]
        {
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            get => ref Unsafe.As<double, Lanes>(ref Unsafe.Add(ref MemoryMarshal.GetReference(_numbers), (IntPtr)(column * _stride)));
        }
    }

    /// <summary>The numbers of one body, to be carried from its row into its struct or out of there.</summary>
    internal readonly ref struct Row
    {
        private readonly Span<double> _numbers;
        private readonly int _stride;
        private readonly bool _isOut;

        public Row(Span<double> numbers, int stride, bool isOut)
        {
            _numbers = numbers;
            _stride = stride;
            _isOut = isOut;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Carry(int column, ref double number)
        {
            ref double here = ref _numbers[column * _stride];
            if (_isOut)
                here = number;
            else
                number = here;
        }

        public void Carry(int column, ref Vector3d v)
        {
            Carry(column, ref v.X);
            Carry(column + 1, ref v.Y);
            Carry(column + 2, ref v.Z);
        }

        public void Carry(int column, ref Quaterniond q)
        {
            Carry(column, ref q.W);
            Carry(column + 1, ref q.X);
            Carry(column + 2, ref q.Y);
            Carry(column + 3, ref q.Z);
        }
    }
}
#endif
