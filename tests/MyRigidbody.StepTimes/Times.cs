using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;

namespace RigidBodyDynamics.StepTimes
{
    /// <summary>Nanoseconds a step: the shortest of many short runs, all rows alternately, so that noise affects all of them alike.</summary>
    internal static class Times
    {
        private const int Turns = 400, StepsAlone = 1000, Many = 1000, StepsOfMany = 10;
        private static readonly string[] Rows = { "LabEuler", "Splitting", "RungeKutta4", "Exact", "Exact4", "Exact6" };

        private static readonly KeyValuePair<string, Func<BodyDescription>>[] Motions =
        {
            Motion("free, three moments", () => Body(1, 2, 3)),
            Motion("free, two equal", () => Body(1, 1, 0.5)),
            Motion("free, all equal", () => Body(1, 1, 1)),
            Motion("torque in body axes", () => Body(1, 2, 3).With(new Torque(new Vector3d(0, 0, 0.5), Vector3d.Zero, Vector3d.Zero, 0, true))),
            Motion("torque by sin t", () => Body(1, 2, 3).With(
                new Torque(new Vector3d(0, 0, 0.1), new Vector3d(0.3, 0, 0), new Vector3d(0, 0.2, 0), 1, false))),
        };

        public static void Print()
        {
            double[,] alone = Measure(1, StepsAlone), many = Measure(Many, StepsOfMany);
            Print("one body", alone);
            Print(Many + " bodies", many);

            Console.WriteLine();
            // LabEuler omits I = R I_ref Rᵀ where no torque acts; under a torque it computes all five formulas
            Compare("Exact, free, against the lab's five formulas, one body", alone[0, 3] / alone[3, 0]);
            Compare("Exact, free, against the lab's five formulas, " + Many + " bodies", many[0, 3] / many[3, 0]);
            Compare("Exact, free, against the lab's step of the same free body, one body", alone[0, 3] / alone[0, 0]);
            Compare("Exact, free, against the lab's step of the same free body, " + Many + " bodies", many[0, 3] / many[0, 0]);

            FreeMotion motion = new FreeMotion(Body(1, 2, 3));
            double call = double.PositiveInfinity;
            for (int turn = 0; turn < Turns; turn++)
            {
                Stopwatch clock = Stopwatch.StartNew();
                for (int i = 0; i < 100; i++)
                    motion.At(200 + i);

                call = Math.Min(call, clock.Elapsed.TotalMilliseconds * 1e6 / 100);
            }

            Console.WriteLine(string.Format(CultureInfo.InvariantCulture, "state after 200 s in one call: {0:f0} ns", call));
        }

        private static void Compare(string what, double ratio) =>
            Console.WriteLine(string.Format(CultureInfo.InvariantCulture, "{0}: {1:f2}", what, ratio));

        private static void Print(string title, double[,] times)
        {
            Console.WriteLine(title + ", ns a step");
            Console.WriteLine(string.Format("{0,-22}{1,12}{2,12}{3,12}{4,12}{5,12}{6,12}", (object[])With(string.Empty, Rows)));
            for (int i = 0; i < Motions.Length; i++)
            {
                Console.Write("{0,-22}", Motions[i].Key);
                for (int j = 0; j < Rows.Length; j++)
                    Console.Write(string.Format(CultureInfo.InvariantCulture, "{0,12:f1}", times[i, j]));

                Console.WriteLine();
            }
        }

        private static string[] With(string first, string[] rest)
        {
            string[] all = new string[rest.Length + 1];
            all[0] = first;
            rest.CopyTo(all, 1);
            return all;
        }

        private static double[,] Measure(int bodies, int steps)
        {
            double[,] least = new double[Motions.Length, Rows.Length];
            for (int turn = 0; turn < (bodies == 1 ? Turns : Turns / 8); turn++)
            {
                for (int i = 0; i < Motions.Length; i++)
                {
                    for (int j = 0; j < Rows.Length; j++)
                    {
                        double time = Run(Motions[i].Value, Rows[j], bodies, steps);
                        least[i, j] = turn == 0 ? time : Math.Min(least[i, j], time);
                    }
                }
            }

            return least;
        }

        private static double Run(Func<BodyDescription> make, string row, int bodies, int steps)
        {
            BodyDescription[] all = new BodyDescription[bodies];
            for (int i = 0; i < bodies; i++)
            {
                BodyDescription like = make();
                all[i] = like.Copy("body " + i, like.Mass);
                all[i].Rule = Rules.Named(row);
            }

            Simulation simulation = new Simulation(new SceneDescription(row, string.Empty, TimeSteps.Every(0.02), all), Omissions.None);
            Stopwatch clock = Stopwatch.StartNew();
            if (bodies == 1)
            {
                simulation.Step(steps);
            }
            else
            {
                for (int i = 0; i < steps; i++)
                    simulation.Step();
            }

            return clock.Elapsed.TotalMilliseconds * 1e6 / ((double)steps * bodies);
        }

        private static KeyValuePair<string, Func<BodyDescription>> Motion(string name, Func<BodyDescription> make) =>
            new KeyValuePair<string, Func<BodyDescription>>(name, make);

        private static BodyDescription Body(double i1, double i2, double i3) =>
            new BodyDescription("body", MassProperties.FromPrincipal(1, new Vector3d(i1, i2, i3)))
            {
                Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(1, 2, 3), new Vector3d(1, 1.1, 0.9)),
            };
    }
}
