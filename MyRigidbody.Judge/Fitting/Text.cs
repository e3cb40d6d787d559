using System;
using System.Globalization;

namespace RigidBodyDynamics.Judging
{
    /// <summary>Numbers as findings show them.</summary>
    internal static class Text
    {
        /// <summary>Four digits.</summary>
        public static string Of(double value) => value.ToString(Math.Abs(value) >= 1000 || Math.Abs(value) < 0.001 && value != 0 ? "0.###e0" : "G4", CultureInfo.InvariantCulture);

        public static string Of(Vector v) => v.IsFinite ? $"({Of(v.X)}, {Of(v.Y)}, {Of(v.Z)})" : "NaN";
    }
}
