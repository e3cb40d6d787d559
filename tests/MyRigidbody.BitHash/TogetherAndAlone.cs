#if NET
using System;

namespace RigidBodyDynamics.BitHash
{
    /// <summary>Bodies that are stepped together beside the same bodies one by one, by every integrator: the work of lanes and threads on this runtime.</summary>
    internal static class TogetherAndAlone
    {
        private const int Bodies = 37;
        private static readonly TimeSteps Steps = TimeSteps.Every(0.02);

        /// <summary>Throws if a body among many has other bits than alone.</summary>
        public static void Compare()
        {
            foreach (Rule rule in Rules.All)
            {
                foreach (Vector3d moments in new[] { new Vector3d(1, 2, 3), new Vector3d(2, 2, 1), new Vector3d(1, 1, 1) })
                {
                    BodyDescription free = new BodyDescription("free", MassProperties.FromPrincipal(1, moments)) { Rule = rule };
                    Compare(free);
                    Compare(free.Copy("pushed", free.Mass)
                        .With(new Torque(new Vector3d(0.1, 0, 0.2), new Vector3d(0, 0.3, 0), Vector3d.Zero, 2, inBody: true))
                        .With(new Gravity(new Vector3d(0, -9.81, 0)))
                        .With(new QuadraticDrag(0.1)));
                }
            }
        }

        private static void Compare(BodyDescription body)
        {
            Simulation together = new Simulation(Steps) { Threads = OperatingSystem.IsBrowser() ? 1 : 2 };
            BodyDescription[] alone = new BodyDescription[Bodies];
            for (int i = 0; i < Bodies; i++)
            {
                BodyState start = new BodyState(
                    Vector3d.Zero, Quaterniond.Identity, new Vector3d(i, 1, 0), new Vector3d(0.1 * i, 3 - 0.2 * i, 0.01));
                together.Add(body, start);
                alone[i] = body.Copy("body " + i, body.Mass);
                alone[i].Start = start;
            }

            Simulation one = new Simulation(Steps, alone);
            together.Step(100);
            one.Step(100);
            for (int i = 0; i < Bodies; i++)
            {
                StateHash a = default(StateHash), b = default(StateHash);
                a.Add(together.Bodies[i].State);
                b.Add(one.Bodies[i].State);
                if (a.Value != b.Value)
                    throw new InvalidOperationException(body.Rule.Name + ", body " + i + ": other bits together than alone");
            }
        }
    }
}
#endif
