#if NET
using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;

namespace RigidBodyDynamics
{
    /// <summary>Compares descriptions without their starts and names: bodies of equal descriptions move alike.</summary>
    internal sealed class Alike : IEqualityComparer<BodyDescription>
    {
        /// <summary>
        /// True if all effects are the library's own. Another push may not be safe for calls from several threads, unless the program says so
        /// by giving one description to several bodies; and a push that the program steers may differ from step to step.
        /// </summary>
        public static bool IsOrdinary(BodyDescription body) => body.Effects.All(effect => IsOurs(effect) && !(effect.Motion is IInput));

        public bool Equals(BodyDescription a, BodyDescription b)
        {
            bool areAlike = AreSame(a.Mass, b.Mass) && a.Rule == b.Rule && a.Lock == b.Lock && a.Effects.Count == b.Effects.Count
                && a.Lab.IsLike(b.Lab) && AreSame(a.Unity, b.Unity);
            for (int i = 0; areAlike && i < a.Effects.Count; i++)
                areAlike = AreSame(a.Effects[i], b.Effects[i]);

            return areAlike;
        }

        public int GetHashCode(BodyDescription body) =>
            HashCode.Combine(body.Rule, body.Mass.Mass, body.Mass.PrincipalMoments, body.Lock, body.Effects.Count);

        private static bool IsOurs(Effect effect) => effect.Motion.GetType().Assembly == typeof(Alike).Assembly;

        private static bool AreSame(Effect a, Effect b) =>
            a == b || (a.From == b.From && a.To == b.To && a.GetType() == b.GetType() && IsOurs(a) && a.Motion.Equals(b.Motion));

        private static bool AreSame(UnitySettings a, UnitySettings b) =>
            (a.Drag, a.AngularDrag, a.MaxAngularVelocity, a.SleepThreshold, a.WakeCounter, a.GyroscopicForces, a.InDouble, a.FirstOrderOrientation)
            == (b.Drag, b.AngularDrag, b.MaxAngularVelocity, b.SleepThreshold, b.WakeCounter, b.GyroscopicForces, b.InDouble, b.FirstOrderOrientation);

        private static bool AreSame(MassProperties a, MassProperties b) =>
            a == b || (AreBits(a.Mass, b.Mass) && AreBits(a.PrincipalMoments, b.PrincipalMoments) && AreBits(a.PrincipalFrame, b.PrincipalFrame)
                && AreBits(a.InversePrincipalMoments, b.InversePrincipalMoments) && AreBits(a.Inertia, b.Inertia) && AreBits(a.CenterOfMass, b.CenterOfMass));

        /// <summary>Zeros of different signs differ: results computed from them do.</summary>
        private static bool AreBits<T>(T a, T b) where T : struct =>
            MemoryMarshal.AsBytes(MemoryMarshal.CreateReadOnlySpan(ref a, 1)).SequenceEqual(MemoryMarshal.AsBytes(MemoryMarshal.CreateReadOnlySpan(ref b, 1)));
    }

    internal sealed partial class BodyPlan
    {
        /// <summary>The same plan for a body of another name.</summary>
        internal BodyPlan For(string name)
        {
            if (name == Asked.Name)
                return this;

            BodyPlan plan = (BodyPlan)MemberwiseClone();
            (plan.Asked, plan.Body) = (Asked.Copy(name, Asked.Mass), Body.Copy(name, Body.Mass));
            return plan;
        }
    }
}
#endif
