using System;

namespace RigidBodyDynamics.StepTimes
{
    /// <summary>What steps cost, as ratios within one run; and what a hundred million of them do to a motion.</summary>
    internal static class Program
    {
        private static int Main(string[] arguments)
        {
            if (arguments.Length == 0)
            {
                Times.Print();
                return 0;
            }

            if (arguments.Length == 1 && arguments[0] == "endurance")
                return Endurance.Run() ? 0 : 1;

#if NET
            if (arguments.Length == 1 && arguments[0] == "batch")
            {
                BatchTimes.Print();
                return 0;
            }

#endif
            Console.Error.WriteLine("usage: StepTimes [endurance | batch]");
            return 2;
        }
    }
}
