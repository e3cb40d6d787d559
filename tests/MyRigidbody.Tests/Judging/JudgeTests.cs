using System.Numerics;
using NUnit.Framework;
using RigidBodyDynamics.Judging;

namespace RigidBodyDynamics.Tests.Judging;

/// <summary>The judge's verdict on scripts whose steps are known.</summary>
internal sealed class JudgeTests
{
    private const float H = SheetScript.Step;

    private static readonly Action<SheetScript> Velocity = SheetScript.Velocity, AngularVelocity = SheetScript.AngularVelocity, Move = SheetScript.Move,
        Turn = SheetScript.Turn, Damp = SheetScript.Damp, Nothing = _ => { };

    private static readonly Action<SheetScript> OrderOfProduct = s => s.Add(s.Orientation * new Quaternion(0.5f * H * s.w, 0)),
        NotTurned = s => s.w += H * s.InverseOfReference * s.torque;

    private static IEnumerable<TestCaseData> RightScripts()
    {
        yield return Steps("as the sheet has them", Velocity, AngularVelocity, Move, Turn, Damp);
        yield return Steps("x moves with the old velocity", Move, Velocity, AngularVelocity, Turn, Damp);
        yield return Steps("the body moves and turns first", Move, Turn, Velocity, AngularVelocity, Damp);
        yield return Steps("damped at the beginning", Damp, Velocity, AngularVelocity, Move, Turn);
        yield return Steps("q turned by the body's own ω, from the right", Velocity, AngularVelocity, Move, s => s.Add(s.Orientation * new Quaternion(0.5f * H * s.TurnedBack(s.w), 0)), Damp);
    }

    [TestCaseSource(nameof(RightScripts))]
    public void A_script_that_does_the_steps_in_any_of_their_readings_is_right(Action<SheetScript>[] steps)
    {
        Verdict verdict = Judged(steps);
        Assert.That(verdict.Findings, Is.Empty);
        Assert.That(verdict.Outcome, Is.EqualTo(Outcome.Right));
    }

    private static IEnumerable<TestCaseData> Mistakes()
    {
        yield return Mistake(Step.Velocity, "v-no-dt", s => s.v += s.force / s.mass);
        yield return Mistake(Step.Velocity, "v-assigned", s => s.v = s.force / s.mass * H);
        yield return Mistake(Step.Velocity, "mass-multiplied", s => s.v += s.force * s.mass * H);
        yield return Mistake(Step.Velocity, "mass-not-used", s => s.v += s.force * H);
        yield return Mistake(Step.Velocity, "not-done", Nothing);
        yield return Mistake(Step.AngularVelocity, "inertia-not-turned", NotTurned);
        yield return Mistake(Step.AngularVelocity, "torque-as-acceleration", s => s.w += H * s.torque);
        yield return Mistake(Step.AngularVelocity, "turned-the-wrong-way", s => s.w += H * s.TurnedBack(s.InverseOfReference * s.Turned(s.torque)));
        yield return Mistake(Step.AngularVelocity, "not-done", Nothing);
        yield return Mistake(Step.Position, "x-assigned", s => s.Position = s.v * H);
        yield return Mistake(Step.Position, "x-in-body-axes", s => s.Position += s.Turned(s.v) * H);
        yield return Mistake(Step.Position, "x-no-dt", s => s.Position += s.v);
        yield return Mistake(Step.Position, "not-done", Nothing);
        yield return Mistake(Step.Orientation, "half-missing", s => s.Add(new Quaternion(H * s.w, 0) * s.Orientation));
        yield return Mistake(Step.Orientation, "order-of-product", OrderOfProduct);
        yield return Mistake(Step.Orientation, "q-left-out", s => s.Add(new Quaternion(0.5f * H * s.w, 0)));
        yield return Mistake(Step.Orientation, "not-done", Nothing);
        yield return Mistake(Step.Damping, "damped-twice", s => (s.v, s.w) = (0.9604f * s.v, 0.9604f * s.w));
        yield return Mistake(Step.Damping, "other-factor", s => (s.v, s.w) = (0.95f * s.v, 0.95f * s.w));
        yield return Mistake(Step.Damping, "w-not-damped", s => s.v *= 0.98f);
        yield return Mistake(Step.Damping, "damped-only-when-let-go", s => (s.v, s.w) = ((s.force == Vector3.Zero ? 0.98f : 1) * s.v, (s.torque == Vector3.Zero ? 0.98f : 1) * s.w));
        yield return Mistake(Step.Damping, "not-done", Nothing);
    }

