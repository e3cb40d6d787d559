using NUnit.Framework;
using RigidBodyDynamics.Engine;
using UnityEngine;

namespace RigidBodyDynamics.Tests.StandIn;

/// <summary>The stand-in's Rigidbody takes pushes and poses as Unity's manual says. The world is one: nothing else runs meanwhile.</summary>
[NonParallelizable]
public sealed class PhysicsTests
{
    private const float Step = 0.02f, Mass = 4;

    private Rigidbody _body = null!;

    [SetUp]
    public void Begin()
    {
        World.Begin(isPlaying: true);
        GameObject box = GameObject.CreatePrimitive(PrimitiveType.Cube);
        box.transform.position = new Vector3(1, 2, 3);
        _body = box.AddComponent<Rigidbody>();
        _body.mass = Mass;
        _body.drag = _body.angularDrag = 0;
        _body.useGravity = false;
        Physics.simulationMode = SimulationMode.Script;
    }

    [TearDown]
    public void End() => World.End();

    [TestCase(ForceMode.Force, Step / Mass)]
    [TestCase(ForceMode.Acceleration, Step)]
    [TestCase(ForceMode.Impulse, 1 / Mass)]
    [TestCase(ForceMode.VelocityChange, 1)]
    public void A_push_acts_in_the_next_step_and_once(ForceMode mode, float gained)
    {
        _body.AddForce(new Vector3(8, 0, -4), mode);
        Assert.That(_body.velocity, Is.EqualTo(Vector3.zero));
        Physics.Simulate(Step);
        Vector3 first = _body.velocity;
        Physics.Simulate(Step);

        Assert.That((first - gained * new Vector3(8, 0, -4)).magnitude, Is.LessThan(1e-6)); // measured 0
        Assert.That(_body.velocity, Is.EqualTo(first));
    }

    [TestCase(0.01f)]
    [TestCase(0.04f)]
    public void An_impulse_gives_the_same_velocity_in_a_step_of_any_length(float step)
    {
        _body.AddForce(new Vector3(8, 0, 0), ForceMode.Impulse);
        Physics.Simulate(step);
        Assert.That(_body.velocity.x, Is.EqualTo(2).Within(1e-6)); // measured 0
    }

    [Test]
    public void A_torque_is_divided_by_the_moment_about_its_axis()
    {
        _body.inertiaTensor = new Vector3(2, 3, 4);
        _body.AddTorque(new Vector3(0, 1, 0));
        Physics.Simulate(Step);
        Assert.That((_body.angularVelocity - new Vector3(0, Step / 3, 0)).magnitude, Is.LessThan(1e-8)); // measured 4.7e-10
    }

    [Test]
    public void A_frozen_body_moves_and_turns_along_the_rest_and_shows_zeros()
    {
        _body.inertiaTensor = new Vector3(2, 3, 4);
        _body.constraints = RigidbodyConstraints.FreezePositionX | RigidbodyConstraints.FreezeRotationX | RigidbodyConstraints.FreezeRotationZ;
        _body.AddForce(new Vector3(Mass, Mass, 0), ForceMode.Impulse);
        _body.AddTorque(new Vector3(1, 1, 1));
        Physics.Simulate(Step);

        Assert.That(_body.inertiaTensor, Is.EqualTo(new Vector3(0, 3, 0)));
        Assert.That((_body.velocity - Vector3.up).magnitude, Is.LessThan(1e-6)); // measured 0
        Assert.That((_body.angularVelocity - new Vector3(0, Step / 3, 0)).magnitude, Is.LessThan(1e-8)); // measured 4.7e-10
        _body.freezeRotation = true;
        Assert.That(_body.constraints, Is.EqualTo(RigidbodyConstraints.FreezePositionX | RigidbodyConstraints.FreezeRotation));
        _body.freezeRotation = false;
        Assert.That((_body.freezeRotation, _body.inertiaTensor), Is.EqualTo((false, new Vector3(2, 3, 4))));
    }

    [Test]
    public void Relative_pushes_are_along_the_axes_of_the_body()
    {
        _body.rotation = Quaternion.AngleAxis(90, Vector3.forward);
        _body.AddRelativeForce(new Vector3(Mass / Step, 0, 0));
        _body.AddRelativeTorque(new Vector3(1, 0, 0));
        Physics.Simulate(Step);
        Assert.That((_body.velocity - Vector3.up).magnitude, Is.LessThan(1e-6)); // measured 0
        Assert.That(_body.angularVelocity.normalized == Vector3.up, Is.True);
    }

