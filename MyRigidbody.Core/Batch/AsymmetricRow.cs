#if NET
using System;

namespace RigidBodyDynamics
{
    internal partial struct AsymmetricTop : IHasLanes
    {
        public Crowd InLanes<TScheme>(BodyDescription body) where TScheme : struct, IScheme =>
            new Composition<AsymmetricTop, TScheme>.InColumns<AsymmetricTop, AsymmetricLanes>(body);

        public void Carry(Row row, bool isAll)
        {
            row.Carry(AsymmetricLanes.Q, ref _q);
            row.Carry(AsymmetricLanes.QLost, ref _qLost);
            row.Carry(AsymmetricLanes.W, ref _w);
            row.Carry(AsymmetricLanes.WLost, ref _wLost);
            row.Carry(AsymmetricLanes.Scale, ref _scale);
            if (!isAll)
                return;

            double turns = _isShort ? _count : -_count;
            row.Carry(AsymmetricLanes.Energy, ref _energy);
            row.Carry(AsymmetricLanes.Separation, ref _separation);
            row.Carry(AsymmetricLanes.PreparedFor, ref _preparedFor);
            row.Carry(AsymmetricLanes.InverseEnergy, ref _inverseEnergy);
            row.Carry(AsymmetricLanes.S, ref _orbit.S);
            row.Carry(AsymmetricLanes.C1, ref _orbit.C1);
            row.Carry(AsymmetricLanes.C3, ref _orbit.C3);
            row.Carry(AsymmetricLanes.V1, ref _orbit.V1);
            row.Carry(AsymmetricLanes.V3, ref _orbit.V3);
            row.Carry(AsymmetricLanes.C, ref _orbit.C);
            row.Carry(AsymmetricLanes.Z, ref _orbit.Z);
            row.Carry(AsymmetricLanes.Turns, ref turns);
            _count = (long)Math.Abs(turns);
            _isShort = turns > 0;
        }

        /// <summary>Prepares without turning.</summary>
        internal void PrepareFor(double time)
        {
            time *= _scale;
            if (time != _preparedFor)
                Prepare(time);
        }
    }
}
#endif
