using System;
using System.Diagnostics;
using System.Globalization;
using RigidBodyDynamics.Engine;
using RigidBodyDynamics.Scripts;
using UnityEngine;

namespace RigidBodyDynamics.ComponentTimes
{
    /// <summary>
    /// The cost of a fixed step of the component on the stand-in for the engine: keys, the step of the library, the pose.
    /// With "R" held, so that all five formulas are computed. And the additional cost of ExactRotation on Unity's own body.
    /// </summary>
    internal static class Program
    {
        private const int Steps = 20000, Turns = 40;

        private static void Main()
        {
            Console.WriteLine("one fixed step of the component, ns: box, R held");
            foreach (Rule rule in Rules.All)
                Write(rule.Name, Step(rule.Name));

            Console.WriteLine("what ExactRotation computes in a fixed step of a Rigidbody, ns; what the engine is asked and told is not in it");
            Write("turning freely", Exact(isPushed: false));
            Write("pushed in each step", Exact(isPushed: true));
        }

        private static double Exact(bool isPushed)
        {
            const float step = 0.02f;
            ExactTop top = new ExactTop();
            EngineBody body = new EngineBody
            {
                Orientation = Quaterniond.Identity,
                AngularVelocity = new Vector3d(0.02f, 6, 0.01f),
                Mass = 1,
                InertiaTensor = new Vector3d(0.0142f, 0.0842f, 0.0967f),
                InertiaTensorRotation = Quaterniond.Identity,
            };
            return Least(() =>
            {
                body.AngularVelocity = top.Before(body, step) ?? body.AngularVelocity;
                // what the engine does in its step
                body.Orientation = top.State.Orientation.Float().Double();
                if (isPushed)
                    body.AngularVelocity.X += 1e-3f;

                body.AngularVelocity = top.After(body) ?? body.AngularVelocity;
            });
        }

        private static double Step(string rule)
        {
            World.Begin(isPlaying: true);
            GameObject box = new GameObject("box");
            box.transform.localScale = new Vector3(1, 2, 3);
            Scripts.MyRigidbody body = box.AddComponent<Scripts.MyRigidbody>();
            body.integrator = rule;
            body.StartAgain();
            LabInput.HoldOnScreen(LabKey.R, true);
            return Least(body.Step);
        }

        private static double Least(Action once)
        {
            double least = double.PositiveInfinity;
            for (int turn = 0; turn < Turns; turn++)
            {
                Stopwatch clock = Stopwatch.StartNew();
                for (int step = 0; step < Steps / Turns; step++)
                    once();

                least = Math.Min(least, clock.Elapsed.TotalMilliseconds * 1e6 / (Steps / Turns));
            }

            return least;
        }

        private static void Write(string what, double time) =>
            Console.WriteLine(string.Format(CultureInfo.InvariantCulture, "{0,-22}{1,8:f0}", what, time));
    }
}
