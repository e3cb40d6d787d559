#if NET
using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Lanes = System.Numerics.Vector<double>;

namespace RigidBodyDynamics
{
    /// <summary>
    /// The numbers of many bodies: a column for each kind of number and a row for each body, so that one number of neighbouring
    /// bodies is one vector. Rows up to the end of the last block exist, used or not. Columns that are accessed one body at a time
    /// are stored row after row instead.
    /// </summary>
    internal sealed class Columns
    {
        /// <summary>The number of bodies in a block: their numbers stay in the first-level cache from one pass over them to the next.</summary>
        public const int RowsOfBlock = 32;

        // doubles in a cache line; columns that start at the same address modulo 4096 would evict one another
        private const int Line = 8;

        private readonly bool _areRows;
        private double[] _numbers = Array.Empty<double>();
        // for each block, the step length for which all its bodies are ready
        private double[] _ready = Array.Empty<double>();
        // where the first number is; from a number to the next of the same body, and to the same number of the next body
        private int _first, _stride, _next;

        public Columns(int count, bool areRows = false)
        {
            Count = count;
            _areRows = areRows;
        }

        /// <summary>The number of columns.</summary>
        public int Count { get; }

        /// <summary>The number of rows.</summary>
        public int Rows { get; private set; }

        /// <summary>The end of the block that contains a row.</summary>
        public static int EndOfBlock(int row) => (row / RowsOfBlock + 1) * RowsOfBlock;

        /// <summary>Neighbours from one row to another of the same block, in whole vectors.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Block From(int row, int to) =>
            new Block(_numbers.AsSpan(_first + row, (Count - 1) * _stride + to - row), _stride, to - row, ref _ready[row / RowsOfBlock]);

        /// <summary>The numbers of one body, to be copied into its struct or out of it.</summary>
        public Row Row(int row, bool isOut)
        {
            if (isOut)
                Change(row, row + 1);

            return new Row(_numbers.AsSpan(_first + row * _next), _stride, isOut);
        }

        /// <summary>Makes room for a number of rows, or a few more.</summary>
        public void Reserve(int rows)
        {
            Columns old = (Columns)MemberwiseClone();
            rows = (rows + RowsOfBlock - 1) / RowsOfBlock * RowsOfBlock;
            _stride = _areRows ? 1 : rows + Line;
            _next = _areRows ? Count : 1;
            _numbers = GC.AllocateArray<double>(checked(Count * (rows + Line) + Line), pinned: true);
            long address = (long)Marshal.UnsafeAddrOfPinnedArrayElement(_numbers, 0);
            _first = (int)(-(address / sizeof(double)) & (Line - 1));
            Rows = rows;
            _ready = new double[_areRows ? 0 : rows / RowsOfBlock];
            Change(0, rows);
            if (_areRows)
                Array.Copy(old._numbers, old._first, _numbers, _first, Count * old.Rows);

            for (int i = 0; !_areRows && i < Count; i++)
                Array.Copy(old._numbers, old._first + i * old._stride, _numbers, _first + i * _stride, old.Rows);
        }

        /// <summary>Copies rows into another set of the same columns.</summary>
        public void CopyTo(Columns other, int from, int to)
        {
            double[] numbers = _numbers, others = other._numbers;
            other.Change(from, to);
            for (int row = from; row < to; row++)
            {
                int here = _first + row * _next, there = other._first + row * other._next;
                for (int i = 0; i < Count; i++, here += _stride, there += other._stride)
                    others[there] = numbers[here];
            }
        }

        /// <summary>Becomes a copy of another set with as many columns.</summary>
        public void CopyFrom(Columns other)
        {
            if (Rows != other.Rows)
                Reserve(other.Rows);

            Array.Copy(other._numbers, other._first, _numbers, _first, Count * (Rows + Line));
            Change(0, Rows);
        }

        /// <summary>Copies one row over another.</summary>
        public void Move(int from, int to)
        {
            Change(to, to + 1);
            for (int i = _first, end = i + Count * _stride; i < end; i += _stride)
                _numbers[i + to * _next] = _numbers[i + from * _next];
        }

        /// <summary>Forgets for which step length blocks are ready.</summary>
        private void Change(int from, int to)
        {
            for (int block = from / RowsOfBlock; block < _ready.Length && block * RowsOfBlock < to; block++)
                _ready[block] = double.NaN;
        }
    }

    /// <summary>Neighbouring bodies of one block, in whole vectors.</summary>
    internal readonly ref struct Block
    {
        /// <summary>How many bodies they are.</summary>
        public readonly int Rows;

        private readonly Span<double> _numbers, _ready;
        // as wide as an address, so that no access has to widen it
        private readonly long _stride;

        public Block(Span<double> numbers, long stride, int rows, ref double ready)
        {
            _numbers = numbers;
            _stride = stride;
            _ready = MemoryMarshal.CreateSpan(ref ready, 1);
            Rows = rows;
        }

        /// <summary>The step length, s, for which all bodies of the whole block are ready; NaN where that is unknown.</summary>
        public double ReadyFor
        {
            get => _ready[0];
            set => _ready[0] = value;
        }

        /// <summary>True if these are all bodies of the block.</summary>
        public bool IsWhole => Rows == Columns.RowsOfBlock;

        /// <summary>A part of the bodies, from a row on.</summary>
        public Block Part(int row, int rows) => new Block(_numbers.Slice(row), _stride, rows, ref _ready[0]);

        /// <summary>As many neighbours as a vector has lanes, from a row on.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Group At(int row) => new Group(_numbers.Slice(row), _stride);
    }

    /// <summary>The numbers of neighbours that are computed together: one vector for each column.</summary>
    internal readonly ref struct Group
    {
        private readonly Span<double> _numbers;
        private readonly long _stride;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Group(Span<double> numbers, long stride)
        {
            _numbers = numbers;
            _stride = stride;
        }

        /// <summary>One of the neighbours.</summary>
        public Row Row(int lane, bool isOut) => new Row(_numbers.Slice(lane), (int)_stride, isOut);

        /// <summary>One number of each body; the column is not checked, because that would cost as much as the arithmetic.</summary>
        public ref Lanes this[int column]
        {
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            get => ref Unsafe.As<double, Lanes>(ref Unsafe.Add(ref MemoryMarshal.GetReference(_numbers), (IntPtr)(column * _stride)));
        }
    }

    /// <summary>The numbers of one body, to be copied from its row into its struct or back.</summary>
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
