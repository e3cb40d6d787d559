using System.Collections.Generic;

namespace RigidBodyDynamics.BitHash
{
    /// <summary>The bodies that are hard to follow, by every integrator, with short steps and with long ones.</summary>
    internal static class HardBodies
    {
        private const int StepsEach = 20;

        public static void Add(ref StateHash hash)
        {
            foreach (Rule rule in Rules.All)
            {
                foreach (double step in new[] { 0.1, 0.02, 0.001 })
                {
                    foreach (BodyDescription body in All())
                    {
                        body.Rule = rule;
                        body.Unity = new UnitySettings { InDouble = true };
                        try
                        {
                            Run(ref hash, new Simulation(TimeSteps.Every(step), body));
                        }
                        catch (StateOverflowException lost)
                        {
                            // an unstable integration has diverged: on every runtime in the same step
                            hash.Add((double)lost.Step);
                        }
                    }
                }
            }
        }

        private static void Run(ref StateHash hash, Simulation simulation)
        {
            for (int n = 0; n < StepsEach; n++)
            {
                simulation.Step();
                hash.Add(simulation.Bodies[0].State);
            }

            // read rarely, and continued from a saved state
            SavedSimulation saved = simulation.Save();
            simulation.Step(10);
            simulation.Restore(saved);
            simulation.Step(150);
            hash.Add(simulation.Bodies[0].State);
        }

        public static IEnumerable<BodyDescription> All()
        {
            yield return Free("tumbling", 1, 2, 3, new Vector3d(1, 1.1, 0.9));
            yield return Free("symmetric", 1, 1, 0.5, new Vector3d(3, 0, 10));
            yield return Free("tiny", 1e-18, 2e-18, 2.5e-18, new Vector3d(1, 2, -1.5));
            yield return Free("huge", 1e18, 2e18, 2.5e18, new Vector3d(1, 2, -1.5));
            yield return Free("almost symmetric", 1, 1 + 1e-9, 1.5, new Vector3d(1, 2, -1.5));
            yield return Free("almost spherical", 1, 1 - 1e-15, 1 + 1e-15, new Vector3d(1, 2, -1.5));
            yield return Free("flipping", 1, 2, 3, new Vector3d(1e-3, 5, 1e-3));
            yield return Free("hardly flipping", 1, 2, 3, new Vector3d(1e-300, 5, 0));
            yield return Free("on its middle axis", 1, 2, 3, new Vector3d(0, 5, 0));
            // √(I₃(I₃ − I₂)/(I₁(I₂ − I₁))) = √3: on the separatrix, to rounding
            yield return Free("separatrix", 1, 2, 3, new Vector3d(1.7320508075688772, 2, 1));
            yield return Free("plate", 1, 1.0001, 2, new Vector3d(3, 4, 20));
            yield return Free("needle", 1e-6, 1, 1, new Vector3d(1000, 0.5, 0.3));
            yield return Free("uneven needle", 1e-6, 1, 1 + 1e-7, new Vector3d(1000, 0.5, 0.3));
            yield return Free("fast", 1, 1.0001, 0.9999, new Vector3d(10000, 10, 20));
            yield return Free("resting", 1, 2, 3, Vector3d.Zero);
            yield return Free("almost resting", 1, 2, 3, new Vector3d(1e-160, 2e-160, 1e-310));
            yield return Free("far away", 1, 2, 3, new Vector3d(1, 1.1, 0.9), new Vector3d(1e9, -1e9, 1e9));
            yield return Free("damped", 1, 2, 3, new Vector3d(1, 1.1, 0.9)).With(new LinearDamping(1000)).With(new AngularDamping(1000));
            yield return Free("braked", 1, 2, 3, new Vector3d(1, 1.1, 0.9)).With(new DecayPerStep(1e-3, 1e-3));
            yield return Free("pushed in body axes", 1, 2, 3, new Vector3d(1, 1.1, 0.9)).With(Torque.Constant(new Vector3d(0, 0, 0.5)));
            yield return Free("pushed in world axes", 1, 2, 3, Vector3d.Zero)
                .With(new Torque(new Vector3d(0, 0, 0.1), new Vector3d(0.3, 0, 0), new Vector3d(0, 0.2, 0), 1, inBody: false));
            yield return Free("heavy top", 1, 1, 0.5, new Vector3d(0.1, 0, 8)).With(new HeavyTop(new Vector3d(0, 0, 1), 3, new Vector3d(0, 0, 1)));
            yield return Free("on a stiff spring", 1, 2, 3, Vector3d.Zero).With(new Spring(new Vector3d(0, 0.5, 0), Vector3d.Zero, 1e4));
            yield return Free("falling", 1, 1, 1, Vector3d.Zero).With(new Gravity(new Vector3d(0, -9.81, 0))).With(new QuadraticDrag(0.1));
        }

        private static BodyDescription Free(string name, double i1, double i2, double i3, Vector3d spin, Vector3d at = default(Vector3d)) =>
            new BodyDescription(name, MassProperties.FromPrincipal(1, new Vector3d(i1, i2, i3)))
            {
                Start = new BodyState(at, Quaterniond.Identity, new Vector3d(0.5, -1, 0.25), spin),
            };
    }
}