    [TestCaseSource(nameof(Mistakes))]
    public void A_mistake_is_named_and_no_other_step_is_blamed(Step step, string code, Action<SheetScript> mistake)
    {
        Action<SheetScript>[] steps = SheetScript.Right;
        steps[(int)step - 1] = mistake;
        Verdict verdict = Judged(steps);
        Assert.That(verdict.Findings.Select(f => (f.Step, f.Code)), Is.EqualTo(new[] { (step, code) }));
        Assert.That(Verdict.FiveSteps.Where(s => verdict[s] != Mark.Right), Is.EqualTo(new[] { step }));
        Assert.That(verdict.Outcome, Is.EqualTo(Outcome.Wrong));
    }

    [Test]
    public void Damping_before_the_body_is_moved_is_a_mistake_of_step_5_alone()
    {
        Verdict verdict = Judged([Velocity, AngularVelocity, Damp, Move, Turn]);
        Assert.That(verdict.Findings.Select(f => (f.Step, f.Code)), Is.EqualTo(new[] { (Step.Damping, "damped-before-moving") }));
    }

    [Test]
    public void Two_mistakes_are_both_named_and_nothing_else()
    {
        Verdict verdict = Judged([s => s.v += s.force / s.mass, NotTurned, Move, Turn, Damp]);
        Assert.That(verdict.Findings.Select(f => f.Code), Is.EqualTo(new[] { "v-no-dt", "inertia-not-turned" }));
    }

    [Test]
    public void The_exact_rotation_is_for_the_instructor_to_decide()
    {
        Verdict verdict = Judged([Velocity, AngularVelocity, Move, s => s.Orientation = Quaternion.Normalize(Exact(s.w) * s.Orientation), Damp]);
        Assert.That(verdict[Step.Orientation], Is.EqualTo(Mark.Doubtful));
        Assert.That(verdict.Outcome, Is.EqualTo(Outcome.Doubtful));
    }

    /// <summary>A division by |ω|, which is zero before the first torque.</summary>
    [Test]
    public void A_number_that_is_none_is_found_in_the_first_frame()
    {
        Verdict verdict = Judged([Velocity, AngularVelocity, Move, s => s.Add(new Quaternion(s.w / s.w.Length() * (0.5f * H * s.w.Length()), 0) * s.Orientation), Damp]);
        Assert.That(verdict.Findings.Single(), Has.Property("Code").EqualTo("q-not-a-number").And.Property("Since").EqualTo(0));
    }

    /// <summary>Every tensor of a cube is the same in all axes, and the keys' torque keeps its direction.</summary>
    [TestCaseSource(nameof(HiddenByTheCube))]
    public void The_scene_of_the_lab_alone_hides_what_the_box_shows(Action<SheetScript>[] steps, Step step)
    {
        Recording all = Recorded(steps);
        Recording lab = new(all.Runs.Take(1).ToArray(), all.Variables);
        Assert.That(Judge.Decide(lab)[step], Is.EqualTo(Mark.Right));
        Assert.That(Judge.Decide(all)[step], Is.EqualTo(Mark.Wrong));
    }

    private static IEnumerable<TestCaseData> HiddenByTheCube()
    {
        yield return new TestCaseData(new[] { Velocity, NotTurned, Move, Turn, Damp }, Step.AngularVelocity).SetArgDisplayNames("I_ref not turned");
        yield return new TestCaseData(new[] { Velocity, AngularVelocity, Move, OrderOfProduct, Damp }, Step.Orientation).SetArgDisplayNames("order of the product");
    }

    [Test]
    public void A_recording_is_the_same_after_its_way_through_a_stream()
    {
        Recording sent = Recorded(SheetScript.Right);
        using MemoryStream first = new(), second = new();
        sent.WriteTo(first);
        first.Position = 0;
        Recording.ReadFrom(first).WriteTo(second);
        Assert.That(second.ToArray(), Is.EqualTo(first.ToArray()));
    }

    private static Quaternion Exact(Vector3 w) =>
        w == Vector3.Zero ? Quaternion.Identity : Quaternion.CreateFromAxisAngle(Vector3.Normalize(w), H * w.Length());

    private static TestCaseData Steps(string name, params Action<SheetScript>[] steps) => new TestCaseData([steps]).SetArgDisplayNames(name);

    private static TestCaseData Mistake(Step step, string code, Action<SheetScript> mistake) => new TestCaseData(step, code, mistake).SetArgDisplayNames(step.ToString(), code);

    private static Verdict Judged(Action<SheetScript>[] steps) => Judge.Decide(Recorded(steps));

    private static Recording Recorded(Action<SheetScript>[] steps) => Experiments.Record(new PlainLaboratory(() => new SheetScript { Steps = steps }));
}
