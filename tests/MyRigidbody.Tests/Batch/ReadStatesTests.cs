using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>All states at once are those that the bodies have one by one; of crowds of every kind <see cref="Crowding.Same(BodyDescription, TimeSteps, BodyState[], IEnumerable{long}, int)"/> says so.</summary>
public sealed class ReadStatesTests
{
    private static readonly TimeSteps Steps = TimeSteps.Every(0.02);

    [Test]
    public void States_stand_in_the_order_of_the_bodies_whoever_came_and_went()
    {
        Simulation simulation = new(Steps, Like("alone", "Exact"));
        BodyDescription first = Like("one of many", "Exact"), second = Like("one of others", "LabEuler");
        BodyState[] starts = Crowding.Starts(40, 5, first), found = new BodyState[90];
        List<Body> many = [.. starts.SelectMany(start => new[] { simulation.Add(first, start), simulation.Add(second, start) })];
        foreach (int gone in new[] { 79, 3, 40, 0 })
            simulation.Remove(many[gone]);

        simulation.Step(7);
        _ = many[20].Between(0.5); // leaves the others

        simulation.ReadStates(found);

        for (int i = 0; i < simulation.Bodies.Count; i++)
            Crowding.Same(found[i], simulation.Bodies[i].State, "body " + i);

        Assert.That(simulation.Bodies, Has.Count.EqualTo(77));
        Assert.That(found.Skip(77), Is.All.EqualTo(default(BodyState)));
    }

    [Test]
    public void Array_without_room_is_refused()
    {
        BodyDescription like = Like("b", "Exact");
        Simulation simulation = new(Steps, like);
        simulation.Add(like);
        simulation.Add(like);

        Assert.That(() => simulation.ReadStates(new BodyState[2]), Throws.InstanceOf<ArgumentException>().With.Message.Contains("must have room for the states of 3 bodies"));
        Assert.That(() => simulation.ReadStates(null!), Throws.ArgumentNullException);
    }

    private static BodyDescription Like(string name, string rule) => new BodyDescription(name, Crowding.Masses.ElementAt(1))
    {
        Rule = Rules.Named(rule),
        Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, new Vector3d(1, 2, 3), new Vector3d(1, 1.1, 0.9)),
    }.With(Torque.Constant(new Vector3d(0.1, 0, 0)));
}