    [Test]
    public void The_object_goes_to_a_place_that_is_set_with_the_next_step()
    {
        _body.MovePosition(new Vector3(7, 0, 0));
        _body.MoveRotation(Quaternion.AngleAxis(90, Vector3.up));
        Assert.That((_body.position, _body.transform.position), Is.EqualTo((new Vector3(7, 0, 0), new Vector3(1, 2, 3))));
        Physics.Simulate(Step);
        Assert.That(_body.transform.position, Is.EqualTo(new Vector3(7, 0, 0)));
        Assert.That(_body.transform.rotation == Quaternion.AngleAxis(90, Vector3.up), Is.True);
    }

    [Test]
    public void A_body_falls_by_the_worlds_gravity_unless_told_otherwise()
    {
        _body.useGravity = true;
        Assert.That(Physics.gravity, Is.EqualTo(new Vector3(0, -9.81f, 0)));
        Physics.Simulate(Step);
        Assert.That(_body.velocity.y, Is.EqualTo(-9.81f * Step).Within(1e-7)); // measured 0
    }

    [Test]
    public void Drag_takes_its_share_of_a_second_in_every_step()
    {
        _body.drag = 0.5f;
        _body.velocity = Vector3.right;
        Physics.Simulate(Step);
        Assert.That(_body.velocity.x, Is.EqualTo(1 - 0.5f * Step).Within(1e-6)); // measured 0
    }

    [Test]
    public void A_turn_is_no_faster_than_its_limit()
    {
        Assert.That(_body.maxAngularVelocity, Is.EqualTo(7));
        _body.AddTorque(new Vector3(0, 1e6f, 0));
        Physics.Simulate(Step);
        Assert.That(_body.angularVelocity.magnitude, Is.EqualTo(7).Within(1e-5)); // measured 0
    }

    [Test]
    public void Moments_and_centre_are_those_of_the_collider_until_a_script_sets_others()
    {
        _body.transform.localScale = new Vector3(1, 2, 3);
        Vector3 solid = Mass / 12 * new Vector3(4 + 9, 1 + 9, 1 + 4);
        Assert.That((_body.inertiaTensor - solid).magnitude, Is.LessThan(1e-5)); // measured 0
        Assert.That(_body.centerOfMass, Is.EqualTo(Vector3.zero));
        _body.inertiaTensor = Vector3.one;
        Assert.That(_body.inertiaTensor, Is.EqualTo(Vector3.one));
        _body.ResetInertiaTensor();
        Assert.That((_body.inertiaTensor - solid).magnitude, Is.LessThan(1e-5));
    }

    [Test]
    public void A_body_that_was_put_to_sleep_rests_until_it_is_woken()
    {
        _body.velocity = Vector3.right;
        _body.Sleep();
        Assert.That((_body.IsSleeping(), _body.velocity), Is.EqualTo((true, Vector3.zero)));
        _body.useGravity = true;
        Physics.Simulate(Step);
        Assert.That(_body.transform.position, Is.EqualTo(new Vector3(1, 2, 3)));
        _body.WakeUp();
        Physics.Simulate(Step);
        Assert.That(_body.velocity.y, Is.LessThan(0));
    }

    [Test]
    public void A_push_wakes_a_body_that_sleeps()
    {
        _body.Sleep();
        _body.AddForce(new Vector3(Mass / Step, 0, 0));
        Physics.Simulate(Step);
        Assert.That(_body.velocity.x, Is.EqualTo(1).Within(1e-6)); // measured 0
    }

    [Test]
    public void What_pushes_a_body_that_is_kinematic_or_not_active_has_no_effect()
    {
        _body.isKinematic = true;
        _body.AddForce(Vector3.right, ForceMode.Impulse);
        _body.AddTorque(Vector3.up);
        _body.isKinematic = false;
        _body.gameObject.SetActive(false);
        _body.AddForce(Vector3.right);
        _body.AddRelativeTorque(Vector3.up);
        _body.gameObject.SetActive(true);
        _body.AddForce(Vector3.right);
        _body.isKinematic = true;
        Physics.Simulate(Step);
        _body.isKinematic = false;
        Physics.Simulate(Step);
        Assert.That((_body.velocity, _body.angularVelocity, _body.transform.position), Is.EqualTo((Vector3.zero, Vector3.zero, new Vector3(1, 2, 3))));
    }

    [Test]
    public void A_script_may_step_only_where_the_engine_does_not()
    {
        Physics.simulationMode = SimulationMode.FixedUpdate;
        _body.velocity = Vector3.right;
        Physics.Simulate(Step);
        Assert.That(_body.transform.position, Is.EqualTo(new Vector3(1, 2, 3)));
        Assert.That(UnityConsole.Lines.Select(line => line.Text), Has.Exactly(1).Contains("simulation mode is not set to Script"));
    }
}
