using NUnit.Framework;

namespace RigidBodyDynamics.Tests;

/// <summary>An effect that keeps its declaration has no findings; one that does not has exactly the finding for it.</summary>
public sealed class EffectCheckTests
{
    private const EffectTraits Moves = EffectTraits.Moves;
    private static readonly Vector3d X = new(1, 0, 0), Y = new(0, 3, 0), Z = new(0.5, -1, 2);
    private static readonly Torque Swinging = new(X, Y, Z, 1.3, inBody: true);
    private static readonly Spring Spring = new(X, Y, 4);
    private static readonly MassProperties Ball = Solids.Box(2, new Vector3d(1, 1, 1));

    [TestCaseSource(typeof(Pushes), nameof(Pushes.All))]
    public void Push_of_the_library_is_what_it_says(IPush push)
    {
        IReadOnlyList<string> found = EffectCheck.Findings(new Declared(push, push.Traits));
        Assert.That(found, Is.Empty);
    }

    [Test]
    public void Force_that_is_not_declared_is_found() => Finds(
        new Own(EffectTraits.None, (_, _) => Y),
        "^Moves is not declared, and there is a force of up to 3 N: add EffectTraits.Moves to Traits, or it may be left out.$");

    [Test]
    public void Torque_that_is_not_declared_is_found() => Finds(
        new Declared(Torque.Constant(Y), EffectTraits.None),
        "^Turns is not declared, and there is a torque of up to 3 N m: add EffectTraits.Turns to Traits, or it may be left out.$");

    [TestCase(EffectTraits.Moves, "force")]
    [TestCase(EffectTraits.Turns, "torque")]
    public void What_is_declared_and_never_given_is_hinted_at(EffectTraits trait, string what)
    {
        IPush other = trait == EffectTraits.Moves ? Torque.Constant(Y) : new Force(Y);
        Finds(
            new Declared(other, other.Traits | trait),
            $"^Hint: {trait} is declared, and in 16 trials there was no {what}: take EffectTraits.{trait} out of Traits, so that nobody computes it.$");
    }

    private static IEnumerable<TestCaseData> Readers()
    {
        yield return new TestCaseData(Swinging, EffectTraits.ReadsTime, "time");
        yield return new TestCaseData(Spring, EffectTraits.ReadsPosition, "position");
        yield return new TestCaseData(new HeavyTop(X, 2, Z), EffectTraits.ReadsOrientation, "orientation");
        yield return new TestCaseData(new QuadraticDrag(0.3), EffectTraits.ReadsVelocity, "velocity");
        yield return new TestCaseData(new SpinDrag(0.4, EffectTraits.ReadsAngularVelocity), EffectTraits.ReadsAngularVelocity, "angular velocity");
    }

    [TestCaseSource(nameof(Readers))]
    public void What_is_read_and_not_declared_is_found(IPush push, EffectTraits trait, string what) => Finds(
        new Declared(push, push.Traits & ~trait),
        $"^{trait} is not declared, and there is a change with the {what} alone of up to [0-9.]+ % of the largest push: add EffectTraits.{trait} to Traits, or it may be left out.$");

    [TestCase(EffectTraits.ReadsTime, "time")]
    [TestCase(EffectTraits.ReadsPosition, "position")]
    [TestCase(EffectTraits.ReadsOrientation, "orientation")]
    [TestCase(EffectTraits.ReadsVelocity, "velocity")]
    [TestCase(EffectTraits.ReadsAngularVelocity, "angular velocity")]
    public void What_is_declared_and_not_read_is_hinted_at(EffectTraits trait, string what)
    {
        const EffectTraits pose = EffectTraits.ReadsPosition | EffectTraits.ReadsOrientation;
        EffectTraits potential = (trait & pose) != 0 ? EffectTraits.HasPotential : EffectTraits.None;
        Assert.That(EffectCheck.Findings(new Declared(new Force(Y), Moves | potential | trait)), Is.EqualTo(new[] { Hint(trait, what) }));
    }

    [Test]
    public void Angular_velocity_follows_the_torque_in_the_integral() => Assert.That(
        EffectCheck.Findings(new SpinDrag(0.4, EffectTraits.ReadsAngularVelocity), Ball, BodyState.AtRest, 0, 1), Is.Empty);

    [Test]
    public void Impulse_that_is_not_the_integral_is_of_order_zero() => Finds(
        new Own(Moves, (_, _) => Y, (_, h, _) => 2 * h * Y),
        "^Over is the integral of At to order 0 only: its error is 50 % of the largest push in 0.1 s, and Exact is of order 0 at most; add what At gives in that time, the body held in its place.$");

