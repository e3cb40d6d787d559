#if NET
using System;
using System.Diagnostics;
using System.Globalization;
using System.Numerics;
using System.Runtime.InteropServices;

namespace RigidBodyDynamics.StepTimes
{
    /// <summary>Many bodies together, compared with the same bodies one by one, and with the bandwidth of memory.</summary>
    internal static class BatchTimes
    {
        private const int InCache = 1000, InMemory = 1000000, Turns = 300, StepsOfTurn = 10;
        private static readonly TimeSteps Steps = TimeSteps.Every(0.02);

        public static void Print()
        {
            Console.WriteLine(Vector<double>.Count + " lanes, " + InCache + " bodies, one thread, ns a step: each alone, all together, ratio");
            Compare("Exact, free, three moments", () => Body(1, 2, 3));
            Compare("Exact, free, two equal", () => Body(1, 1, 0.5));
            Compare("Exact, free, all equal", () => Body(1, 1, 1));
            Compare("Exact, damped, three moments", () => Body(1, 2, 3).With(new AngularDamping(0.01)));
            Compare("Exact, torque in body axes", () => Body(1, 2, 3).With(new Torque(new Vector3d(0, 0, 0.5), Vector3d.Zero, Vector3d.Zero, 0, true)));
            Compare("Exact, torque by sin t", () => Body(1, 2, 3).With(Swinging));
            Compare("Exact, spring (one by one)", () => Body(1, 2, 3).With(new Spring(new Vector3d(0, 0.5, 0), Vector3d.Zero, 4)));
            Compare("Exact, translation alone", () => Held().With(new Gravity(new Vector3d(0, -9.81, 0))));
            Compare("LabEuler, free", () => Lab().With(new Gravity(new Vector3d(0, -9.81, 0))));
            Compare("LabEuler, torque by sin t", () => Lab().With(Swinging));

            Damped("LabEuler, damped by 0.98 a step", Lab().With(new DecayPerStep(0.98, 0.98)));
            Damped("Exact, damped", Body(1, 2, 3).With(new LinearDamping(1)).With(new AngularDamping(1)));

            Console.WriteLine(InMemory + " bodies: GB/s of an in-place scale, ns a step, its GB/s, their share, gain by two threads");
            Stream("Exact, free, three moments", Body(1, 2, 3), 32 + 17);
            Stream("LabEuler, free", Lab(), 13 + 13);
            Stream("Exact, translation alone", Held(), 6 + 3);
            Coasting();
        }

        private static Torque Swinging => new Torque(new Vector3d(0, 0, 0.1), new Vector3d(0.3, 0, 0), new Vector3d(0, 0.2, 0), 1, false);

        private static void Compare(string what, Func<BodyDescription> make)
        {
            Simulation batch = Many(make(), InCache);
            BodyDescription[] bodies = new BodyDescription[InCache];
            for (int i = 0; i < InCache; i++)
            {
                bodies[i] = make().Copy("body " + i, make().Mass);
                bodies[i].Start = batch.Bodies[i].State;
            }

            Simulation alone = new Simulation(new SceneDescription("alone", string.Empty, Steps, bodies), Omissions.None);
            double one = double.PositiveInfinity, all = double.PositiveInfinity;
            for (int turn = 0; turn < Turns; turn++)
            {
                one = Math.Min(one, Time(() => Repeat(alone.Step)));
                all = Math.Min(all, Time(() => Repeat(() => batch.Step())));
            }

            const double Each = 1e-9 * InCache * StepsOfTurn;
            Write("{0,-32}{1,8:f1}{2,8:f1}{3,8:f2}", what, one / Each, all / Each, one / all);
        }

        private static void Damped(string what, BodyDescription body)
        {
            Simulation fresh = Many(body, InCache), damped = Many(body, InCache);
            damped.Step(100000);
            double first = double.PositiveInfinity, last = double.PositiveInfinity;
            for (int turn = 0; turn < Turns; turn++)
            {
                last = Math.Min(last, Time(() => Repeat(() => damped.Step())));
                first = Math.Min(first, Time(() => Repeat(() => fresh.Step())));
            }

            Write("{0,-32}time of a step after 100,000 of them against the first: {1:f2}", what, last / first);
        }

