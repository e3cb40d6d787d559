using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Held keys act like those that a scene file names.</summary>
public sealed class LabKeyboardTests
{
    private const double Step = 0.02;
    // R to the end: where no torque acts any more, the exact integrators use a shorter formula with other roundings
    private static readonly (LabKey Key, int From, int To)[] Pressed = [(LabKey.R, 0, 200), (LabKey.RightArrow, 50, 100), (LabKey.UpArrow, 75, 125), (LabKey.LeftArrow, 90, 95)];

    [TestCaseSource(nameof(RuleNames))]
    public void Keys_held_while_a_scene_would_press_them_move_the_body_to_the_same_bits(string rule)
    {
        LabKeyboard keyboard = new();
        Simulation typed = new(TimeSteps.Every(Step), Body(rule).With(new HeldKeys(keyboard)));
        BodyDescription scripted = Body(rule);
        foreach ((LabKey key, int from, int to) in Pressed)
            scripted.With(new KeyPush(key), from * Step, to * Step);
        Simulation written = new(TimeSteps.Every(Step), scripted);

        for (int step = 0; step < 200; step++)
        {
            foreach (LabKey key in Enum.GetValues<LabKey>())
                keyboard[key] = Pressed.Any(press => press.Key == key && press.From <= step && step < press.To);
            typed.Step();
            written.Step();
            Assert.That(typed.Bodies[0].State, Is.EqualTo(written.Bodies[0].State).Using<BodyState>(HasSameBits), $"after step {step}");
        }
    }

    [Test]
    public void Arrow_held_for_a_second_gives_five_newton_seconds()
    {
        LabKeyboard keyboard = new() { [LabKey.LeftArrow] = true };
        Simulation simulation = new(TimeSteps.Every(Step), Body("Exact").With(new HeldKeys(keyboard)));
        simulation.Step(50);

        // 5 N s over 2 kg; fifty sums of 0.05 round at most fifty times
        Assert.That(simulation.Bodies[0].State.Velocity.X, Is.EqualTo(-2.5).Within(50 * 2.5 * Math.Pow(2, -53)));
        Assert.That(simulation.Bodies[0].State.Velocity.Y, Is.Zero);
    }

    [Test]
    public void Keyboard_that_nobody_touches_moves_nothing()
    {
        Simulation simulation = new(TimeSteps.Every(Step), Body("LabEuler").With(new HeldKeys(new LabKeyboard())));
        simulation.Step(100);

        Assert.That(simulation.Bodies[0].State, Is.EqualTo(BodyState.AtRest).Using<BodyState>(HasSameBits));
    }

    [TestCase(-1)]
    [TestCase(5)]
    public void Key_that_the_lab_does_not_have_is_refused(int key) => Assert.That(
        () => new LabKeyboard()[(LabKey)key] = true, Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains("found " + key));

    private static IEnumerable<string> RuleNames() => Rules.All.Select(rule => rule.Name);

    private static BodyDescription Body(string rule) => new("body", Solids.Box(2, new Vector3d(1, 2, 3))) { Rule = Rules.Named(rule) };

    private static bool HasSameBits(BodyState a, BodyState b) =>
        a.Position == b.Position && a.Orientation == b.Orientation && a.Velocity == b.Velocity && a.AngularVelocity == b.AngularVelocity;
}
