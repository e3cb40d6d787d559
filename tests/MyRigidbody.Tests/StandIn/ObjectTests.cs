using NUnit.Framework;
using RigidBodyDynamics.Engine;
using UnityEngine;

namespace RigidBodyDynamics.Tests.StandIn;

/// <summary>The stand-in's objects do what Unity's manual says. The world is one: nothing else runs meanwhile.</summary>
[NonParallelizable]
public sealed class ObjectTests
{
    private Transform _box = null!;

    [SetUp]
    public void Begin()
    {
        World.Begin(isPlaying: true);
        _box = GameObject.CreatePrimitive(PrimitiveType.Cube).transform;
    }

    [TearDown]
    public void End() => World.End();

    [Test]
    public void A_turn_that_is_set_has_length_one_when_it_is_read()
    {
        _box.rotation = new Quaternion(0, 0, 3, 4);
        Assert.That(_box.rotation == new Quaternion(0, 0, 0.6f, 0.8f), Is.True);
        _box.localRotation = new Quaternion(0, 2, 0, 0);
        Assert.That(_box.rotation, Is.EqualTo(new Quaternion(0, 1, 0, 0)));
        _box.rotation = new Quaternion(0, 0, 0, 0);
        Assert.That(_box.rotation, Is.EqualTo(Quaternion.identity));
    }

    [Test]
    public void A_turn_of_length_one_comes_back_bit_by_bit()
    {
        Quaternion q = new Quaternion(1, 2, 3, 4).normalized;
        _box.rotation = q;
        Assert.That(_box.rotation.Equals(q), Is.True);
    }

    [Test]
    public void What_is_no_number_is_refused_with_an_error_and_the_object_stays()
    {
        _box.position = Vector3.one;
        _box.position = new Vector3(float.NaN, 0, 0);
        _box.rotation = new Quaternion(0, float.NaN, 0, 1);
        Assert.That((_box.position, _box.rotation), Is.EqualTo((Vector3.one, Quaternion.identity)));
        Assert.That(UnityConsole.Lines.Select(line => line.Text), Has.Exactly(2).Contains("assign attempt for 'Cube' is not valid"));
    }

    [Test]
    public void Translate_moves_along_the_objects_own_axes_unless_told_otherwise()
    {
        _box.rotation = Quaternion.AngleAxis(90, Vector3.forward);
        _box.Translate(1, 0, 0);
        Assert.That(_box.position == Vector3.up, Is.True);
        _box.Translate(Vector3.right, Space.World);
        Assert.That(_box.position == new Vector3(1, 1, 0), Is.True);
    }

    [Test]
    public void Rotate_counts_in_degrees_about_the_objects_own_axes_unless_told_otherwise()
    {
        Quaternion start = Quaternion.AngleAxis(90, Vector3.forward), turn = Quaternion.AngleAxis(30, Vector3.right);
        _box.rotation = start;
        _box.Rotate(30, 0, 0);
        Assert.That(_box.rotation == start * turn, Is.True);
        _box.rotation = start;
        _box.Rotate(new Vector3(30, 0, 0), Space.World);
        Assert.That(_box.rotation == turn * start, Is.True);
        _box.rotation = start;
        _box.Rotate(Vector3.right, 30);
        Assert.That(_box.rotation == start * turn, Is.True);
    }

    [Test]
    public void Turning_about_a_point_moves_too()
    {
        _box.position = new Vector3(2, 0, 0);
        _box.RotateAround(Vector3.zero, Vector3.forward, 90);
        Assert.That(_box.position == new Vector3(0, 2, 0), Is.True);
        Assert.That(_box.right == Vector3.up, Is.True);
    }

    [Test]
    public void The_axes_of_a_turned_object()
    {
        _box.eulerAngles = new Vector3(0, 90, 0);
        Assert.That((_box.forward == Vector3.right, _box.up == Vector3.up, _box.right == Vector3.back), Is.EqualTo((true, true, true)));
        Assert.That(Vector3.Distance(_box.eulerAngles, new Vector3(0, 90, 0)), Is.LessThan(1e-3));
        Assert.That(_box.TransformDirection(Vector3.forward) == Vector3.right, Is.True);
        Assert.That(_box.InverseTransformDirection(Vector3.right) == Vector3.forward, Is.True);
    }

    [Test]
    public void The_matrix_of_an_object_scales_turns_and_moves()
    {
        _box.position = new Vector3(1, 2, 3);
        _box.rotation = Quaternion.Euler(10, 20, 30);
        _box.localScale = new Vector3(1, 2, 3);
        Assert.That(_box.localToWorldMatrix == Matrix4x4.TRS(_box.position, _box.rotation, _box.localScale), Is.True);
        Assert.That((_box.worldToLocalMatrix * _box.localToWorldMatrix).isIdentity, Is.True);
        Assert.That(_box.InverseTransformPoint(_box.TransformPoint(Vector3.one)) == Vector3.one, Is.True);
    }

    [Test]
    public void A_child_moves_with_its_parent()
    {
        Transform child = new GameObject("child").transform;
        child.SetParent(_box, worldPositionStays: false);
        child.localPosition = Vector3.right;
        _box.SetPositionAndRotation(new Vector3(5, 0, 0), Quaternion.AngleAxis(90, Vector3.forward));
        Assert.That(child.position == new Vector3(5, 1, 0), Is.True);
        Assert.That(child.root, Is.SameAs(_box));
    }

    [Test]
    public void The_cube_has_24_vertices_half_a_metre_from_its_centre()
    {
        Vector3[] vertices = _box.GetComponent<MeshFilter>().mesh.vertices;
        Assert.That(vertices, Has.Length.EqualTo(24));
        Assert.That(vertices.Select(v => (Math.Abs(v.x), Math.Abs(v.y), Math.Abs(v.z))), Is.All.EqualTo((0.5f, 0.5f, 0.5f)));
        Assert.That(vertices.Distinct().Count(), Is.EqualTo(8));
    }

