namespace RigidBodyDynamics.BitHash
{
    /// <summary>Bodies that are added, removed, pushed, set and changed while others run, by every integrator.</summary>
    internal static class Lives
    {
        public static void Add(ref StateHash hash)
        {
            foreach (Rule rule in Rules.All)
                Add(ref hash, rule);
        }

        private static void Add(ref StateHash hash, Rule rule)
        {
            Simulation simulation = new Simulation(TimeSteps.Every(1.0 / 60));
            Vector3d a = new Vector3d(0.3, -0.2, 0.5), b = new Vector3d(0.1, 0.7, -0.4);
            Body first = simulation.Add(Top("first", rule, 1, 2, 3)), second = simulation.Add(Top("second", rule, 2, 2, 1));
            simulation.Step(40);
            Body third = simulation.Add(new BodyDescription("third", MassProperties.FromPrincipal(1, new Vector3d(1, 1, 1))) { Rule = rule });
            first.ApplyImpulse(a, b);
            third.ApplyAngularImpulse(b, inBody: true);
            for (int i = 0; i < 50; i++)
            {
                first.ApplyForce(a, b, inBody: true);
                second.ApplyForce(b, a);
                third.ApplyTorque(a);
                simulation.StepBy(0.01 + 0.0007 * (i % 9));
                simulation.Advance(0.0131);
                See(ref hash, simulation);
            }

            third.State = new BodyState(a, new Quaterniond(0.8, 0, 0.6, 0), b, a);
            second.Change(Top("changed", rule, 1, 1.5, 1.5).With(new QuadraticDrag(0.1), 0, 4), Keeping.Momentum);
            SavedSimulation saved = simulation.Save();
            simulation.Step(100);
            See(ref hash, simulation);
            simulation.Remove(first);
            simulation.Step(30);
            See(ref hash, simulation);
            simulation.Restore(saved);
            simulation.Step(131);
            See(ref hash, simulation);
        }

        private static void See(ref StateHash hash, Simulation simulation)
        {
            hash.Add(simulation.Time);
            foreach (Body body in simulation.Bodies)
            {
                hash.Add(body.State);
                hash.Add(body.Between(simulation.Alpha));
            }
        }

        private static BodyDescription Top(string name, Rule rule, double i1, double i2, double i3) => new BodyDescription(
            name,
            MassProperties.FromPrincipal(1, new Vector3d(i1, i2, i3), new Quaterniond(0.8, 0.6, 0, 0), new Vector3d(0.1, 0, -0.2)))
        {
            Rule = rule,
            Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(0.5, -1, 0.25), new Vector3d(1, 2, -1.5)),
            Unity = new UnitySettings { InDouble = true },
        }.With(new Gravity(new Vector3d(0, -1, 0))).With(new Force(new Vector3d(0.2, 0, 0)), 1, 2);
    }
}