    [Test]
    public void Impulse_of_a_push_that_changes_is_of_order_one_if_it_is_duration_times_push() => Finds(
        new Own(Moves | EffectTraits.ReadsTime, (now, _) => Math.Sin(now.Time) * Y),
        "^Over is the integral of At to order 1 only: its error is [0-9.]+ % of the largest push in 0.1 s, and Exact is of order 1 at most; take the push in the middle");

    [Test]
    public void Sum_in_which_one_reads_a_velocity_is_an_approximation_though_its_parts_are_exact()
    {
        Force force = new(10 * Y);
        QuadraticDrag drag = new(0.3);
        Both<Force, QuadraticDrag> sum = new(force, drag);
        Assert.That(EffectCheck.Findings(force).Concat(EffectCheck.Findings(drag)), Is.Empty);
        Assert.That(EffectCheck.Findings(sum), Has.Some.Matches("^Over is the integral of At to order 1 only"));
    }

    [Test]
    public void Impulse_of_a_push_in_the_middle_of_the_time_is_of_order_two_and_only_hinted_at() => Finds(
        new Own(
            Moves | EffectTraits.ReadsTime,
            (now, _) => Math.Sin(now.Time) * Y,
            (now, h, _) => h * Math.Sin(now.IsHeld ? now.Time : now.Time + h / 2) * Y),
        "^Hint: Over is the integral of At to order 2 only: its error is 0.0[0-9]+ % of the largest push in 0.1 s, and Exact is of order 2 at most; an exact flow would lift that.$");

    [Test]
    public void Impulse_that_does_not_go_back_is_found() => Finds(
        new Own(Moves, (_, _) => Y, (_, h, _) => Math.Abs(h) * Y),
        "^Over a negative time is the integral of At to order 0 only: its error is 200 % of the largest push in 0.1 s, and the way back is of order 0 at most");

    [TestCase(false, 1)]
    [TestCase(true, 0)]
    public void Impulse_of_a_velocity_that_is_no_exact_flow_is_to_come_back(bool comesBack, int hints)
    {
        // v' = −v, by a step of Heun's and by the midpoint rule
        Own drag = new(
            Moves | EffectTraits.ReadsVelocity,
            (_, body) => -Pushes.Mass.Mass * body.Velocity,
            (_, h, body) => -Pushes.Mass.Mass * (comesBack ? h / (1 + h / 2) : h - h * h / 2) * body.Velocity);

        IEnumerable<string> found = EffectCheck.Findings(drag).Where(finding => finding.Contains("does not take back"));
        Assert.That(found, Has.Exactly(hints).Matches("^Hint: Over by −h does not take back what Over by h gave: its error is 0.[0-9]+ % of the largest push in 0.1 s, and Exact4 and Exact6 are of order 2 at most;"));
        Assert.That(EffectCheck.Findings(default(MomentumDrag)).Concat(EffectCheck.Findings(new Lift(0.7))), Has.None.Contains("does not take back"));
    }

    [Test]
    public void Impulse_in_which_time_passes_that_should_stand_still_is_found() => Finds(
        new Restless(Swinging),
        "^Over while Instant.IsHeld is the integral of At to order 1 only: its error is [0-9.]+ % of the largest push in 0.1 s, and Exact4 and Exact6 are of order 1 at most");

    [TestCase(true, false, "At")]
    [TestCase(false, true, "Over")]
    public void Push_that_overwrites_what_is_there_is_found(bool at, bool over, string which) => Finds(
        new Overwriting(at, over),
        $"^{which} does not add to what other effects have given: where there was some its error is [0-9.]+ % of the largest push; write \\+= and -=, never =.$");

    [Test]
    public void Drag_that_does_not_look_at_the_impulse_that_comes_in_is_found() => Finds(
        default(DeafDrag),
        "^Over reads a velocity, not what the impulse that comes in has made of it, and its error is [0-9.]+ % of the largest push: the body now moves as impulse.AppliedTo\\(body, mass\\).$");

    [Test]
    public void Half_that_does_not_look_at_the_impulse_is_found_beside_a_half_that_does() => Assert.That(
        EffectCheck.Findings(default(HalfDeafDrag), Pushes.Mass, BodyState.AtRest, 0, 10),
        Has.Exactly(1).Contains("the body now moves as impulse.AppliedTo(body, mass)").And.None.Contains("does not add"));