    [Test]
    public void Mesh_is_the_objects_own_copy_and_sharedMesh_is_everybodys()
    {
        MeshFilter one = _box.GetComponent<MeshFilter>(), other = new GameObject().AddComponent<MeshFilter>();
        other.sharedMesh = one.sharedMesh;
        one.mesh.vertices = [Vector3.one];
        Assert.That((one.mesh.vertexCount, other.sharedMesh.vertexCount), Is.EqualTo((1, 24)));
        Assert.That(one.mesh, Is.SameAs(one.mesh).And.SameAs(one.sharedMesh));
        Assert.That(other.sharedMesh.bounds.size, Is.EqualTo(Vector3.one));
    }

    [Test]
    public void Vertices_are_a_copy()
    {
        Mesh mesh = _box.GetComponent<MeshFilter>().mesh;
        mesh.vertices[0] = Vector3.zero;
        Assert.That(mesh.vertices[0], Is.Not.EqualTo(Vector3.zero));
    }

    [Test]
    public void A_part_that_is_not_there_is_null() => Assert.That(_box.GetComponent<Rigidbody>() == null, Is.True);

    [Test]
    public void What_is_destroyed_equals_null()
    {
        UnityEngine.Object.DestroyImmediate(_box.gameObject);
        Assert.That(_box == null, Is.True);
    }

    [TestCase("r", KeyCode.R)]
    [TestCase("left", KeyCode.LeftArrow)]
    [TestCase("up", KeyCode.UpArrow)]
    [TestCase("space", KeyCode.Space)]
    [TestCase("1", KeyCode.Alpha1)]
    public void Keys_are_asked_for_by_code_or_by_name(string name, KeyCode code)
    {
        Assert.That(Input.GetKey(name), Is.False);
        Keys.Hold(code, true);
        Assert.That((Input.GetKey(name), Input.GetKey(code), Input.GetKeyDown(name), Input.anyKey), Is.EqualTo((true, true, true, true)));
        Keys.EndFrame();
        Assert.That((Input.GetKey(code), Input.GetKeyDown(code)), Is.EqualTo((true, false)));
        Keys.Hold(code, false);
        Assert.That((Input.GetKey(code), Input.GetKeyUp(name)), Is.EqualTo((false, true)));
    }

    [Test]
    public void A_key_that_no_keyboard_has_is_refused() => Assert.That(() => Input.GetKey("R!"), Throws.ArgumentException);

    [Test]
    public void Axes_are_the_arrow_keys()
    {
        Keys.Hold(KeyCode.LeftArrow, true);
        Assert.That((Input.GetAxisRaw("Horizontal"), Input.GetAxis("Vertical")), Is.EqualTo((-1f, 0f)));
        Assert.That(() => Input.GetAxis("Sideways"), Throws.ArgumentException);
    }

    [Test]
    public void Time_goes_by_frames()
    {
        Player.Frame(0.025);
        Assert.That((Time.time, Time.deltaTime, Time.fixedDeltaTime, Time.frameCount), Is.EqualTo((0.025f, 0.025f, 0.02f, 1)));
        Player.Frame(0.015);
        Assert.That((Time.time, Time.fixedTime, Time.timeSinceLevelLoad), Is.EqualTo((0.04f, 0.04f, 0.04f)).Within(1e-7));
    }

    [Test]
    public void What_a_script_prints_is_in_the_console()
    {
        MonoBehaviour.print(Vector3.one);
        Debug.LogWarning("warned");
        Debug.DrawRay(Vector3.zero, Vector3.up, Color.red);
        Assert.That(UnityConsole.Lines, Is.EqualTo(new[] { (LogType.Log, "(1.00, 1.00, 1.00)"), (LogType.Warning, "warned") }));
    }

    [Test]
    public void Coroutines_are_refused_with_a_word() =>
        Assert.That(() => _box.gameObject.AddComponent<Script>().StartCoroutine("Go"), Throws.TypeOf<NotSupportedException>().With.Message.Contains("StartCoroutine"));

    [Test]
    public void A_coroutine_is_stopped_by_what_it_was_started_with()
    {
        int steps = 0;
        System.Collections.IEnumerator routine = Count(() => steps++);
        Script script = _box.gameObject.AddComponent<Script>();
        script.StartCoroutine(routine);
        Player.Frame(0.02);
        script.StopCoroutine(Count(() => steps++));
        Player.Frame(0.02);
        script.StopCoroutine(routine);
        Player.Frame(0.02);
        Assert.That(steps, Is.EqualTo(3));
    }

    [Test]
    public void The_main_camera_is_the_first_that_is_switched_on()
    {
        Camera first = new GameObject { tag = "MainCamera" }.AddComponent<Camera>(), second = new GameObject { tag = "MainCamera" }.AddComponent<Camera>();
        Assert.That(Camera.main, Is.SameAs(first));
        first.enabled = false;
        Assert.That(Camera.main, Is.SameAs(second));
        second.gameObject.SetActive(false);
        Assert.That(Camera.main == null, Is.True);
    }

    private static System.Collections.IEnumerator Count(Action step)
    {
        while (true)
        {
            step();
            yield return new WaitForFixedUpdate();
        }
    }

    [Test]
    public void Random_numbers_are_the_same_in_every_world()
    {
        float first = UnityEngine.Random.value;
        World.Begin(isPlaying: true);
        Assert.That(UnityEngine.Random.value, Is.EqualTo(first));
        Assert.That(UnityEngine.Random.Range(3, 4), Is.EqualTo(3));
    }

    private sealed class Script : MonoBehaviour
    {
    }
}
