using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Random sequences of all operations, compared with the same by other means.</summary>
public sealed class RandomLifeTests
{
    private static IEnumerable<int> Seeds => Enumerable.Range(1, 10);

    [TestCaseSource(nameof(Seeds))]
    public void Every_body_comes_to_the_bits_that_it_has_in_a_simulation_of_its_own(int seed)
    {
        Life life = new(seed, 200, [.. Scenery.Integrators]);
        LivedWorld together = life.Live();
        // alone and in single steps: neither neighbours, the size of a call nor, below, reading changes a bit
        for (int i = 0; i < life.Bodies; i++)
        {
            LivedWorld alone = life.Live(only: i, inSingleSteps: true);
            Assert.That(alone.Bodies.ContainsKey(i), Is.EqualTo(together.Bodies.ContainsKey(i)));
            Assert.That(alone.Simulation.Time, Is.EqualTo(together.Simulation.Time));
            if (alone.Bodies.TryGetValue(i, out Body? body))
                Assert.That((body.State, body.Between(0.25)), Is.EqualTo((together.Bodies[i].State, together.Bodies[i].Between(0.25))), body.Name);
        }
    }

    [TestCaseSource(nameof(Seeds))]
    public void Same_life_twice_has_the_same_bits_all_the_way(int seed)
    {
        Life life = new(seed, 200, [.. Scenery.Integrators]);
        List<BodyState> first = [], second = [];
        life.Live(after: world => first.AddRange(world.Simulation.Bodies.Select(body => body.State)));
        life.Live(inSingleSteps: true, looks: false, after: world => second.AddRange(world.Simulation.Bodies.Select(body => body.State)));
        Assert.That(second, Is.EqualTo(first));
    }

    /// <summary>
    /// The exact integrator's step is push, free motion, push. Here the motion is one <see cref="FreeMotion"/> from the state before the
    /// step, and the pushes are computed with full matrices from the points of the body.
    /// </summary>
    [TestCaseSource(nameof(Seeds))]
    public void Exact_bodies_go_as_closed_forms_and_matrices_say(int seed)
    {
        Life life = new(seed, 400, ["Exact"], isFree: true);
        Dictionary<int, Follower> followers = [], saved = [];
        double largest = 0;
        life.Live(looks: false, after: world =>
        {
            foreach ((string what, double length, int number, Vector3d a, Vector3d? b, bool inBody) in world.Done)
            {
                if (what == "step")
                {
                    foreach (Follower each in followers.Values)
                        each.Step(length);
                }
                else if (what == "anew")
                {
                    Follower last = followers.GetValueOrDefault(number, new Follower());
                    followers[number] = last with { Body = world.Bodies[number].Plan.Asked, State = world.Bodies[number].State };
                }
                else if (what == "save")
                {
                    saved = followers.ToDictionary(pair => pair.Key, pair => pair.Value with { });
                }
                else if (what == "restore")
                {
                    followers = saved.ToDictionary(pair => pair.Key, pair => pair.Value with { });
                }
                else
                {
                    followers[number].Do(what, a, b, inBody);
                }
            }

            world.Done.Clear();
            foreach ((int number, Body body) in world.Bodies)
            {
                double apart = Apart(body.State, followers[number].State);
                largest = Math.Max(largest, apart);
                Assert.That(apart, Is.LessThan(1e-9), body.Name); // measured 1.6e-12
            }
        });
        TestContext.Out.WriteLine($"{largest:e1}");
    }

    private static double Apart(BodyState a, BodyState b) =>
        Math.Max(
            Math.Max(Samples.Apart(a.Position, b.Position), Conserved.AngleBetween(a.Orientation, b.Orientation)),
            Math.Max(Samples.Apart(a.Velocity, b.Velocity), Samples.Apart(a.AngularVelocity, b.AngularVelocity)));

    private sealed record Follower
    {
        public BodyDescription Body { get; set; } = null!;

        public BodyState State { get; set; }

        public (Vector3d Force, Vector3d Torque, Vector3d BodyForce, Vector3d BodyTorque) Load { get; set; }

        public void Step(double length)
        {
            Kick(0.5 * length);
            BodyDescription from = Body.Copy("from", Body.Mass);
            from.Start = State;
            State = new FreeMotion(from).At(length);
            Kick(0.5 * length);
            Load = default;
        }

        public void Do(string what, Vector3d a, Vector3d? b, bool inBody)
        {
            Matrix3 toWorld = inBody ? World() : Matrix3.Of(Quaterniond.Identity);
            Vector3d centre = World() * Body.Mass.CenterOfMass, given = toWorld * a;
            Vector3d? arm = b == null ? null : inBody ? toWorld * b.Value - centre : b.Value - State.Position - centre;
            switch (what)
            {
                case "impulse":
                    Give(given, arm == null ? Vector3d.Zero : Vector3d.Cross(arm.Value, given));
                    break;
                case "angular impulse":
                    Give(Vector3d.Zero, given);
                    break;
                case "force":
                    Load = inBody ? Load with { BodyForce = Load.BodyForce + a } : Load with { Force = Load.Force + a };
                    break;
                default:
                    Load = inBody ? Load with { BodyTorque = Load.BodyTorque + a } : Load with { Torque = Load.Torque + a };
                    break;
            }
        }

        private void Kick(double time) =>
            Give(time * (Load.Force + World() * Load.BodyForce), time * (Load.Torque + World() * Load.BodyTorque));

        private void Give(Vector3d impulse, Vector3d turn)
        {
            BodyState state = State;
            state.Velocity += impulse / Body.Mass.Mass;
            state.AngularVelocity += Body.Mass.Inertia.RotatedBy(World()).Inverse * turn;
            State = state;
        }

        private Matrix3 World() => Matrix3.Of(State.Orientation.Normalized);
    }
}
