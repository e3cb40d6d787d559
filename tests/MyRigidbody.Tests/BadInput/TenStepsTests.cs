using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>Effects, settings and starts that are accepted with an extreme value, ten steps later, by every integrator.</summary>
public sealed class TenStepsTests
{
    private const double Huge = 1e12, Tiny = 5e-324;
    private static readonly Vector3d HugeVector = new(Huge, -Huge, Huge), TinyVector = new(Tiny, -Tiny, 1e-308);
    private static readonly Vector3d One = new(1, 0.5, 0.25);

    private static readonly (string Name, Action<BodyDescription> Change)[] Changes =
    [
        .. Both("force", v => body => body.With(new Force(v))),
        .. Both("gravity", v => body => body.With(new Gravity(v))),
        .. Both("torque", v => body => body.With(Torque.Constant(v))),
        .. Both("torque in body axes", v => body => body.With(new Torque(v, v, v, v.X, inBody: true))),
        .. Both("per step", v => body => body.With(new PerStep([v], [v]))),
        .. Both("thrust", v => body => body.With(new Force(v, at: One, inBody: true))),
        .. Both("thrust far from the centre", v => body => body.With(new Force(One, at: v, inBody: true))),
        .. Both("spring", v => body => body.With(new Spring(v, One, 1))),
        .. Both("spring from afar", v => body => body.With(new Spring(One, v, 1))),
        .. Both("stiffness", v => body => body.With(new Spring(One, One, v.X))),
        .. Both("heavy top", v => body => body.With(new HeavyTop(One, v.X, One))),
        .. Both("quadratic drag", v => body => body.With(new QuadraticDrag(v.X))),
        .. Both("linear damping", v => body => body.With(new LinearDamping(v.X))),
        .. Both("angular damping", v => body => body.With(new AngularDamping(v.X))),
        .. Both("factor", v => body => body.With(new DecayPerStep(v.X < 1 ? v.X : 0, v.X < 1 ? v.X : 0))),
        .. Both("position", v => body => body.Start = new BodyState(v, Quaterniond.Identity, One, One)),
        .. Both("velocity", v => body => body.Start = new BodyState(One, Quaterniond.Identity, v, One)),
        .. Both("spin", v => body => body.Start = new BodyState(One, Quaterniond.Identity, One, v)),
        .. Both("Unity's drag", v => body => body.Unity = new UnitySettings { Drag = v.X, AngularDrag = v.X }),
        .. Both("Unity's limit of spin", v => body => body.Unity = new UnitySettings { MaxAngularVelocity = v.X }),
        .. Both("Unity's sleep", v => body => body.Unity = new UnitySettings { SleepThreshold = v.X, WakeCounter = v.X }),
        ("nobody's keyboard", body => body.With(default(HeldKeys))),
        ("no list", body => body.With(default(PerStep))),
        ("no pushes", body => body.With(default(Many))),
        ("no heavy top", body => body.With(default(HeavyTop))),
        ("no spring", body => body.With(default(Spring))),
        ("no torque", body => body.With(default(Torque))),
        ("no key", body => body.With(default(KeyPush))),
        ("no factor", body => body.With(default(DecayPerStep))),
    ];

    // no integrator that evaluates a force at a few instants can follow it: divergence is reported when it runs
    private static readonly string[] RunAway = ["huge stiffness", "huge quadratic drag", "huge linear damping", "huge angular damping"];

    [Test]
    public void Extreme_value_leads_to_finite_numbers_or_is_refused([ValueSource(nameof(RuleNames))] string rule)
    {
        foreach ((string name, Action<BodyDescription> change) in Changes)
        {
            BodyDescription body = Scenery.Body(rule);
            change(body);
            Simulation simulation;
            try
            {
                simulation = new Simulation(TimeSteps.Every(0.5), body);
            }
            catch (ArgumentException)
            {
                continue;
            }

            try
            {
                simulation.Step(10);
            }
            catch (ArithmeticException broken) when (RunAway.Contains(name) && broken is BrokenEffectException or StateOverflowException)
            {
            }

            Assert.That(simulation.Bodies[0].State.IsFinite, Is.True, name);
        }
    }

    [TestCase("mass", 1e-40)]
    [TestCase("mass", 1e39)]
    [TestCase("position", 1e39)]
    [TestCase("velocity", 1e39)]
    [TestCase("angularVelocity", 1e39)]
    [TestCase("centerOfMass", 1e39)]
    [TestCase("orientation", 1e30)]
    [TestCase("orientation", 1e-30)]
    [TestCase("frame", 1e30)]
    [TestCase("frame", 1e-30)]
    public void What_single_precision_cannot_hold_is_refused_by_Unitys_integrator_alone(string name, double value)
    {
        Vector3d vector = new(value, value, value);
        Quaterniond quaternion = new(0, vector);
        MassProperties mass = MassProperties.FromPrincipal(
            name == "mass" ? value : 1,
            new Vector3d(1, 1, 1),
            name == "frame" ? quaternion : Quaterniond.Identity,
            name == "centerOfMass" ? vector : Vector3d.Zero);
        BodyDescription body = new("b", mass)
        {
            Start = new BodyState(
                name == "position" ? vector : Vector3d.Zero,
                name == "orientation" ? quaternion : Quaterniond.Identity,
                name == "velocity" ? vector : Vector3d.Zero,
                name == "angularVelocity" ? vector : Vector3d.Zero),
        };
        Assert.That(() => new Simulation(TimeSteps.Every(0.5), body), Throws.Nothing);
        body.Rule = Rules.UnityRigidbody;

        Assert.That(
            () => new Simulation(TimeSteps.Every(0.5), body),
            Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.StartsWith(name + ": must fit the precision of UnityRigidbody, found "));
    }

    private static IEnumerable<string> RuleNames => Scenery.Integrators;

    private static IEnumerable<(string Name, Action<BodyDescription> Change)> Both(string name, Func<Vector3d, Action<BodyDescription>> change) =>
        [("huge " + name, change(HugeVector)), ("tiny " + name, change(TinyVector))];
}
