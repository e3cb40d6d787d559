using System;
using System.Globalization;

namespace RigidBodyDynamics.StepTimes
{
    /// <summary>
    /// The asymmetric top (1, 2, 3) turning freely for a hundred million steps of 1/50 s. The true attitudes are those of
    /// tests/data/random-bodies/generate.py, 20 digits, at that many times the double that 0.02 is.
    /// </summary>
    internal static class Endurance
    {
        private static readonly long[] Counts = { 10000, 1000000, 10000000, 100000000 };

        private static readonly Quaterniond[] True =
        {
            new Quaterniond(0.9787385627317974297, 0.12603905629423187765, 0.037269917438896361331, -0.15746725172000914816),
            new Quaterniond(0.1611699631481605012, -0.45574361059595009218, -0.0052153295676327061807, -0.87538266187838594231),
            new Quaterniond(0.74608565456586463063, -0.66064348133727862296, 0.028896235698014413303, 0.077919151561544270475),
            new Quaterniond(0.85843883480097649383, -0.30636171531918351532, 0.24032128511296928045, -0.33387264969428129962),
        };

        public static bool Run()
        {
            // every step is taken: left to itself a free body is not stepped at all
            BodyDescription[] bodies =
            {
                new BodyDescription("top", MassProperties.FromPrincipal(1, new Vector3d(1, 2, 3)))
                {
                    Integrator = "Exact",
                    Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, new Vector3d(1, 1.1, 0.9)),
                },
            };
            Simulation simulation = new Simulation(new Scene("top", string.Empty, TimeSteps.Every(0.02), bodies), Omissions.None);
            Body body = simulation.Bodies[0];
            double energy = body.KineticEnergy;
            Vector3d momentum = body.AngularMomentum;
            bool holds = true;
            Console.WriteLine("steps, energy, |L|, vector L (relative), attitude (rad), attitude per step");
            for (int i = 0; i < Counts.Length; i++)
            {
                simulation.Step(Counts[i] - simulation.StepsDone);
                double e = 0, length = 0, vector = 0;
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

                holds &= Math.Abs(e) < 1e-15 && Math.Abs(length) < 1e-15 && vector < 1e-12 && rate < 1e-17;
                Console.WriteLine(string.Format(
                    CultureInfo.InvariantCulture, "{0}, {1:0.0e+0}, {2:0.0e+0}, {3:0.0e+0}, {4:0.0e+0}, {5:0.0e+0}", Counts[i], e, length, vector, angle, rate));
            }

            Console.WriteLine(holds ? "within 1e-15 of energy and |L|, 1e-17 rad a step" : "out of bounds");
            return holds;
        }
    }
}
