using System;
using System.Globalization;

namespace RigidBodyDynamics.StepTimes
{
    /// <summary>
    /// The asymmetric top (1, 2, 3) turning freely for a billion steps of 1/50 s. The true attitudes are those of
    /// tests/data/random-bodies/generate.py, 20 digits, at that many times the double that 0.02 is.
    /// </summary>
    internal static class Endurance
    {
        private static readonly long[] Counts = { 10000, 1000000, 10000000, 100000000, 1000000000 };

        private static readonly Quaterniond[] True =
        {
            new Quaterniond(0.9787385627317974297, 0.12603905629423187765, 0.037269917438896361331, -0.15746725172000914816),
            new Quaterniond(0.1611699631481605012, -0.45574361059595009218, -0.0052153295676327061807, -0.87538266187838594231),
            new Quaterniond(0.74608565456586463063, -0.66064348133727862296, 0.028896235698014413303, 0.077919151561544270475),
            new Quaterniond(0.85843883480097649383, -0.30636171531918351532, 0.24032128511296928045, -0.33387264969428129962),
            new Quaterniond(-0.96305121861850292822, 0.16144315817641249168, -0.029768504412004570071, -0.21350010103162668008),
        };

        public static bool Run()
        {
            // every step is taken: left to itself a free body is not stepped at all
            BodyDescription[] bodies =
            {
                new BodyDescription("top", MassProperties.FromPrincipal(1, new Vector3d(1, 2, 3)))
                {
                    Rule = Rules.Exact,
                    Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, new Vector3d(1, 1.1, 0.9)),
                },
            };
            Simulation simulation = new Simulation(new SceneDescription("top", string.Empty, TimeSteps.Every(0.02), bodies), Omissions.None);
            Body body = simulation.Bodies[0];
            double energy = body.KineticEnergy;
            Vector3d momentum = body.AngularMomentum;
            bool holds = true;
            Console.WriteLine("steps, energy, |L|, vector L (relative), |q| - 1, attitude (rad), attitude per step");
            for (int i = 0; i < Counts.Length; i++)
            {
                GoTo(simulation, Counts[i]);
                double e = 0, length = 0, vector = 0, norm = Math.Abs(body.State.Orientation.Length - 1);
                double angle = Conserved.AngleBetween(body.State.Orientation, True[i]), rate = angle / Counts[i];
                // the mean over some steps: a state in world axes is itself rounded by about this much
                const int Some = 1000;
                for (int n = 0; n < Some; n++)
                {
                    e += (body.KineticEnergy / energy - 1) / Some;
                    length += (body.AngularMomentum.Length / momentum.Length - 1) / Some;
                    vector = Math.Max(vector, (body.AngularMomentum - momentum).Length / momentum.Length);
                    simulation.Step();
                }

                // the vector no worse than roundings that add up at random
                holds &= Math.Abs(e) < 1e-15 && Math.Abs(length) < 1e-15 && norm < 1e-15 && rate < 1e-17
                    && vector < 1e-14 + 1.2e-16 * Math.Sqrt(Counts[i]);
                Console.WriteLine(string.Format(
                    CultureInfo.InvariantCulture, "{0}, {1:0.0e+0}, {2:0.0e+0}, {3:0.0e+0}, {4:0.0e+0}, {5:0.0e+0}, {6:0.0e+0}",
                    Counts[i],
                    e,
                    length,
                    vector,
                    norm,
                    angle,
                    rate));
            }

            Console.WriteLine(holds ? "within 1e-15 of energy, |L| and |q|, 1e-17 rad a step" : "out of bounds");
            return holds & HardCases();
        }

        /// <summary>A million steps of each hard case: no number is lost, and where nothing acts energy and |L| stay.</summary>
        private static bool HardCases()
        {
            bool holds = true;
            Console.WriteLine("a million steps of 1/50 s, Exact: energy, |L| (relative, where nothing acts)");
            foreach (BodyDescription description in BitHash.HardBodies.All())
            {
                description.Rule = Rules.Exact;
                Simulation simulation = new Simulation(new SceneDescription("hard", string.Empty, TimeSteps.Every(0.02), new[] { description }), Omissions.None);
                Body body = simulation.Bodies[0];
                double energy = body.KineticEnergy, length = body.AngularMomentum.Length;
                simulation.Step(1000000);
                bool isFree = description.Effects.Count == 0, isFine = body.State.IsFinite;
                double e = isFree ? Math.Abs(body.KineticEnergy / energy - 1) : 0;
                double l = isFree && length > 0 ? Math.Abs(body.AngularMomentum.Length / length - 1) : 0;
                // a needle rotates at 1000 rad/s, and its ω in world axes is rounded accordingly: 1e-13 across the axis
                isFine &= e < 1e-11 && l < 1e-11;
                holds &= isFine;
                string kept = isFree ? string.Format(CultureInfo.InvariantCulture, "{0,10:0.0e+0}{1,10:0.0e+0}", e, l) : "    finite";
                Console.WriteLine("{0,-22}{1}{2}", description.Name, kept, isFine ? "" : "  LOST");
            }

            return holds;
        }

        /// <summary>With a line for every hundred million steps.</summary>
        private static void GoTo(Simulation simulation, long step)
        {
            const long Part = 100000000;
            while (simulation.StepsDone < step)
            {
                simulation.Step(Math.Min(step - simulation.StepsDone, Part));
                if (step > Part)
                    Console.WriteLine("... " + simulation.StepsDone / 1000000 + " million steps");
            }
        }
    }
}
