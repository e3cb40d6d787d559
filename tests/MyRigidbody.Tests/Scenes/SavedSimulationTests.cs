using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Saving and continuing later changes no bit.</summary>
public sealed class SavedSimulationTests
{
    [TestCaseSource(typeof(Scenery), nameof(Scenery.Integrators))]
    public void Simulation_goes_on_from_where_it_was_saved_to_the_same_bits(string integrator)
    {
        foreach (TimeSteps steps in Scenery.Divisions())
        {
            Simulation simulation = new(steps, Scenery.Busy(integrator, "a"), Scenery.Body(integrator, "b").With(new KeyPush(LabKey.R), 0.5, 0.9));
            List<SavedSimulation> saved = [];
            List<BodyState[]> seen = [];
            for (long n = 0; n <= Scenery.Steps; n++)
            {
                saved.Add(simulation.Save());
                seen.Add([.. simulation.Bodies.Select(body => body.State)]);
                if (n < Scenery.Steps)
                    simulation.Step();
            }

            Random random = new(3);
            for (int i = 0; i < 20; i++)
            {
                int from = random.Next(0, (int)Scenery.Steps), to = random.Next(from, (int)Scenery.Steps + 1);
                simulation.Restore(saved[from]);
                Assert.That(simulation.StepsDone, Is.EqualTo(from).And.EqualTo(saved[from].StepsDone));
                Assert.That(simulation.Bodies.Select(body => body.State), Is.EqualTo(seen[from]));
                simulation.Step(to - from);
                Assert.That(simulation.Bodies.Select(body => body.State), Is.EqualTo(seen[to]));
            }
        }
    }

    [Test]
    public void What_happened_after_it_was_saved_is_forgotten()
    {
        LabKeyboard keyboard = new() { [LabKey.RightArrow] = true };
        Simulation simulation = new(TimeSteps.Every(0.02), Scenery.Body("Exact").With(new HeldKeys(keyboard), 0, 2));
        simulation.Step(150);
        SavedSimulation coasting = simulation.Save();
        BodyState there = simulation.Bodies[0].State;
        simulation.Step(400);
        BodyState later = simulation.Bodies[0].State;

        Simulation other = new(TimeSteps.Every(0.02), Scenery.Body("Exact").With(new HeldKeys(keyboard), 0, 2));
        SavedSimulation start = other.Save();
        other.Step(150);
        SavedSimulation first = other.Save();
        other.Restore(start);
        keyboard[LabKey.RightArrow] = false;
        keyboard[LabKey.DownArrow] = true;
        other.Step(500);
        Assert.That(other.Bodies[0].State, Is.Not.EqualTo(later));
        other.Restore(first);
        Assert.That(other.Bodies[0].State, Is.EqualTo(there));
        other.Step(400);
        Assert.That(other.Bodies[0].State, Is.EqualTo(later));
        Assert.That(coasting.StepsDone, Is.EqualTo(150));
    }

    [Test]
    public void State_of_another_simulation_is_refused()
    {
        Simulation one = new(TimeSteps.Every(0.02), Scenery.Body("Exact")), other = new(TimeSteps.Every(0.02), Scenery.Body("Exact"));
        Assert.That(() => one.Restore(other.Save()), Throws.ArgumentException.With.Message.Contains("saved"));
        Assert.That(() => one.Restore(null!), Throws.ArgumentNullException.With.Message.Contains("saved"));
    }
}
