using System;

namespace RigidBodyDynamics
{
    /// <summary>
    /// Sine and cosine of a float, as in the C library of the Unity recordings: polynomials in double whose degree is so low that
    /// one result in ten thousand is not the nearest float. Near an unstable axis such a last bit grows, so a model that repeats
    /// recordings must reproduce it.
    /// </summary>
    /// <remarks>The coefficients are those of Sun's fdlibm as musl's sinf and cosf have them.</remarks>
    internal static class SingleSine
    {
        private const double Sine1 = -0.166666666416265235595;
        private const double Sine2 = 0.0083333293858894631756;
        private const double Sine3 = -0.000198393348360966317347;
        private const double Sine4 = 0.0000027183114939898219064;

        private const double Cosine1 = -0.499999997251031003120;
        private const double Cosine2 = 0.0416666233237390631894;
        private const double Cosine3 = -0.00138867637746099294692;
        private const double Cosine4 = 0.0000243904487962774090654;

        private const double TwoOverPi = 0.63661977236758134308;
        private const double HalfPi = 1.57079632679489661923;

        // π/2 in two parts: 25 bits, whose product with a number of quarter revolutions is exact, and the rest
        private const double HalfPiHigh = 1.57079631090164184570;
        private const double HalfPiLow = 1.58932547735281966916e-8;
        private const double Largest = 4.2e8;

        /// <summary>In double, before the rounding to float; abs(x) beyond 4.2e8 rad is computed by <see cref="Elementary"/>.</summary>
        public static void SinCos(double x, out double sin, out double cos)
        {
            double a = Math.Abs(x);
            if (!(a <= Largest))
            {
                Elementary.SinCos(x, out sin, out cos);
                return;
            }

            // up to two revolutions are subtracted by one subtraction and its rounding, more by two: the last bits depend on it
            double quarters = Math.Floor(a * TwoOverPi + 0.5);
            double r = quarters <= 4 ? a - quarters * HalfPi : a - quarters * HalfPiHigh - quarters * HalfPiLow;
            double s = Sine(r), c = Cosine(r);
            switch ((long)quarters & 3)
            {
                case 0: sin = s; cos = c; break;
                case 1: sin = c; cos = -s; break;
                case 2: sin = -s; cos = -c; break;
                default: sin = -c; cos = s; break;
            }

            if (x < 0)
                sin = -sin;
        }

        private static double Sine(double r)
        {
            double z = r * r, cube = z * r;
            return r + cube * (Sine1 + z * Sine2) + cube * (z * z) * (Sine3 + z * Sine4);
        }

        private static double Cosine(double r)
        {
            double z = r * r, square = z * z;
            return 1 + z * Cosine1 + square * Cosine2 + square * z * (Cosine3 + z * Cosine4);
        }
    }
}
