using NUnit.Framework;

namespace RigidBodyDynamics.Tests.Repository;

/// <summary>The integrator that docs/integrators.md shows is compiled here, and is what the page says.</summary>
public sealed class IntegratorsPageTests
{
    private const string Page = "docs/integrators.md";
    private const double Seconds = 2;

    [Test]
    public void Integrator_on_the_page_is_the_one_that_is_compiled() => Assert.That(
        PageText.Block(Page, "<!-- MomentumEuler.cs -->"),
        Is.EqualTo(File.ReadLines(Root.File("tests/MyRigidbody.Tests/Integrators/MomentumEuler.cs")).Skip(2)));

    [Test]
    public void Integrator_on_the_page_moves_a_body_from_outside_the_library()
    {
        string source = "using RigidBodyDynamics;\n" + string.Join('\n', PageText.Block(Page, "<!-- MomentumEuler.cs -->"))
            + "\npublic static class Used { public static Simulation Run() {\n" + string.Join('\n', PageText.Block(Page, "<!-- used -->")) + "\nreturn simulation; } }";

        Body body = ((Simulation)Outside.Library(source).GetType("Used")!.GetMethod("Run")!.Invoke(null, null)!).Bodies[0];
        Assert.That(body.State, Is.EqualTo(Run(0.02)));
        Assert.That(body.Rule.Name, Is.EqualTo("MomentumEuler"));
        Assert.That(new Explanation(body).ToString(), Does.StartWith("top, by MomentumEuler\n  always: rotation by MomentumEuler\n"));
    }

    [Test]
    public void It_keeps_the_momentum_and_gains_energy_as_the_page_says()
    {
        BodyDescription top = Top();
        BodyState end = Run(0.02);
        double energy = Conserved.KineticEnergy(end, top.Mass) / Conserved.KineticEnergy(top.Start, top.Mass) - 1;
        double momentum = (Conserved.AngularMomentum(end, top.Mass) - Conserved.AngularMomentum(top.Start, top.Mass)).Length;
        TestContext.Out.WriteLine($"energy {energy:P1}, momentum {momentum:e1}");

        Assert.That(momentum, Is.LessThan(1e-14)); // it adds nothing to L
        Assert.That(energy, Is.EqualTo(0.012).Within(0.0005), "the page says 1.2 %");
    }

    [Test]
    public void Its_error_is_as_the_page_says_and_falls_with_the_first_power_of_the_step()
    {
        double whole = Error(Run(0.02)), half = Error(Run(0.01)), lab = Error(RunBy("LabEuler")), exact = Error(RunBy("Exact"));
        TestContext.Out.WriteLine($"{whole:e2}, {half:e2}, LabEuler {lab:e2}, Exact {exact:e1}");

        Assert.That(whole, Is.EqualTo(0.042).Within(0.0005));
        Assert.That(whole / half, Is.EqualTo(2).Within(0.1));
        Assert.That(lab, Is.EqualTo(1.35).Within(0.005));
        Assert.That(exact, Is.LessThan(2e-15));
    }

    private static double Error(BodyState end) =>
        Conserved.AngleBetween(new FreeMotion(Top()).At(Seconds).Orientation, end.Orientation);

    private static BodyState Run(double step)
    {
        MomentumEuler rule = default;
        Nothing nothing = default;
        rule.Start(new Beginning(Top()));
        rule.Prepare(step, Coasting.Free);
        for (int i = 0; i < (int)Math.Round(Seconds / step); i++)
            rule.Step(new Instant(i, i * step), ref nothing);

        return rule.State;
    }

    private static BodyState RunBy(string rule)
    {
        BodyDescription top = Top();
        top.Rule = Rules.Named(rule);
        Simulation simulation = new(TimeSteps.Every(0.02), top);
        simulation.Step(100);
        return simulation.Bodies[0].State;
    }

    private static BodyDescription Top() => new("top", MassProperties.FromPrincipal(1, new Vector3d(1, 2, 3)))
    {
        Start = new BodyState(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, new Vector3d(1, 1.1, 0.9)),
    };
}
