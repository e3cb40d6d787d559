using System;
using System.Collections.Generic;

namespace RigidBodyDynamics.Judging
{
    /// <summary>What scripts are known to add to a velocity, other than the sheet's formula.</summary>
    internal sealed class GainShape
    {
        private GainShape(string code, string formula, Func<Observation, Vector, Vector> gain)
        {
            Code = code;
            Formula = formula;
            Gain = gain;
        }

        /// <summary>Null: the sheet's.</summary>
        public string Code { get; }

        public string Formula { get; }

        /// <summary>The gain from the force or the torque, before the time step.</summary>
        public Func<Observation, Vector, Vector> Gain { get; }

        public static readonly IReadOnlyList<GainShape> OfForce = new[]
        {
            new GainShape(null, "F/m", (o, f) => (1 / o.Mass) * f),
            new GainShape("force-in-body-axes", "R F/m", (o, f) => (1 / o.Mass) * (R(o) * f)),
            new GainShape("force-in-body-axes", "Rᵀ F/m", (o, f) => (1 / o.Mass) * (R(o).Transpose * f)),
        };

        public static readonly IReadOnlyList<GainShape> OfTorque = new[]
        {
            new GainShape(null, "(R I_ref Rᵀ)⁻¹ τ", (o, t) => R(o) * J(o).Inverse * R(o).Transpose * t),
            new GainShape("inertia-not-turned", "I_ref⁻¹ τ", (o, t) => J(o).Inverse * t),
            new GainShape("torque-as-acceleration", "τ", (o, t) => t),
            new GainShape("not-inverted", "R I_ref Rᵀ τ", (o, t) => R(o) * J(o) * R(o).Transpose * t),
            new GainShape("not-inverted", "I_ref τ", (o, t) => J(o) * t),
            new GainShape("turned-the-wrong-way", "(Rᵀ I_ref R)⁻¹ τ", (o, t) => R(o).Transpose * J(o).Inverse * R(o) * t),
            new GainShape("transpose-missing", "(R I_ref R)⁻¹ τ", (o, t) => R(o).Transpose * J(o).Inverse * R(o).Transpose * t),
            new GainShape("transpose-missing", "R I_ref⁻¹ R τ", (o, t) => R(o) * J(o).Inverse * R(o) * t),
            new GainShape("turned-on-one-side", "(R I_ref)⁻¹ τ", (o, t) => J(o).Inverse * R(o).Transpose * t),
            new GainShape("turned-on-one-side", "(I_ref Rᵀ)⁻¹ τ", (o, t) => R(o) * J(o).Inverse * t),
            new GainShape("turned-on-one-side", "(Rᵀ I_ref)⁻¹ τ", (o, t) => J(o).Inverse * R(o) * t),
            new GainShape("turned-on-one-side", "(I_ref R)⁻¹ τ", (o, t) => R(o).Transpose * J(o).Inverse * t),
            new GainShape("transpose-missing", "R I_ref R τ", (o, t) => R(o) * J(o) * R(o) * t),
            new GainShape("turned-the-wrong-way", "Rᵀ I_ref R τ", (o, t) => R(o).Transpose * J(o) * R(o) * t),
            new GainShape("only-the-diagonal", "τᵢ / Iᵢᵢ", (o, t) => OverDiagonal(R(o) * J(o) * R(o).Transpose, t)),
            new GainShape("torque-turned", "R τ", (o, t) => R(o) * t),
            new GainShape("torque-turned", "Rᵀ τ", (o, t) => R(o).Transpose * t),
        };

        private static Matrix R(Observation o) => Matrix.Rotation(o.Before.Orientation.Normalized);

        private static Matrix J(Observation o) => Inertias.Kept(o);

        private static Vector OverDiagonal(Matrix m, Vector t) => new Vector(t.X / m.Row0.X, t.Y / m.Row1.Y, t.Z / m.Row2.Z);
    }
}
