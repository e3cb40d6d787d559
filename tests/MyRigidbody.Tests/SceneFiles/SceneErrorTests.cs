using NUnit.Framework;
using RigidBodyDynamics.Lab;

namespace RigidBodyDynamics.Tests.SceneFiles;

/// <summary>The message for a mistake in a scene: the place, the requirement, the value.</summary>
public sealed class SceneErrorTests
{
    private const string Head = """{ "schema": "rigid-body-scene/1", "name": "n", "step": 0.1, "steps": 3, "bodies": [ { "name": "b", """;

    [TestCase("", "scene.json: line 1, column 1: ")]
    [TestCase("{", "scene.json: line 1, column 2: ")]
    [TestCase("[]", "scene.json: must be an object { … }, found []")]
    [TestCase("{}", "scene.json: \"schema\" is missing")]
    [TestCase("""{ "schema": "rigid-body-scene/2" }""", "scene.json: schema: must be one of \"rigid-body-scene/1\", \"free-rigid-body/1\", \"lab-script/1\", found \"rigid-body-scene/2\"")]
    [TestCase("""{ "schema": "rigid-body-scene/1", "name": 3 }""", "scene.json: name: must be a text, found 3")]
    [TestCase("""{ "schema": "rigid-body-scene/1", "name": "n", "name": "m" }""", "scene.json: Duplicate property 'name'")]
    [TestCase("""{ "schema": "rigid-body-scene/1", "name": "n", "step": 0.1, "bodies": [] }""", "scene.json: \"duration\" or \"steps\" is missing")]
    [TestCase("""{ "schema": "rigid-body-scene/1", "name": "n", "step": 0, "steps": 1, "bodies": [] }""", "scene.json: step: must be above zero and at most 1e9 s, found 0")]
    [TestCase("""{ "schema": "rigid-body-scene/1", "name": "n", "step": [0.1, -1], "bodies": [] }""", "scene.json: step[1]: must be above zero and at most 1e9 s, found -1")]
    [TestCase("""{ "schema": "rigid-body-scene/1", "name": "n", "step": 1e300, "steps": 1, "bodies": [] }""", "scene.json: step: must be above zero and at most 1e9 s, found 1E+300")]
    [TestCase("""{ "schema": "rigid-body-scene/1", "name": "n", "step": 1e999, "steps": 1, "bodies": [] }""", "scene.json: step: must be a number that fits double precision, found 1e999")]
    [TestCase("""{ "schema": "rigid-body-scene/1", "name": "n", "step": 1, "steps": 1.5, "bodies": [] }""", "scene.json: steps: must be a whole number from 1, found 1.5")]
    [TestCase("""{ "schema": "rigid-body-scene/1", "name": "n", "step": 1, "duration": -2, "bodies": [] }""", "scene.json: duration: must be finite and above zero, found -2")]
    [TestCase("""{ "schema": "rigid-body-scene/1", "name": "n", "step": 1, "steps": 1, "bodies": [] }""", "scene.json: bodies: must have at least one body")]
    [TestCase("""{ "schema": "rigid-body-scene/1", "name": "n", "step": 1, "steps": 1, "bodys": [], "bodies": [] }""", "scene.json: bodys: is not a name known here; known are schema, name, about, $schema, step, duration, steps, bodies")]
    [TestCase(Head + """ }, { "name": "b" } ] }""", "scene.json: bodies[1]: name: must be unique in the scene, found \"b\" again")]
    [TestCase(Head + """ "integrator": "Eulr" } ] }""", "scene.json: bodies[0].integrator: must be one of RULES, found Eulr")]
    [TestCase(Head + """ "mass": 0 } ] }""", "scene.json: bodies[0].mass: must be finite and above zero, found 0")]
    [TestCase(Head + """ "mass": "heavy" } ] }""", "scene.json: bodies[0].mass: must be a number, found \"heavy\"")]
    [TestCase(Head + """ "mass": NaN } ] }""", "scene.json: line 1, column")]
    [TestCase(Head + """ "inertia": { } } ] }""", "scene.json: bodies[0].inertia: must have exactly one of KINDS, found none")]
    [TestCase(Head + """ "inertia": { "cone": 1 } } ] }""", "scene.json: bodies[0].inertia.cone: is not a name known here")]
    [TestCase(Head + """ "inertia": { "compound": [] } } ] }""", "scene.json: bodies[0].inertia.compound: must have at least one part, in body \"b\"")]
    [TestCase(Head + """ "inertia": { "solidBox": [1, 1] } } ] }""", "scene.json: bodies[0].inertia.solidBox: must be three numbers [x, y, z], found [1, 1]")]
    [TestCase(Head + """ "inertia": { "principal": [1, 1, 3] } } ] }""", "scene.json: bodies[0].inertia.principal: no moment can exceed the sum of the other two, and the nearest that do not are (1.3333333333333333, 1.3333333333333333, 2.6666666666666665), found (1, 1, 3), in body \"b\"")]
    [TestCase(Head + """ "inertia": { "principal": [1, -1, 1] } } ] }""", "scene.json: bodies[0].inertia.principal: must have finite components above zero, found (1, -1, 1)")]
    [TestCase(Head + """ "inertia": { "points": [[0, 0, 0], [1, 0, 0]] } } ] }""", "scene.json: bodies[0].inertia.points: all points lie on a line along x, so the inertia about it is zero, found principal moments (0, 0.25, 0.25), in body \"b\"")]
    [TestCase(Head + """ "inertia": { "points": [[0, 0, 0]], "masses": [1, 2] } } ] }""", "scene.json: bodies[0].inertia.masses: must be as many as there are points (1), at least one, found 2")]
    [TestCase(Head + """ "inertia": { "solidCylinder": { "radius": -1, "height": 1 } } } ] }""", "scene.json: bodies[0].inertia.solidCylinder.radius: must be finite and above zero, found -1")]
    [TestCase(Head + """ "inertia": { "solidCylinder": { "radius": 1 } } } ] }""", "scene.json: bodies[0].inertia.solidCylinder: \"height\" is missing")]
    [TestCase(Head + """ "inertia": { "solidCapsule": { "radius": 1, "height": 1, "axis": "w" } } } ] }""", "scene.json: bodies[0].inertia.solidCapsule.axis: must be one of \"x\", \"y\", \"z\", found \"w\"")]
    [TestCase(Head + """ "inertia": { "tensor": { "xx": 1, "yy": 1 } } } ] }""", "scene.json: bodies[0].inertia.tensor: \"zz\" is missing")]
    [TestCase(Head + """ "inertia": { "tensor": { "xx": 1, "yy": 1, "zz": 3 } } } ] }""", "scene.json: bodies[0].inertia.tensor: no moment can exceed the sum of the other two")]
    [TestCase(Head + """ "inertia": { "tensor": { "ixx": 1, "yy": 1, "zz": 1 } } } ] }""", "scene.json: bodies[0].inertia.tensor: \"xx\" is missing")]
    [TestCase(Head + """ "mass": 2, "inertia": { "compound": [{ }] } } ] }""", "scene.json: bodies[0].mass: must not stand beside compound, whose parts say it")]
    [TestCase(Head + """ "centerOfMass": [0, 0, 1], "inertia": { "compound": [{ }] } } ] }""", "scene.json: bodies[0].centerOfMass: must not stand beside compound, which says where it is")]
    [TestCase(Head + """ "centerOfMass": [0, 0, 1], "inertia": { "points": [[0, 0, 0]] } } ] }""", "scene.json: bodies[0].centerOfMass: must not stand beside points, which says where it is")]
    [TestCase(Head + """ "inertia": { "compound": [{ "inertia": { "compound": [{ "mass": -1 }] } }] } } ] }""", "scene.json: bodies[0].inertia.compound[0].inertia.compound[0].mass: must be finite and above zero, found -1")]
    [TestCase(Head + """ "inertia": { "compound": [{ "weight": 1 }] } } ] }""", "scene.json: bodies[0].inertia.compound[0].weight: is not a name known here; known are mass, inertia, centerOfMass, about, position, orientation")]
    [TestCase(Head + """ "about": "origin", "inertia": { "solidBox": [1, 1, 1] } } ] }""", "scene.json: bodies[0].about: is for principal and tensor only; solidBox is about its own centre of mass")]
    [TestCase(Head + """ "about": "pivot", "inertia": { "principal": [1, 1, 1] } } ] }""", "scene.json: bodies[0].about: must be one of \"centerOfMass\", \"origin\", found \"pivot\"")]
    [TestCase(Head + """ "about": "origin" } ] }""", "scene.json: bodies[0].about: is for principal and tensor only, and no inertia is given here")]
    [TestCase(Head + """ "orientation": [0, 0, 0, 0] } ] }""", "scene.json: bodies[0].orientation: must be a quaternion")]
    [TestCase(Head + """ "velocity": [1, 0, 0], "canMove": false } ] }""", "scene.json: bodies[0].velocity: must be zero along the locked x, y and z, found (1, 0, 0)")]
    [TestCase(Head + """ "angularVelocity": [0, 2, 1], "lock": { "turn": "xz" } } ] }""", "scene.json: bodies[0].angularVelocity: must be zero about the locked x and z, found (0, 2, 1)")]
    [TestCase(Head + """ "lock": { "move": "zx" } } ] }""", "scene.json: bodies[0].lock.move: must be one of \"\", \"x\", \"y\", \"xy\", \"z\", \"xz\", \"yz\", \"xyz\", found \"zx\"")]
    [TestCase(Head + """ "canTurn": 1 } ] }""", "scene.json: bodies[0].canTurn: must be true or false, found 1")]
    [TestCase(Head + """ "unity": { } } ] }""", "scene.json: bodies[0].unity: is for UnityRigidbody only, and this body moves by Exact")]
    [TestCase(Head + """ "integrator": "UnityRigidbody", "unity": { "drag": -1 } } ] }""", "scene.json: bodies[0].unity.drag: must be finite and not below zero, found -1")]
    [TestCase(Head + """ "effects": [ { "gravity": [0, 1, 0], "force": [0, 1, 0] } ] } ] }""", "scene.json: bodies[0].effects[0]: must have exactly one effect, found gravity, force; effects are gravity, ")]
    [TestCase(Head + """ "effects": [ { "from": 1 } ] } ] }""", "scene.json: bodies[0].effects[0]: must have exactly one effect, found none")]
    [TestCase(Head + """ "effects": [ { "wind": 1 } ] } ] }""", "scene.json: bodies[0].effects[0].wind: is not an effect; effects are gravity, ")]
    [TestCase(Head + """ "effects": [ { "x.force": [1, 0, 0] } ] } ] }""", "scene.json: bodies[0].effects[0].x.force: is not an effect")]
    [TestCase(Head + """ "effects": [ { "gravity": [0, 1, 0], "from": "soon" } ] } ] }""", "scene.json: bodies[0].effects[0].from: must be a number, found \"soon\"")]
    [TestCase(Head + """ "effects": [ { "gravity": [0, 1, 0], "from": 2, "to": 1 } ] } ] }""", "scene.json: bodies[0].effects[0].to: must be later than from, found 1")]
    [TestCase(Head + """ "effects": [ { "key": "Space" } ] } ] }""", "scene.json: bodies[0].effects[0].key: must be one of \"LeftArrow\", \"RightArrow\", \"UpArrow\", \"DownArrow\", \"R\", found \"Space\"")]
    [TestCase(Head + """ "effects": [ { "linearDamping": -1 } ] } ] }""", "scene.json: bodies[0].effects[0].linearDamping: must be finite and not below zero, found -1")]
    [TestCase(Head + """ "effects": [ { "decayPerStep": { "linear": 1.5 } } ] } ] }""", "scene.json: bodies[0].effects[0].decayPerStep.linear: must be a factor from 0 to 1, found 1.5")]
    [TestCase(Head + """ "effects": [ { "heavyTop": { "axis": [0, 0, 0], "moment": 1, "up": [0, 1, 0] } } ] } ] }""", "scene.json: bodies[0].effects[0].heavyTop: must be finite and above zero, found 0")]
    [TestCase(Head + """ "effects": [ { "perStep": { }, "from": 1 } ] } ] }""", "scene.json: bodies[0].effects[0].from: must not stand beside perStep")]
    [TestCase(Head + """ "a\nb": 1 } ] }""", "scene.json: bodies[0].a b: is not a name known here")]
    [TestCase(Head + """ "integrator": "\ud800" } ] }""", "scene.json: has a name or text that is not valid Unicode")]
    public void The_error_names_place_requirement_and_value(string text, string expected)
    {
        string error = SceneText.Error(text);

        Assert.That(error, Does.StartWith(expected
            .Replace("RULES", string.Join(", ", Rules.All.Select(rule => rule.Name)), StringComparison.Ordinal)
            .Replace("KINDS", string.Join(", ", InertiaReader.Names), StringComparison.Ordinal)));
        Assert.That(error, Does.Not.Contain("\n"));
    }

    [Test]
    public void Mass_that_is_not_the_sum_of_the_masses_is_refused()
    {
        string text = Head + """ "mass": 3, "inertia": { "points": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "masses": [1, 2, 3] } } ] }""";

        Assert.That(SceneText.Error(text), Is.EqualTo("scene.json: bodies[0].mass: must be the sum of the masses, 6, found 3, in body \"b\""));
    }
}
