namespace RigidBodyDynamics.BitHash
{
    /// <summary>
    /// Ten thousand steps with every integrator of the catalogue and every effect, and the fingerprint of all states
    /// on the way. Compiled into the tests and into a program of its own, which Mono runs.
    /// </summary>
    public static class BitHashScene
    {
        /// <summary>The number of steps that the fingerprint covers.</summary>
        public const int Steps = 10000;

        /// <summary>The fingerprint.</summary>
        public static ulong Compute()
        {
            StateHash hash = default(StateHash);
            foreach (Rule rule in Rules.All)
            {
                Simulation simulation = new Simulation(
                    TimeSteps.Every(1.0 / 60, Steps),
                    Everything("single", rule.Name, inDouble: false),
                    Everything("double", rule.Name, inDouble: true));
                for (int step = 0; step < Steps; step++)
                {
                    simulation.Step();
                    foreach (Body body in simulation.Bodies)
                        hash.Add(body.State);
                }
            }

            Free(ref hash);
            HardBodies.Add(ref hash);
            Lives.Add(ref hash);
            return hash.Value;
        }

        /// <summary>Free bodies, one of each kind of top, with short steps and with steps of many radians.</summary>
        private static void Free(ref StateHash hash)
        {
            Vector3d[] moments =
            {
                new Vector3d(1, 2, 3), new Vector3d(3, 1, 2.5), new Vector3d(1, 1, 0.5), new Vector3d(1e-3, 1, 1),
                new Vector3d(2, 2, 2),
            };
            foreach (Vector3d moment in moments)
            {
                foreach (double step in new[] { 1.0 / 60, 1.5, 40 })
                {
                    Simulation simulation = new Simulation(TimeSteps.Every(step), new BodyDescription("free", MassProperties.FromPrincipal(1, moment))
                    {
                        Rule = Rules.Exact,
                        Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(1, 2, 3), new Vector3d(0.3, 5.1, -0.2)),
                    });
                    for (int i = 0; i < 1000; i++)
                    {
                        simulation.Step();
                        hash.Add(simulation.Bodies[0].State);
                    }
                }
            }
        }

        /// <summary>A body under every effect of the library.</summary>
        public static BodyDescription Everything(string name, string integrator, bool inDouble)
        {
            MassProperties box = Solids.Box(2, new Vector3d(1, 2, 3));
            MassProperties arm = Solids.Capsule(0.5, 0.2, 1.5);
            MassProperties mass = new Compound()
                .With(box, new Vector3d(0.1, 0, 0))
                .With(arm, new Vector3d(0, 1, 0.3), Quaterniond.FromAxisAngle(new Vector3d(1, 1, 0), 0.7))
                .ToMassProperties();
            Vector3d[] kicks = { new Vector3d(1, 0, -2), new Vector3d(0.5, 0.25, 0), new Vector3d(0, -3, 1) };
            BodyDescription body = new BodyDescription(name, mass)
            {
                Rule = Rules.Named(integrator),
                Start = new BodyState(
                    new Vector3d(1, 2, 3),
                    new Quaterniond(0.8, 0.2, -0.4, 0.4),
                    new Vector3d(0.5, -1, 0.25),
                    new Vector3d(0.3, 1.1, -0.7)),
                Unity = new UnitySettings { Drag = 0.1, InDouble = inDouble },
            };
            return body
                .With(new Gravity(new Vector3d(0, -9.81, 0)), 0, 120)
                .With(new LinearDamping(0.05))
                .With(new AngularDamping(0.02))
                .With(new DecayPerStep(0.999, 0.998), 20, 90)
                .With(new Force(new Vector3d(0.5, 0, 0)), 1, 2)
                .With(new Torque(new Vector3d(0.1, 0, 0), new Vector3d(0, 0.2, 0), new Vector3d(0, 0, 0.3), 1.5, inBody: true), 0, 100)
                .With(new Torque(new Vector3d(0, 0.05, 0), new Vector3d(0.1, 0, 0.1), Vector3d.Zero, 0.5, inBody: false), 30, 130)
                .With(new KeyPush(LabKey.R), 0, 3)
                .With(new KeyPush(LabKey.RightArrow), 1, 2)
                .With(new QuadraticDrag(0.01))
                .With(new Spring(new Vector3d(0, 0.5, 0), new Vector3d(0, 3, 0), 4), 10, 160)
                .With(new Force(new Vector3d(0.2, 0, -0.1), at: new Vector3d(0, 0.3, 0), inBody: true), 50, 60)
                .With(new Force(new Vector3d(0.1, 0, 0.2), new Vector3d(0, 0.3, 0), new Vector3d(-0.1, 0, 0), 1.7), 55, 70)
                .With(new Force(new Vector3d(0, 0.2, 0.1), at: new Vector3d(0.2, 0, -0.3)), 60, 75)
                .With(new Impulse(new Vector3d(1, -0.5, 0.2), new Vector3d(0, 0.1, 0), at: new Vector3d(0.1, 0.2, 0)), 72)
                .With(new Impulse(new Vector3d(-1, 0.5, 0), inBody: true), 101)
                .With(new MassRate(-0.05), 150, 156)
                .With(new MassRate(0.02, Keeping.Momentum), 154, 160)
                .With(new HeavyTop(new Vector3d(0, 0, 1), 0.4, new Vector3d(0, 1, 0)), 40, 50)
                .With(new PerStep(kicks, kicks));
        }
    }
}
