using System;
using System.Collections.Generic;

namespace RigidBodyDynamics
{
    /// <summary>Runs a scene in shorter and shorter steps.</summary>
    internal sealed class Refinement
    {
        private const double LongestBase = 0.1, Still = 1e-14, NearlyStill = 1e-9, LastBit = 1.0 / (1L << 52), Same = 1e-6;
        private const long MostSteps = 1L << 20, MostBaseSteps = MostSteps / 16;
        private const int Samples = 20;

        private readonly Scene _scene;
        private readonly string _integrator;
        private readonly double _baseStep;
        private readonly List<double> _cuts = new List<double>();
        private readonly List<long> _at = new List<long>();

        public Refinement(Scene scene)
        {
            _scene = scene;
            _integrator = HighestOrder();
            double duration = scene.Steps.StartOf(scene.Steps.Count);
            _baseStep = Math.Min(LongestBase, duration);
            double count = Math.Floor(duration / _baseStep + Same);
            if (!(count <= MostBaseSteps))
                throw Guard.Refused("duration", duration, "must be at most " + MostBaseSteps / 10 + " s to be refined");

            for (long n = 0; n <= count; n++)
                _cuts.Add(n * _baseStep);

            int samples = (int)Math.Min(count, Samples);
            for (int i = 1; i <= samples; i++)
                _at.Add((long)count * i / samples);

            foreach (BodyDescription body in scene.Bodies)
            {
                foreach (Effect effect in body.Effects)
                {
                    Cut(effect.From);
                    Cut(effect.To);
                }
            }
        }

        public Truth Run(Action<double> progress)
        {
            BodyState[][] last = Run(1, 0), best = last;
            int bestParts = 1;
            double uncertainty = double.PositiveInfinity;
            for (int parts = 2; parts * (_cuts.Count - 1) <= MostSteps && uncertainty > Still; parts *= 2)
            {
                BodyState[][] next = Run(parts, 0);
                double change = Largest(Apart(last, next));
                progress(parts * (_cuts.Count - 1.0) / MostSteps);
                last = next;
                // once it is small, a change that grows again is made of roundings
                if (!(change < uncertainty) && uncertainty < NearlyStill)
                    break;

                if (!(change < uncertainty))
                    continue;

                best = next;
                bestParts = parts;
                uncertainty = change;
            }

            if (!Guard.IsFinite(uncertainty))
                throw Guard.Refused("scene", _scene.Name, "must have a motion without infinite numbers");

            double[] up = Apart(best, Run(bestParts, 1)), mixed = Apart(best, Run(bestParts, -1));
            TruthSample[] samples = new TruthSample[_at.Count];
            double floor = 0;
            for (int i = 0; i < samples.Length; i++)
            {
                floor = Math.Max(floor, Math.Max(up[i], mixed[i]));
                samples[i] = new TruthSample(_at[i], Math.Min(floor, double.MaxValue), best[i]);
            }

            return new Truth(_baseStep, uncertainty, samples);
        }

        private static string HighestOrder()
        {
            CatalogueRow highest = Catalogue.Rows[0];
            foreach (CatalogueRow row in Catalogue.Rows)
            {
                // Unity's rule has limits of its own
                if (row.Order >= highest.Order && !(row is UnityRow))
                    highest = row;
            }

            return highest.Name;
        }

        private void Cut(double time)
        {
            int at = _cuts.BinarySearch(time);
            if (at >= 0 || !(time > 0 && time < _cuts[_cuts.Count - 1]))
                return;

            if (time - _cuts[~at - 1] > Same * _baseStep && _cuts[~at] - time > Same * _baseStep)
                _cuts.Insert(~at, time);
        }

        /// <summary>The states at all samples, with so many steps between two cuts; the start as it is, or moved by its last bits.</summary>
        private BodyState[][] Run(int parts, int nudge)
        {
            List<double> lengths = new List<double>(parts * _cuts.Count);
            for (int i = 1; i < _cuts.Count; i++)
            {
                for (int part = 0; part < parts; part++)
                    lengths.Add((_cuts[i] - _cuts[i - 1]) / parts);
            }

            Scene scene = StepFree.By(_scene, _integrator, TimeSteps.Of(lengths));
            foreach (BodyDescription body in scene.Bodies)
                body.Start = nudge == 0 ? body.Start : Nudged(body.Start, LastBit, nudge * LastBit);

            Simulation simulation = new Simulation(scene);
            BodyState[][] states = new BodyState[_at.Count][];
            for (int i = 0; i < states.Length; i++)
            {
                simulation.Step((long)_cuts.BinarySearch(_at[i] * _baseStep) * parts - simulation.StepsDone);
                states[i] = new BodyState[simulation.Bodies.Count];
                for (int j = 0; j < states[i].Length; j++)
                    states[i][j] = simulation.Bodies[j].State;
            }

            return states;
        }

        private static BodyState Nudged(in BodyState s, double e, double f) => new BodyState(
            Nudged(s.Position, e, f),
            new Quaterniond(s.Orientation.W * (1 + e), Nudged(s.Orientation.Vector, f, e)),
            Nudged(s.Velocity, f, e),
            Nudged(s.AngularVelocity, e, f));

        private static Vector3d Nudged(Vector3d v, double e, double f) => new Vector3d(v.X * (1 + e), v.Y * (1 + f), v.Z * (1 + e));

        private static double[] Apart(BodyState[][] a, BodyState[][] b)
        {
            double[] apart = new double[a.Length];
            for (int i = 0; i < apart.Length; i++)
                apart[i] = Truth.Apart(a[i], b[i]);

            return apart;
        }

        private static double Largest(double[] values)
        {
            double largest = 0;
            foreach (double value in values)
                largest = Math.Max(largest, value);

            return largest;
        }
    }
}
