using NUnit.Framework;
using RigidBodyDynamics.Engine;
using UnityEngine;
using Random = UnityEngine.Random;

namespace RigidBodyDynamics.Tests.StandIn;

/// <summary>Colours, boxes, chance and the camera as Unity's manual has them. The world is one: nothing else runs meanwhile.</summary>
[NonParallelizable]
public sealed class ValueTests
{
    [SetUp]
    public void Begin() => World.Begin(isPlaying: true);

    [TearDown]
    public void End() => World.End();

    [Test]
    public void Colours_between_two_end_at_both()
    {
        Assert.That(Color.Lerp(Color.black, Color.white, 0.25f), Is.EqualTo(new Color(0.25f, 0.25f, 0.25f, 1)));
        Assert.That(Color.Lerp(Color.red, Color.blue, -1), Is.EqualTo(Color.red));
        Assert.That(Color.Lerp(Color.red, Color.blue, 2), Is.EqualTo(Color.blue));
        Assert.That((Color.grey, Color.clear.a, Color.yellow.r), Is.EqualTo((new Color(0.5f, 0.5f, 0.5f), 0f, 1f)));
        Assert.That(Color.yellow.g, Is.EqualTo(0.92).Within(0.002)); // measured 1.6e-3; the manual has two digits
    }

    [Test]
    public void Extents_are_half_of_the_size()
    {
        Bounds bounds = new(new Vector3(1, 2, 3), new Vector3(2, 4, 6));
        Assert.That((bounds.extents, bounds.min, bounds.max), Is.EqualTo((new Vector3(1, 2, 3), Vector3.zero, new Vector3(2, 4, 6))));
        bounds.size = Vector3.one;
        Assert.That((bounds.center, bounds.extents), Is.EqualTo((new Vector3(1, 2, 3), new Vector3(0.5f, 0.5f, 0.5f))));
    }

    [Test]
    public void Whole_numbers_by_chance_leave_out_the_upper_end()
    {
        int[] drawn = [.. Enumerable.Range(0, 300).Select(_ => Random.Range(-1, 2))];
        Assert.That(drawn.Distinct(), Is.EquivalentTo(new[] { -1, 0, 1 }));
        Assert.That(Enumerable.Range(0, 300).Select(_ => Random.Range(-1f, 2f)), Is.All.InRange(-1f, 2f));
    }

    [Test]
    public void Directions_and_turns_by_chance_have_length_one()
    {
        for (int i = 0; i < 100; i++)
        {
            Quaternion turn = Random.rotation;
            Assert.That(Random.onUnitSphere.magnitude, Is.EqualTo(1).Within(1e-6)); // measured 1.2e-7
            Assert.That(Random.insideUnitSphere.magnitude, Is.LessThanOrEqualTo(1));
            Assert.That(Quaternion.Dot(turn, turn), Is.EqualTo(1).Within(1e-6)); // measured 2.4e-7
        }
    }

    [Test]
    public void The_same_seed_gives_the_same_numbers()
    {
        Random.InitState(7);
        float first = Random.value;
        Random.InitState(7);
        Assert.That(Random.value, Is.EqualTo(first));
    }

    [Test]
    public void The_camera_sees_what_is_ahead_in_the_middle_and_half_its_field_of_view_at_the_upper_edge()
    {
        GameObject holder = new("camera") { tag = "MainCamera" };
        Camera camera = holder.AddComponent<Camera>();
        holder.transform.position = new Vector3(0, 1, -10);
        float up = 10 * Mathf.Tan(0.5f * camera.fieldOfView * Mathf.Deg2Rad);

        Assert.That(Camera.main, Is.SameAs(camera));
        Assert.That(camera.WorldToScreenPoint(new Vector3(0, 1, 0)), Is.EqualTo(new Vector3(0.5f * Screen.width, 0.5f * Screen.height, 10)));
        Assert.That(camera.WorldToScreenPoint(new Vector3(0, 1 + up, 0)).y, Is.EqualTo(Screen.height).Within(1e-3)); // measured 6e-5
    }
}