        private static void Stream(string what, BodyDescription body, int numbers)
        {
            Simulation batch = Many(body, InMemory);
            double[] scaled = new double[32 * InMemory];
            double scale = double.PositiveInfinity, one = double.PositiveInfinity, two = double.PositiveInfinity;
            for (int turn = 0; turn < 12; turn++)
            {
                scale = Math.Min(scale, Time(() => Scale(scaled)));
                batch.Threads = 1;
                one = Math.Min(one, Time(() => batch.Step()));
                batch.Threads = 2;
                two = Math.Min(two, Time(() => batch.Step()));
            }

            double whole = 16.0 * scaled.Length / scale * 1e-9, rate = 8.0 * numbers * InMemory / one * 1e-9;
            Write("{0,-32}{1,8:f1}{2,8:f2}{3,8:f1}{4,8:f2}{5,8:f2}", what, whole, one / InMemory * 1e9, rate, rate / whole, one / two);
        }

        private static void Coasting()
        {
            Simulation stepped = Many(Body(1, 2, 3), InMemory / 10), waits = Many(Body(1, 2, 3), InMemory / 10, Omissions.Coasting);
            // about the unstable axis there is no closed form
            foreach (Body body in waits.Bodies)
            {
                BodyState start = body.State;
                start.AngularVelocity = start.Orientation.Rotate(new Vector3d(3, start.Velocity.Y, start.Velocity.Z));
                body.State = start;
            }

            double step = double.PositiveInfinity, wait = double.PositiveInfinity, form = double.PositiveInfinity, look = double.PositiveInfinity;
            for (int turn = 0; turn < 20; turn++)
            {
                step = Math.Min(step, Time(() => stepped.Step()));
                wait = Math.Min(wait, Time(() => waits.Step(1280)));
                form = Math.Min(form, Time(() => Read(waits)));
                look = Math.Min(look, Time(() => Read(waits)));
            }

            Write(
                "{0} coasting bodies: 1280 steps unseen take {1:e1} of one step, the closed form {2:f1} steps, looking at all {3:f1} steps",
                stepped.Bodies.Count, wait / step, (form - look) / step, look / step);
        }

        private static void Scale(double[] numbers)
        {
            Vector<double> factor = new Vector<double>(1.0000001);
            Span<Vector<double>> lanes = MemoryMarshal.Cast<double, Vector<double>>(numbers);
            for (int i = 0; i < lanes.Length; i++)
                lanes[i] *= factor;
        }

        private static void Read(Simulation simulation)
        {
            foreach (Body body in simulation.Bodies)
                _ = body.State;
        }

        private static Simulation Many(BodyDescription body, int count, Omissions mayLeaveOut = Omissions.None)
        {
            Random random = new Random(1);
            Simulation batch = new Simulation(new SceneDescription("many", string.Empty, Steps, new BodyDescription[0]), mayLeaveOut) { Threads = 1 };
            for (int i = 0; i < count; i++)
            {
                Vector3d w = body.CanTurn ? Any(random) : Vector3d.Zero;
                batch.Add(body, new BodyState(Any(random), new Quaterniond(1, Any(random)).Normalized, Any(random), w));
            }

            return batch;
        }

        private static Vector3d Any(Random random) =>
            new Vector3d(2 * random.NextDouble() - 1, 2 * random.NextDouble() - 1, 2 * random.NextDouble() - 1);

        private static BodyDescription Body(double i1, double i2, double i3) =>
            new BodyDescription("body", MassProperties.FromPrincipal(1, new Vector3d(i1, i2, i3)));

        private static BodyDescription Held() =>
            new BodyDescription("body", MassProperties.FromPrincipal(1, new Vector3d(1, 2, 3))) { CanTurn = false };

        private static BodyDescription Lab() =>
            new BodyDescription("body", MassProperties.FromPrincipal(1, new Vector3d(1, 2, 3))) { Rule = Rules.LabEuler };

        private static void Repeat(Action step)
        {
            for (int i = 0; i < StepsOfTurn; i++)
                step();
        }

        private static double Time(Action act)
        {
            Stopwatch clock = Stopwatch.StartNew();
            act();
            return clock.Elapsed.TotalSeconds;
        }

        private static void Write(string format, params object[] values) =>
            Console.WriteLine(string.Format(CultureInfo.InvariantCulture, format, values));
    }
}
#endif
