using System;

namespace RigidBodyDynamics
{
    /// <summary>A 64-bit fingerprint of states: equal bits give equal hashes, on every runtime.</summary>
    /// <remarks>FNV-1a (Fowler, Noll, Vo), byte by byte, lowest first.</remarks>
    public struct StateHash
    {
        private const ulong Start = 14695981039346656037;
        private const ulong Prime = 1099511628211;
        private ulong _mixed;

        /// <summary>The fingerprint of all that was added.</summary>
        public ulong Value => _mixed ^ Start;

        /// <summary>Adds the bits of a number.</summary>
        public void Add(double number)
        {
            ulong bits = (ulong)BitConverter.DoubleToInt64Bits(number);
            ulong hash = _mixed ^ Start;
            for (int i = 0; i < 8; i++)
            {
                hash = unchecked((hash ^ (bits & 0xff)) * Prime);
                bits >>= 8;
            }

            // kept against the start value, so that a hash of nothing is default(StateHash)
            _mixed = hash ^ Start;
        }

        /// <summary>Adds the bits of a vector.</summary>
        public void Add(Vector3d vector)
        {
            Add(vector.X);
            Add(vector.Y);
            Add(vector.Z);
        }

        /// <summary>Adds the bits of a state.</summary>
        public void Add(in BodyState state)
        {
            Add(state.Position);
            Add(state.Orientation.W);
            Add(state.Orientation.Vector);
            Add(state.Velocity);
            Add(state.AngularVelocity);
        }
    }
}
