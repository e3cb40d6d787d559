using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.Linq;

namespace RigidBodyDynamics.StepTimes
{
    /// <summary>
    /// One body by every integrator, for <c>bench</c>, which runs this program on Mono and on CoreCLR: lines of a name and the
    /// nanoseconds of a step, the least of many short runs in turn. Bodies and names are those of bench.csv.
    /// </summary>
    internal static class RuleTimes
    {
        private const double SecondsPerRun = 0.001, WarmUp = 0.3;

        public static void Print(int repeats)
        {
            List<Row> rows = new List<Row>();
            foreach (Rule rule in Rules.All)
                rows.Add(new Row("free body by " + rule.Name, Body(rule.Name, new Vector3d(1, 2, 3))));

            Vector3d push = new Vector3d(5, 1, 2);
            BodyDescription free = Body("LabEuler", new Vector3d(1, 2, 3)), cube = Body("LabEuler", new Vector3d(0.5, 0.5, 0.5));
            rows.Add(new Row("free body, number by number by hand", free, new ByHand(free, Vector3d.Zero, 0, 1, isTurned: false)));
            rows.Add(new Row("lab's step, number by number by hand", Lab(cube, push), new ByHand(cube, push, -9.81, 0.98, isTurned: true)));
            rows.Add(new Row("lab's step, by the library", Lab(cube, push)));

            foreach (Row row in rows)
                row.Warm();

            for (int i = 0; i < repeats; i++)
            {
                foreach (Row row in rows)
                    row.Run();
            }

            foreach (Row row in rows)
                Console.WriteLine(row.What + "," + row.Least.ToString("R", CultureInfo.InvariantCulture));
        }

        private static BodyDescription Lab(BodyDescription cube, Vector3d push) => cube.Copy(cube.Name, cube.Mass)
            .With(new Gravity(new Vector3d(0, -9.81, 0))).With(new DecayPerStep(0.98, 0.98)).With(new Force(push)).With(new KeyPush(LabKey.R));

        private static BodyDescription Body(string rule, Vector3d moments) => new BodyDescription("body", MassProperties.FromPrincipal(1, moments))
        {
            Rule = Rules.Named(rule),
            Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(1, 2, 3), new Vector3d(1, 1.1, 0.9)),
            Unity = new UnitySettings { MaxAngularVelocity = double.PositiveInfinity },
        };

        private sealed class Row
        {
            private readonly Action<long> _go;
            private readonly List<double> _times = new List<double>();
            private long _steps = 1;

            /// <param name="what">What it is.</param>
            /// <param name="body">The body, moved by the library.</param>
            /// <param name="byHand">Whose steps are timed instead; it comes to the same bits.</param>
            public Row(string what, BodyDescription body, ByHand byHand = null)
            {
                What = what;
                // what a step costs is asked for, so each is taken
                Simulation simulation = new Simulation(
                    new SceneDescription("rules", string.Empty, TimeSteps.Every(0.02), new[] { body }), Omissions.All & ~Omissions.Coasting);
                _go = byHand == null ? simulation.Step : (Action<long>)byHand.Step;
                if (byHand == null)
                    return;

                simulation.Step(200);
                byHand.Step(200);
                if (!byHand.State.Equals(simulation.Bodies[0].State))
                    throw new InvalidOperationException(what + ": " + byHand.State + " is not " + simulation.Bodies[0].State);
            }

            public string What { get; }

            public double Least => _times.Min();

            /// <summary>Many short calls first, because a runtime counts them before it compiles well; then as many steps as fill a run.</summary>
            public void Warm()
            {
                Stopwatch clock = Stopwatch.StartNew();
                double last = 0;
                while (clock.Elapsed.TotalSeconds < WarmUp)
                {
                    last = Seconds();
                    if (last < 1e-3)
                        _steps = Math.Min(2 * _steps, 1 << 16);
                }

                _steps = Math.Max(1, (long)(_steps * SecondsPerRun / Math.Max(last, 1e-9)));
            }

            public void Run() => _times.Add(1e9 * Seconds() / _steps);

            private double Seconds()
            {
                Stopwatch clock = Stopwatch.StartNew();
                _go(_steps);
                return clock.Elapsed.TotalSeconds;
            }
        }
    }
}
