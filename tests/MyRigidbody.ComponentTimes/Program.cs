using System;
using System.Diagnostics;
using System.Globalization;
using RigidBodyDynamics.Engine;
using RigidBodyDynamics.Scripts;
using UnityEngine;

namespace RigidBodyDynamics.ComponentTimes
{
    /// <summary>
    /// What a fixed step of the component costs on the stand-in for the engine: keys, the step of the library, the pose.
    /// With "R" held, so that all five formulas are computed.
    /// </summary>
    internal static class Program
    {
        private const int Steps = 20000, Turns = 40;

        private static void Main()
        {
            Console.WriteLine("one fixed step of the component, ns: box, R held");
            foreach (Rule rule in Rules.All)
                Console.WriteLine(string.Format(CultureInfo.InvariantCulture, "{0,-20}{1,10:f0}", rule.Name, Least(rule.Name)));
        }

        private static double Least(string rule)
        {
            World.Begin(isPlaying: true);
            GameObject box = new GameObject("box");
            box.transform.localScale = new Vector3(1, 2, 3);
            Scripts.MyRigidbody body = box.AddComponent<Scripts.MyRigidbody>();
            body.integrator = rule;
            body.StartAgain();
            LabInput.HoldOnScreen(LabKey.R, true);
            double least = double.PositiveInfinity;
            for (int turn = 0; turn < Turns; turn++)
            {
                Stopwatch clock = Stopwatch.StartNew();
                for (int step = 0; step < Steps / Turns; step++)
                    body.Step();

                least = Math.Min(least, clock.Elapsed.TotalMilliseconds * 1e6 / (Steps / Turns));
            }

            return least;
        }
    }
}
