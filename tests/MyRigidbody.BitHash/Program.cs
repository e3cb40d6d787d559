using System;
using System.Globalization;

namespace RigidBodyDynamics.BitHash
{
    internal static class Program
    {
        private static void Main()
        {
#if NET
            TogetherAndAlone.Compare();
#endif
            Console.WriteLine(BitHashScene.Compute().ToString("x16", CultureInfo.InvariantCulture));
        }
    }
}