    [Test]
    public void Friction_that_divides_by_the_speed_is_found_at_rest() => Finds(
        new Own(Moves | EffectTraits.ReadsVelocity, (_, body) => -1 / body.Velocity.Length * body.Velocity),
        @"^At gave force \(NaN, NaN, NaN\) and torque \(0, 0, 0\), which is not finite, at t = [0-9.]+ s, position \(0, 0, 0\), velocity \(0, 0, 0\): let it give a number");

    [Test]
    public void Effect_that_changes_when_it_is_asked_is_found() => Finds(
        default(Growing),
        @"^At gave force \(1, 0, 0\) and torque \(0, 0, 0\) and then, asked the same, \(17, 0, 0\) and \(0, 0, 0\): keep nothing in the effect");

    [Test]
    public void Whirl_that_declares_a_potential_is_found_by_the_work_around_a_closed_way() => Finds(
        new Own(Moves | EffectTraits.ReadsPosition | EffectTraits.HasPotential, (_, body) => Vector3d.Cross(Z, body.Position)),
        "^HasPotential is declared, and around a closed way the work is [0-9.]+ % of what is done to and fro: take EffectTraits.HasPotential out of Traits");

    [Test]
    public void Constant_torque_that_declares_a_potential_is_found_by_the_work_around_a_closed_way_of_turns() => Finds(
        new Declared(Torque.Constant(Z), EffectTraits.Turns | EffectTraits.HasPotential),
        "^HasPotential is declared, and around a closed way the work is [0-9.]+ % of what is done to and fro");

    [Test]
    public void Potential_of_time_is_none() => Finds(
        new Declared(Swinging, Swinging.Traits | EffectTraits.HasPotential),
        "^HasPotential is declared, and ReadsTime too: a potential knows position and orientation alone");

    [Test]
    public void Potential_that_is_not_declared_is_hinted_at() => Finds(
        new Declared(Spring, Spring.Traits & ~EffectTraits.HasPotential),
        "^Hint: HasPotential is not declared, and around 16 closed ways there was no work: add EffectTraits.HasPotential");

    [Test]
    public void Effect_is_tried_where_and_when_one_says()
    {
        BodyState away = BodyState.AtRest;
        away.Position = new Vector3d(70, 0, 0);
        Own planet = new(Moves | EffectTraits.ReadsPosition | EffectTraits.HasPotential, (_, body) => -1 / Math.Pow(body.Position.Length, 3) * body.Position);
        Assert.That(EffectCheck.Findings(planet), Has.One.Matches(@"which is not finite, at t = [0-9.]+ s, position \(0, 0, 0\)"));
        Assert.That(EffectCheck.Findings(planet, Ball, away, 0, 1), Is.Empty);

        Own late = new(Moves | EffectTraits.ReadsTime, (now, _) => now.Time < 100 ? Vector3d.Zero : Y);
        Assert.That(EffectCheck.Findings(late), Has.One.StartsWith("Hint: Moves is declared"));
        Assert.That(EffectCheck.Findings(late, Ball, away, 101, 200), Is.EqualTo(new[] { Hint(EffectTraits.ReadsTime, "time") }));
    }

    [Test]
    public void Switch_in_the_middle_of_a_time_is_not_held_against_an_impulse_that_is_exact() => Assert.That(
        EffectCheck.Findings(
            new Own(
                Moves | EffectTraits.ReadsTime,
                (now, _) => now.Time < 5 ? Vector3d.Zero : Y,
                (now, h, _) => (now.IsHeld ? now.Time < 5 ? 0 : h : Math.Max(now.Time + h, 5) - Math.Max(now.Time, 5)) * Y),
            Ball,
            BodyState.AtRest,
            4.5,
            5.5),
        Is.Empty);

    [Test]
    public void Findings_are_the_same_whenever_they_are_asked_for()
    {
        Own whirl = new(EffectTraits.HasPotential, (now, body) => Math.Sin(now.Time) * body.Velocity);
        Assert.That(EffectCheck.Findings(whirl), Is.EqualTo(EffectCheck.Findings(whirl)).And.Count.GreaterThan(3));
    }

    private static string Hint(EffectTraits trait, string what) =>
        $"Hint: {trait} is declared, and in 16 trials there was no change with the {what} alone: take EffectTraits.{trait} out of Traits, so that nobody computes it.";

    private static void Finds<TPush>(TPush push, string sentence) where TPush : struct, IPush
    {
        IReadOnlyList<string> found = EffectCheck.Findings(push, push is Declared ? Ball : Pushes.Mass, BodyState.AtRest, 0, 10);
        Assert.That(found, Has.Count.EqualTo(1).And.One.Matches(sentence));
    }
}
