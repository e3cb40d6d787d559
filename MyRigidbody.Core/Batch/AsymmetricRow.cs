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

            double turns = _isShort ? _count : -_count, first = _isShort ? _orbit.V1 : _orbit.C1, third = _isShort ? _orbit.V3 : _orbit.C3;
            row.Carry(AsymmetricLanes.Energy, ref _energy);
            row.Carry(AsymmetricLanes.Separation, ref _separation);
            row.Carry(AsymmetricLanes.PreparedFor, ref _preparedFor);
            row.Carry(AsymmetricLanes.InverseEnergy, ref _inverseEnergy);
            row.Carry(AsymmetricLanes.S, ref _orbit.S);
            row.Carry(AsymmetricLanes.First, ref first);
            row.Carry(AsymmetricLanes.Third, ref third);
            row.Carry(AsymmetricLanes.InverseSquare, ref _orbit.InverseSquare);
            row.Carry(AsymmetricLanes.Sine, ref _orbit.Sine);
            row.Carry(AsymmetricLanes.SineLost, ref _orbit.SineLost);
            row.Carry(AsymmetricLanes.Versine, ref _orbit.Versine);
            row.Carry(AsymmetricLanes.Turns, ref turns);
            _count = (long)Math.Abs(turns);
            _isShort = turns > 0;
            _orbit.V1 = _isShort ? first : 0;
            _orbit.V3 = _isShort ? third : 0;
            _orbit.C1 = _isShort ? 1 - first : first;
            _orbit.C3 = _isShort ? 1 - third : third;
            Derive();
        }
    }
}
#endif
