using System;
using System.Globalization;

namespace RigidBodyDynamics.StepTimes
{
    /// <summary>The cost of steps, as ratios within one run; and the effect of a hundred million steps on a motion.</summary>
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

            if (arguments.Length > 0 && arguments[0] == "rules" && TryRepeats(arguments, out int repeats))
            {
                RuleTimes.Print(repeats);
                return 0;
            }

#if NET
            if (arguments.Length == 1 && arguments[0] == "batch")
            {
                BatchTimes.Print();
                return 0;
            }

#endif
            Console.Error.WriteLine("usage: StepTimes [endurance | batch | rules [REPEATS]]");
            return 2;
        }

        private static bool TryRepeats(string[] arguments, out int repeats)
        {
            repeats = 25;
            return arguments.Length == 1
                || (arguments.Length == 2 && int.TryParse(arguments[1], NumberStyles.None, CultureInfo.InvariantCulture, out repeats) && repeats > 0);
        }
    }
}
